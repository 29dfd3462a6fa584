#include "core/valve/dimension_table.h"

#include <gtest/gtest.h>

#include <set>

#include "core/valve/pressure_unit.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const Dimension& named(const std::string& name) {
  for (const Dimension& dimension : dimension_table())
    if (dimension.name == name) return dimension;
  ADD_FAILURE() << name;
  return dimension_table().front();
}

TEST(DimensionTable, HasNamesOfTheirOwnAndTakesWhatItGives) {
  std::set<std::string> names;
  for (const Dimension& dimension : dimension_table()) {
    EXPECT_TRUE(names.insert(dimension.name).second) << dimension.name;
    ParametricValve d;
    if (const auto usual = dimension.get(d)) {
      EXPECT_GE(*usual, dimension.accepted.min) << dimension.name;
      EXPECT_LE(*usual, dimension.accepted.max) << dimension.name;
    }
    const double value = 0.3 * dimension.accepted.min + 0.7 * dimension.accepted.max;
    dimension.set(d, value);
    EXPECT_NEAR(*dimension.get(d), value, 1e-12) << dimension.name;
    for (const Dimension& other : dimension_table()) {
      if (other.name == dimension.name) continue;
      EXPECT_EQ(other.get(d), other.get(ParametricValve{})) << dimension.name << other.name;
    }
  }
}

TEST(DimensionTable, ExtensionIsWhatIsLeftOfTheTransitionStrain) {
  ParametricValve d;
  EXPECT_NEAR(*named("radial_extension").get(d), 0.12, 1e-12);
  named("radial_extension").set(d, 0.0);
  EXPECT_DOUBLE_EQ(d.tissue.radial_prestretch, 1.33);
  // Of an excised shape it is the transition strain itself.
  d.tissue.reference = TissueReference::Excised;
  named("circumferential_extension").set(d, 0.2);
  EXPECT_EQ(d.tissue.circumferential_transition, 0.2);
}

TEST(WithMaterial, ChangesPressureAndTissueAlone) {
  const Valve valve = small_valve();
  const Expected<Valve> changed = with_material(
      valve, {{&named("pressure_mmhg"), 150.0}, {&named("circumferential_stiffness"), 0.5}});
  ASSERT_TRUE(changed);
  EXPECT_DOUBLE_EQ(changed->pressure_kpa, 150.0 / kMmhgPerKpa);
  EXPECT_EQ(changed->tissue.circumferential_post_kpa, 1150.0);
  Tissue same = changed->tissue;
  same.circumferential_post_kpa = valve.tissue.circumferential_post_kpa;
  EXPECT_EQ(same, valve.tissue);
  EXPECT_EQ(changed->rest_mm, valve.rest_mm);
}

TEST(WithMaterial, NamesEachValueOutsideItsRangeWithWhatIsAccepted) {
  const Expected<Valve> refused = with_material(
      small_valve(), {{&named("pressure_mmhg"), 1e4}, {&named("radial_extension"), -0.1}});
  ASSERT_FALSE(refused);
  ASSERT_EQ(refused.errors().size(), 2u);
  EXPECT_EQ(refused.errors()[0].path, "/pressure_mmhg");
  EXPECT_EQ(refused.errors()[1].path, "/radial_extension");
  EXPECT_NE(refused.errors()[1].message.find("from 0 to 0.4"), std::string::npos);
}

}  // namespace
}  // namespace coapt
