#include "io/exchange/placed_valve.h"

#include <gtest/gtest.h>

#include "core/valve/patient_frame.h"
#include "io/exchange/formats.h"
#include "io/exchange/markups.h"
#include "io/mesh/vtk.h"
#include "still_valve.h"

namespace coapt {
namespace {

/// A quarter turn about x, and a scanner's origin.
PatientFrame beside_scanner() {
  PatientFrame frame;
  frame.axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  frame.origin_mm = Vec3(10.0, -20.0, 130.0);
  return frame;
}

ClosedValve imaged_valve() {
  ClosedValve closed = still_valve();
  closed.valve.patient = beside_scanner();
  closed.repair.annulus_before_mm = closed.valve.annulus_mm;
  closed.repair.sutures = {{Side::Anterolateral, Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)}};
  return closed;
}

Vec3 in_images(const Vec3& own) { return Vec3(own.x() + 10.0, -own.z() - 20.0, own.y() + 130.0); }

TEST(PlacedValve, LiesWhereTheImagesShowIt) {
  const ClosedValve closed = imaged_valve(), placed = in_patient_frame(closed);
  EXPECT_TRUE(lies_in_patient_frame(placed.valve));
  EXPECT_FALSE(lies_in_patient_frame(closed.valve));
  for (Eigen::Index v = 0; v < closed.valve.rest_mm.rows(); ++v) {
    EXPECT_EQ(Vec3(placed.valve.rest_mm.row(v)), in_images(closed.valve.rest_mm.row(v)));
    EXPECT_EQ(Vec3(placed.closure.closed_mm.row(v)), in_images(closed.closure.closed_mm.row(v)));
  }
  EXPECT_EQ(placed.valve.heads[1].tip_mm, in_images(closed.valve.heads[1].tip_mm));
  EXPECT_EQ(Vec3(placed.closure.branch_points_mm[0].row(0)),
            in_images(closed.closure.branch_points_mm[0].row(0)));
  EXPECT_EQ(Vec3(placed.repair.annulus_before_mm.row(3)),
            in_images(closed.repair.annulus_before_mm.row(3)));
  EXPECT_EQ(placed.repair.sutures[0].anchor_mm, in_images(Vec3(7, 8, 9)));
  EXPECT_EQ(placed.measure.leak.area_mm2, closed.measure.leak.area_mm2);
}

TEST(PlacedValve, OfUnknownImagesStaysWhereItIs) {
  const ClosedValve closed = still_valve(), placed = in_patient_frame(closed);
  EXPECT_EQ(placed.valve.rest_mm, closed.valve.rest_mm);
  EXPECT_FALSE(placed.valve.patient);
}

TEST(PlacedValve, FilesAreWrittenThereUnlessTheValvesOwnAxesAreAskedFor) {
  const ClosedValve closed = imaged_valve();
  const FileFormat& vtk = *format_named("vtk");
  const VtkPolyData there = *read_vtk(*write_valve_file(closed, vtk));
  EXPECT_EQ(there.title, kPatientVtkTitle);
  EXPECT_NEAR((Vec3(there.points_mm.row(7)) - in_images(closed.closure.closed_mm.row(7))).norm(),
              0.0, 1e-6);
  const VtkPolyData own =
      *read_vtk(*write_valve_file(closed, vtk, {.open = false, .frame = ExportFrame::Valve}));
  EXPECT_EQ(own.title, kVtkTitle);
  EXPECT_NEAR((own.points_mm.row(7) - closed.closure.closed_mm.row(7)).norm(), 0.0, 1e-6);
  EXPECT_EQ(there.faces, own.faces);
}

TEST(PlacedValve, EveryFormatIsTheSameValveElsewhere) {
  const ClosedValve closed = imaged_valve();
  for (const FileFormat& format : file_formats())
    EXPECT_TRUE(write_valve_file(closed, format)) << format.name;
  const std::string csv = *write_valve_file(closed, *format_named("csv"));
  EXPECT_EQ(csv.size(), write_valve_file(still_valve(), *format_named("csv"))->size());
  const std::vector<Markup> markups =
      *read_markups(*write_valve_file(closed, *format_named("mrk.json")));
  EXPECT_EQ(Vec3(markups[0].points_mm.row(0)), in_images(closed.valve.annulus_mm.row(0)));
  const std::vector<NamedFile> folder = *write_slicerheart(closed);
  for (const NamedFile& file : folder)
    if (file.name == "annulus.mrk.json") {
      EXPECT_NE(file.bytes.find("of the patient's images"), std::string::npos);
    }
}

}  // namespace
}  // namespace coapt
