#include "io/exchange/valve_vtk.h"

#include <gtest/gtest.h>

#include "still_valve.h"

namespace coapt {
namespace {

const VtkScalars& named(const std::vector<VtkScalars>& all, const std::string& name) {
  for (const VtkScalars& scalars : all)
    if (scalars.name == name) return scalars;
  ADD_FAILURE() << "no " << name;
  return all.front();
}

TEST(ValveVtk, FacesCarrySegmentLeafletAndNoStrainWhereNothingMoved) {
  const ClosedValve exported = still_valve();
  const VtkPolyData data = leaflets_vtk(exported, closed_shape(exported));
  EXPECT_EQ(data.faces, exported.valve.faces);
  EXPECT_EQ(named(data.face_data, "segment").values.front(), 2.0);  // A3
  EXPECT_EQ(named(data.face_data, "segment").values.back(), 5.0);   // P3
  EXPECT_EQ(named(data.face_data, "leaflet").values.front(), 0.0);
  EXPECT_EQ(named(data.face_data, "leaflet").values.back(), 1.0);
  for (const char* name : {"strain_circumferential", "strain_radial"})
    for (const double strain : named(data.face_data, name).values) EXPECT_NEAR(strain, 0.0, 1e-12);
}

TEST(ValveVtk, HeightsAreOverTheAnnularPlane) {
  const ClosedValve exported = still_valve();
  const VtkPolyData data = leaflets_vtk(exported, closed_shape(exported));
  for (int vertex = 0; vertex < 24; ++vertex)  // the annulus lies in z = 0
    EXPECT_NEAR(data.point_data[0].values[static_cast<std::size_t>(vertex)],
                exported.valve.rest_mm(vertex, 2), 1e-9);
}

TEST(ValveVtk, ALeafletHasItsFacesAndTheirVerticesAlone) {
  const ClosedValve exported = still_valve();
  const ValveShape shape = closed_shape(exported);
  const VtkPolyData anterior = leaflet_vtk(exported, shape, Leaflet::Anterior);
  const VtkPolyData posterior = leaflet_vtk(exported, shape, Leaflet::Posterior);
  EXPECT_EQ(anterior.faces.rows() + posterior.faces.rows(), 32);
  EXPECT_EQ(anterior.points_mm.rows(), 15);  // five columns of three
  EXPECT_EQ(anterior.faces.maxCoeff(), 14);
  EXPECT_EQ(anterior.face_data[0].values.size(), static_cast<std::size_t>(anterior.faces.rows()));
  // The same triangle, whatever its vertices are called.
  EXPECT_EQ(anterior.points_mm.row(anterior.faces(0, 0)),
            exported.valve.rest_mm.row(exported.valve.faces(0, 0)));
}

TEST(ValveVtk, ChordaeLeadFromTheHeadOverTheBranchPointToVertices) {
  const ClosedValve exported = still_valve();
  const VtkPolyData data = chordae_vtk(exported, closed_shape(exported));
  EXPECT_EQ(data.lines, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {1, 3}, {4, 5}}));
  EXPECT_EQ(Vec3(data.points_mm.row(0)), exported.valve.heads[0].tip_mm);
  EXPECT_EQ(data.points_mm.row(5), exported.valve.rest_mm.row(18));
  EXPECT_EQ(named(data.line_data, "tension_n").values,
            (std::vector<double>{1.5, 0.75, 0.75, 0.25}));
  EXPECT_EQ(named(data.line_data, "kind").values, (std::vector<double>{0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(data.faces.rows(), 0);
}

TEST(ValveVtk, UnstressedChordaeHaveNoTension) {
  const ClosedValve exported = still_valve();
  const VtkPolyData data = chordae_vtk(exported, unstressed_shape(exported.valve));
  EXPECT_EQ(named(data.line_data, "tension_n").values, (std::vector<double>{0.0, 0.0, 0.0, 0.0}));
}

TEST(ValveVtk, RupturedChordaeAreLeftOut) {
  ClosedValve exported = still_valve();
  exported.valve.chordae[0].ruptured = true;
  EXPECT_EQ(chordae_vtk(exported, closed_shape(exported)).lines.size(), 1U);
}

TEST(ValveVtk, BothTogetherKeepTheirPoints) {
  const ClosedValve exported = still_valve();
  const VtkPolyData data = valve_vtk(exported, closed_shape(exported));
  EXPECT_EQ(data.points_mm.rows(), 24 + 6);
  EXPECT_EQ(data.lines.back(), (std::array<int, 2>{24 + 4, 24 + 5}));
  EXPECT_EQ(data.point_data[0].values.size(), 30U);
}

}  // namespace
}  // namespace coapt
