#include "io/exchange/formats.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/closure/standing.h"
#include "still_valve.h"

namespace coapt {
namespace {

TEST(Formats, AreToldByTheEndOfAPath) {
  EXPECT_STREQ(format_of_path("a/b.GLB")->name, "glb");
  EXPECT_STREQ(format_of_path("x.mrk.json")->name, "mrk.json");
  EXPECT_EQ(format_of_path("x.json"), nullptr);
  EXPECT_EQ(format_of_path("glb"), nullptr);
  EXPECT_EQ(format_named("xyz"), nullptr);
}

TEST(Formats, EachIsWrittenOfTheClosedValveAndOfTheOpenOneButMeasurements) {
  const ClosedValve exported = still_valve();
  for (const FileFormat& format : file_formats()) {
    EXPECT_TRUE(write_valve_file(exported, format)) << format.name;
    const bool open = bool(write_valve_file(exported, format, {.open = true}));
    EXPECT_EQ(open, std::string_view(format.name) != "csv") << format.name;
  }
}

TEST(Formats, WhatIsNotToBeTrustedSaysSoInEachOfThem) {
  ClosedValve exported = still_valve();
  const std::string doubt = "UNRELIABLE: not converged, leaflets cross";
  const auto says_it = [&](const FileFormat& format, const ExportOptions& options) {
    const Expected<std::string> bytes = write_valve_file(exported, format, options);
    return bytes && bytes->find(doubt) != std::string::npos;
  };
  for (const FileFormat& format : file_formats()) EXPECT_FALSE(says_it(format, {})) << format.name;
  exported.closure.status = ClosureStatus::StepLimit;
  exported.closure.crossing = true;
  EXPECT_EQ(doubt_about(exported.closure), doubt);
  for (const FileFormat& format : file_formats()) {
    if (std::string_view(format.name) == "nii.gz") continue;  // .nii, compressed
    const bool is_of_the_closure = std::string_view(format.name) != "feb";
    EXPECT_EQ(says_it(format, {}), is_of_the_closure) << format.name;
    EXPECT_FALSE(says_it(format, {.open = true})) << format.name << ", the open valve";
  }
  const std::string csv = *write_valve_file(exported, *format_named("csv"));
  EXPECT_TRUE(
      csv.starts_with("Metric,Value,Unit,Definition,Error\nClosure,,,\"" + doubt + "\",\n"));
  const std::string stl = *write_valve_file(exported, *format_named("stl"));
  EXPECT_LT(stl.find(doubt), 80u - doubt.size()) << "in the header";
  const std::vector<NamedFile> folder = *write_slicerheart(exported);
  for (const NamedFile& file : folder)
    EXPECT_NE(file.bytes.find(doubt), std::string::npos) << file.name;
}

TEST(Formats, LoseTiesWhereTheyNeitherHoldNorDrawThem) {
  std::string losing;
  for (const FileFormat& format : file_formats())
    if (format.loses_ties) losing += std::string(format.name) + ' ';
  EXPECT_EQ(losing, "vtk ply obj stl nrrd nii nii.gz ");
}

TEST(Formats, AClosureThatFlewApartHasNoClosedShape) {
  ClosedValve exported = still_valve();
  exported.closure.closed_mm(3, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const FileFormat& format : file_formats()) {
    const Expected<std::string> bytes = write_valve_file(exported, format);
    ASSERT_FALSE(bytes) << format.name;
    EXPECT_EQ(bytes.errors()[0].code, ErrorCode::BadGeometry);
  }
  EXPECT_FALSE(write_slicerheart(exported));
  EXPECT_TRUE(write_slicerheart(exported, {.open = true}));
}

TEST(Formats, MeasurementsOfAnEllipseAreItsOwn) {
  const Expected<std::string> csv = write_valve_file(still_valve(), *format_named("csv"));
  ASSERT_TRUE(csv);
  for (const char* row :
       {"Metric,Value,Unit,Definition,Error\n", "\nA-P distance,28.0,mm,,\n",
        "\nAL-PM distance,36.0,mm,,\n", "\nALC-PMC distance,36.0,mm,,\n",
        "\nSphericity index (A-P / AL-PM),0.78,mm/mm,,\n", "\nAnnulus height,0.0,mm,,\n"})
    EXPECT_NE(csv->find(row), std::string::npos) << row << *csv;
}

}  // namespace
}  // namespace coapt
