#include "io/exchange/valve_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/metrics/leaflet_sides.h"
#include "io/exchange/import_files.h"
#include "io/image/write_label_map.h"
#include "still_valve.h"

namespace coapt {
namespace {

std::ptrdiff_t voxels_of(const LabelMap& map, int label) {
  return std::count(map.voxels.begin(), map.voxels.end(), label);
}

TEST(ValveLabels, ALeafletHasItsAreaTimesItsThickness) {
  const ClosedValve exported = still_valve();
  const ValveShape shape = unstressed_shape(exported.valve);
  const Expected<LabelMap> map = valve_labels(exported, shape, nullptr);
  ASSERT_TRUE(map) << map.errors()[0].message;
  const std::vector<Leaflet> sides = leaflet_sides(exported.valve);
  std::array<double, 2> area = {0.0, 0.0};
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const auto corner = [&](int k) {
      return Vec3(
          shape.vertices_mm.row(exported.valve.faces(static_cast<Index>(f), k)).transpose());
    };
    area[sides[f] == Leaflet::Anterior ? 0 : 1] +=
        0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  const double thickness = std::max(exported.valve.tissue.thickness_mm, 2 * 0.87 * 0.5);
  for (const int label : {1, 2}) {
    const double volume = 0.125 * static_cast<double>(voxels_of(*map, label));
    EXPECT_NEAR(volume / (area[static_cast<std::size_t>(label - 1)] * thickness), 1.0, 0.25)
        << label;
  }
  EXPECT_GT(voxels_of(*map, 3), 100);
}

TEST(ValveLabels, AMapThatIsCancelledIsNotDrawnToItsEnd) {
  const ClosedValve exported = still_valve();
  int asked = 0;
  const Expected<LabelMap> map = valve_labels(exported, unstressed_shape(exported.valve), nullptr,
                                              [&] { return ++asked > 0; });
  ASSERT_FALSE(map);
  EXPECT_EQ(map.errors()[0].code, ErrorCode::Busy);
  EXPECT_EQ(asked, 1);
}

TEST(ValveLabels, AValveThatTakesTooManyVoxelsIsRefusedBeforeTheyAreMade) {
  const ClosedValve exported = still_valve();
  for (const double scale : {20.0, 1e9}) {
    ValveShape shape = unstressed_shape(exported.valve);
    shape.vertices_mm *= scale;
    const Expected<LabelMap> map = valve_labels(exported, shape, nullptr);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.errors()[0].code, ErrorCode::OutOfRange);
    EXPECT_EQ(map.errors()[0].path, "/grid");
  }
}

TEST(ValveLabels, AGridIsKeptAndMustHoldTheValve) {
  const ClosedValve exported = still_valve();
  const ValveShape shape = unstressed_shape(exported.valve);
  ImageGeometry grid;
  grid.size = {80, 80, 60};
  grid.to_lps_mm << 0, -1, 0, 40, 1, 0, 0, -40, 0, 0, 1, -40, 0, 0, 0, 1;
  const Expected<LabelMap> map = valve_labels(exported, shape, &grid);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->size, grid.size);
  EXPECT_EQ(map->to_lps_mm, grid.to_lps_mm);
  EXPECT_GT(voxels_of(*map, 1), 100);
  grid.to_lps_mm(2, 3) = 100.0;
  const Expected<LabelMap> outside = valve_labels(exported, shape, &grid);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.errors()[0].path, "/grid");
}

}  // namespace
}  // namespace coapt
