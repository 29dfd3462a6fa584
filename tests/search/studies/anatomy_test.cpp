#include "search/studies/anatomy.h"

#include <gtest/gtest.h>

#include <set>

#include "core/presets/presets.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

/// As many numbers as parameters, none like another.
Anatomy numbered() {
  Anatomy anatomy{};
  for (std::size_t i = 0; i < anatomy.size(); ++i) anatomy[i] = 1.0 + static_cast<double>(i);
  return anatomy;
}

TEST(ParametricValve, TakesEachParameterToItsField) {
  const ParametricValve d = parametric_valve(numbered(), "numbered");
  EXPECT_EQ(d.name, "numbered");
  const std::vector<double> fields = {d.ap_mm,
                                      d.al_pm_mm,
                                      *d.saddle_height_mm,
                                      *d.anterior_height_mm,
                                      *d.posterior_height_mm,
                                      *d.lateral_height_mm,
                                      *d.commissure_height_mm,
                                      d.cleft_depth_mm,
                                      d.anterior_arc,
                                      d.trigone_share,
                                      d.anterior_inclination_deg,
                                      d.tip_depth_mm,
                                      d.tip_spread_mm,
                                      d.tip_posterior_mm,
                                      d.slack.anterior,
                                      d.slack.posterior / d.slack.anterior,
                                      d.slack.strut / d.slack.anterior,
                                      d.slack.basal / d.slack.anterior,
                                      d.asymmetry.tip_mm.x(),
                                      d.asymmetry.tip_mm.y(),
                                      d.asymmetry.tip_mm.z(),
                                      d.asymmetry.leaflet_height,
                                      d.asymmetry.slack,
                                      d.tissue.circumferential_transition,
                                      d.tissue.radial_transition};
  ASSERT_EQ(fields.size() + 1, static_cast<std::size_t>(kAnatomyParameters));
  for (std::size_t i = 0; i < fields.size(); ++i)
    EXPECT_EQ(fields[i], 1.0 + static_cast<double>(i)) << anatomy_parameters()[i].name;
  EXPECT_EQ(d.posterior_inclination_deg, d.anterior_inclination_deg);
  EXPECT_EQ(d.tissue.circumferential_post_kpa, 26.0 * Tissue{}.circumferential_post_kpa);
  EXPECT_EQ(d.tissue.radial_post_kpa, 26.0 * Tissue{}.radial_post_kpa);
  EXPECT_EQ(d.tissue.radial_pre_kpa, Tissue{}.radial_pre_kpa);
}

TEST(AnatomyParameters, HaveNamesOfTheirOwnAndTheTypicalWithinTheirBounds) {
  std::set<std::string> names;
  for (const AnatomyParameter& parameter : anatomy_parameters()) {
    names.insert(parameter.name);
    EXPECT_LT(parameter.lower, parameter.upper) << parameter.name;
    EXPECT_LE(parameter.lower, parameter.typical) << parameter.name;
    EXPECT_GE(parameter.upper, parameter.typical) << parameter.name;
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kAnatomyParameters));
}

TEST(AnatomyAt, GoesFromTheLowerToTheUpperBound) {
  const Anatomy low = anatomy_at(std::vector<double>(kAnatomyParameters, 0.0));
  const Anatomy quarter = anatomy_at(std::vector<double>(kAnatomyParameters, 0.25));
  const Anatomy high = anatomy_at(std::vector<double>(kAnatomyParameters, 1.0));
  for (std::size_t i = 0; i < low.size(); ++i) {
    const AnatomyParameter& parameter = anatomy_parameters()[i];
    EXPECT_EQ(low[i], parameter.lower);
    EXPECT_DOUBLE_EQ(quarter[i], 0.75 * parameter.lower + 0.25 * parameter.upper);
    EXPECT_DOUBLE_EQ(high[i], parameter.upper);
  }
}

TEST(TypicalAnatomy, MakesAValidTautValve) {
  const Expected<Valve> valve = make_taut_valve(parametric_valve(typical_anatomy(), "typical"));
  ASSERT_TRUE(valve);
  EXPECT_TRUE(validate(*valve).empty());
  EXPECT_EQ(valve->name, "typical");
}

}  // namespace
}  // namespace coapt
