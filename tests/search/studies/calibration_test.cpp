#include "search/studies/calibration.h"

#include <gtest/gtest.h>

#include <set>

namespace coapt {
namespace {

const CalibrationTarget& named(const std::vector<CalibrationTarget>& targets,
                               const std::string& name) {
  for (const CalibrationTarget& target : targets)
    if (target.name == name) return target;
  ADD_FAILURE() << "no target " << name;
  return targets.front();
}

TEST(CalibrationTargets, AreFigure45Table41AndACompetentValve) {
  const std::vector<CalibrationTarget> targets = calibration_targets();
  ASSERT_EQ(targets.size(), 25u);
  std::set<std::string> names;
  for (const CalibrationTarget& target : targets) names.insert(target.name);
  EXPECT_EQ(names.size(), 25u);

  const CalibrationTarget& dilated = named(targets, "AP 20 %");
  EXPECT_EQ(dilated.area_mm2, 32.0);
  EXPECT_EQ(dilated.configuration.change.ap_dilation_percent, 20.0);
  EXPECT_EQ(dilated.configuration.change.annular_height_percent, 100.0);

  const CalibrationTarget& lateral = named(targets, "AL T + A");
  EXPECT_EQ(lateral.area_mm2, 40.8);
  EXPECT_EQ(lateral.configuration.change.anterolateral_mm, Vec3(6.0, 0.0, 6.0));
  EXPECT_EQ(lateral.configuration.change.posteromedial_mm, Vec3::Zero());

  const CalibrationTarget& medial = named(targets, "PM P");
  EXPECT_EQ(medial.area_mm2, 6.6);
  EXPECT_EQ(medial.configuration.change.posteromedial_mm, Vec3(0.0, 6.0, 0.0));

  const CalibrationTarget& both = named(targets, "both All");
  EXPECT_EQ(both.area_mm2, 191.7);
  EXPECT_EQ(both.configuration.change.anterolateral_mm, Vec3(6.0, 6.0, 6.0));
  EXPECT_EQ(both.configuration.change.posteromedial_mm, Vec3(6.0, 6.0, 6.0));

  EXPECT_EQ(targets.back().name, "undisturbed");
  EXPECT_EQ(targets.back().area_mm2, 0.0);
}

}  // namespace
}  // namespace coapt
