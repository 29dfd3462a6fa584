#include "io/json/calibration_json.h"

#include <gtest/gtest.h>

#include "io/json/dimensions_json.h"

namespace coapt {
namespace {

constexpr const char* kFile = R"({
  "schema": "coapt.calibration/1",
  "dimensions": {"ap_mm": 26, "strut_slack": 0.9},
  "valves": {"normal": {"kind": "healthy"},
             "sick": {"kind": "functional",
                      "remodelling": {"anterolateral_mm": [1, 2, 3], "posteromedial_mm": [1, 2, 3]}}},
  "unknowns": [{"at": ["/dimensions/strut_slack"], "low": 0.8, "high": 1.2},
               {"at": ["/valves/sick/remodelling/anterolateral_mm/0",
                       "/valves/sick/remodelling/posteromedial_mm/0"], "low": 0, "high": 6}],
  "targets": [{"valve": "normal", "quantity": "tenting_area"},
              {"valve": "sick", "quantity": "strut", "low": 1, "high": 2, "scale": 0.1, "weight": 3}]
})";

TEST(Calibration, StartsWhereItsFileStandsAndSetsAllPlacesOfAnUnknown) {
  const Expected<CalibrationFile> file = read_calibration(kFile);
  ASSERT_TRUE(file);
  const CalibrationProblem& problem = file->problem;
  ASSERT_EQ(problem.unknowns.size(), 2u);
  EXPECT_EQ(problem.unknowns[0].start, 0.9);
  EXPECT_EQ(problem.unknowns[1].start, 1.0);
  const CalibrationValves valves = *problem.valves_at({1.1, 5.0});
  EXPECT_EQ(valves.dimensions.ap_mm, 26.0);
  EXPECT_EQ(valves.dimensions.slack.strut, 1.1);
  ASSERT_EQ(valves.valves.size(), 2u);
  EXPECT_FALSE(valves.valves[0].change);
  EXPECT_EQ(valves.valves[1].change->anterolateral_mm, Vec3(5, 2, 3));
  EXPECT_EQ(valves.valves[1].change->posteromedial_mm, Vec3(5, 2, 3));
  EXPECT_FALSE(problem.valves_at({9.0, 5.0}));
}

TEST(Calibration, TakesThePublishedRangeWhereATargetSaysNoBand) {
  const Expected<CalibrationFile> file = read_calibration(kFile);
  ASSERT_TRUE(file);
  const CalibrationBand &area = file->problem.bands[0], &strut = file->problem.bands[1];
  EXPECT_EQ(area.low, 60.0);
  EXPECT_EQ(area.high, 200.0);
  EXPECT_EQ(area.scale, 35.0);
  EXPECT_EQ(strut.valve, 1);
  EXPECT_EQ(strut.scale, 0.1);
  EXPECT_EQ(strut.weight, 3.0);
}

TEST(Calibration, ListsEveryProblemWithItsPlace) {
  const Expected<CalibrationFile> file = read_calibration(R"({
    "schema": "coapt.calibration/1",
    "dimensions": {"ap_mm": 1000, "surprise": 1},
    "valves": {"normal": {"kind": "well"}, "sick": {"kind": "functional"}},
    "unknowns": [{"at": ["/dimensions/nothing"], "low": 0, "high": 1},
                 {"at": ["/dimensions/ap_mm"], "low": 20, "high": 30}],
    "targets": [{"valve": "nobody", "quantity": "leak"},
                {"valve": "sick", "quantity": "strut"},
                {"valve": "sick", "quantity": "leak", "scale": 0},
                {"valve": "sick", "quantity": "leek"}]})");
  ASSERT_FALSE(file);
  std::vector<std::string> paths;
  for (const Error& error : file.errors()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/dimensions/ap_mm", "/dimensions/surprise",
                                             "/valves/normal/kind", "/unknowns/0/at/0",
                                             "/unknowns/1", "/targets/0/valve", "/targets/1",
                                             "/targets/2", "/targets/3/quantity"}));
}

TEST(Calibration, HasNamesOfValvesThatFilesCanHave) {
  for (const char* name : {"../well", "result", "a b"}) {
    std::string text = kFile;
    for (std::size_t at; (at = text.find("\"normal\"")) != std::string::npos;)
      text.replace(at, 8, '"' + std::string(name) + '"');
    EXPECT_FALSE(read_calibration(text)) << name;
  }
}

TEST(Calibration, NamesABoundThatNoValveCanTake) {
  std::string text = kFile;
  text.replace(text.find("\"low\": 0.8"), 10, "\"low\": 0.1");
  const Expected<CalibrationFile> file = read_calibration(text);
  ASSERT_FALSE(file);
  ASSERT_EQ(file.errors().size(), 1u);
  EXPECT_EQ(file.errors()[0].path, "/unknowns/0/low");
  EXPECT_NE(file.errors()[0].message.find("from 0.6 to 2"), std::string::npos);
}

TEST(Dimensions, AreReadAsTheyAreWritten) {
  const CalibrationValves valves = *read_calibration(kFile)->problem.valves_at({1.1, 5.0});
  const Expected<HumanValve> read = read_dimensions(calibrated_dimensions(valves, 1));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->dimensions.name, "sick");
  EXPECT_EQ(read->dimensions.ap_mm, 26.0);
  EXPECT_EQ(read->dimensions.slack, valves.dimensions.slack);
  ASSERT_TRUE(read->change);
  EXPECT_EQ(read->change->anterolateral_mm, Vec3(5, 2, 3));
  EXPECT_EQ(write_dimensions(*read), calibrated_dimensions(valves, 1));
}

TEST(Dimensions, NameWhatIsOutsideItsRangeAndWhatIsAccepted) {
  const Expected<HumanValve> read = read_dimensions(
      R"({"schema": "coapt.dimensions/1", "dimensions": {"strut_slack": 3, "radial_extension": 2},
          "remodelling": {"ap_dilation_percent": 500, "ruptured": ["P4"]}})");
  ASSERT_FALSE(read);
  std::map<std::string, std::string> problems;
  for (const Error& error : read.errors()) problems[error.path] = error.message;
  EXPECT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems["/dimensions/strut_slack"], "is 3, must be from 0.6 to 2");
  EXPECT_EQ(problems["/dimensions/radial_extension"], "is 2, must be from 0 to 0.4");
  EXPECT_EQ(problems["/remodelling/ap_dilation_percent"], "is 500, must be from -50 to 100");
  EXPECT_TRUE(problems.contains("/remodelling/ruptured/0"));
}

}  // namespace
}  // namespace coapt
