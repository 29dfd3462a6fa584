#include "search/model_draw.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "core/presets/presets.h"
#include "core/valve/parametric.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

std::vector<double> at_half() { return std::vector<double>(kModelParameters, 0.5); }

/// All at a half but one.
Valve with_one(const Valve& valve, int parameter, double share) {
  std::vector<double> shares = at_half();
  shares[parameter] = share;
  return *with_model(valve, shares);
}

int index_of(const std::string& name) {
  for (int i = 0; i < kModelParameters; ++i)
    if (model_parameters()[i].name == name) return i;
  ADD_FAILURE() << name;
  return 0;
}

TEST(ModelDraw, AHalfIsTheValveItselfToTheBit) {
  for (const char* name : {"human-normal", "porcine-thesis"}) {
    const Valve& valve = shared_preset(name, 150);
    const Valve same = *with_model(valve, at_half());
    EXPECT_EQ(same.tissue.bending_n_mm, valve.tissue.bending_n_mm);
    EXPECT_EQ(same.tissue.thickness_mm, valve.tissue.thickness_mm);
    EXPECT_EQ(same.tissue.radial_pre_kpa, valve.tissue.radial_pre_kpa);
    EXPECT_EQ(same.tissue.circumferential_transition, valve.tissue.circumferential_transition);
    EXPECT_EQ(same.tissue.radial_transition, valve.tissue.radial_transition);
    EXPECT_EQ(close_valve(same).closed_mm, close_valve(valve).closed_mm);
  }
}

TEST(ModelDraw, FactorsRunFromTheLowerEndOverOneToTheUpper) {
  for (const ModelParameter& parameter : model_parameters()) {
    EXPECT_LT(parameter.lower, 1.0);
    EXPECT_GT(parameter.upper, 1.0);
    EXPECT_EQ(model_factor(parameter, 0.0), parameter.lower);
    EXPECT_EQ(model_factor(parameter, 0.5), 1.0);
    EXPECT_EQ(model_factor(parameter, 1.0), parameter.upper);
    EXPECT_NEAR(model_factor(parameter, 0.25), std::sqrt(parameter.lower), 1e-12);
    EXPECT_NEAR(model_factor(parameter, 0.75), std::sqrt(parameter.upper), 1e-12);
  }
}

TEST(ModelDraw, EachParameterMovesWhatItSays) {
  const Valve& valve = shared_preset("human-normal", 150);
  const Tissue& was = valve.tissue;
  const auto upper = [](int i) { return model_parameters()[i].upper; };
  int i = index_of("bending rigidity");
  EXPECT_NEAR(with_one(valve, i, 1.0).tissue.bending_n_mm, 0.066, 1e-12);
  i = index_of("insertion zone");
  const auto zone = [](const Valve& v) { return v.chordae[0].segments.back().zone_mm; };
  EXPECT_NEAR(zone(with_one(valve, i, 1.0)), upper(i) * zone(valve), 1e-12);
  i = index_of("leaflet thickness");
  EXPECT_NEAR(with_one(valve, i, 0.0).tissue.thickness_mm, 0.65, 1e-12);
  i = index_of("moduli below the transition");
  EXPECT_NEAR(with_one(valve, i, 1.0).tissue.radial_pre_kpa, upper(i) * was.radial_pre_kpa, 1e-9);
  i = index_of("moduli above the transition");
  EXPECT_NEAR(with_one(valve, i, 1.0).tissue.circumferential_post_kpa,
              upper(i) * was.circumferential_post_kpa, 1e-9);
  i = index_of("chordal modulus");
  EXPECT_NEAR(with_one(valve, i, 1.0).tissue.chordae_kpa, upper(i) * was.chordae_kpa, 1e-9);
  i = index_of("chordal length");
  const auto length = [](const Valve& v) { return v.chordae[3].segments[0].rest_length_mm; };
  EXPECT_NEAR(length(with_one(valve, i, 0.0)), 0.95 * length(valve), 1e-12);
}

TEST(ModelDraw, WhatIsLeftUntilTheTransitionMovesInVivoAndExcised) {
  ParametricValve dimensions;  // in vivo: 5 and 12 % are left
  dimensions.triangles = 150;
  Valve valve = *make_parametric_valve(dimensions);
  const int along = index_of("circumferential transition"), across = index_of("radial transition");
  const auto left = [](const Valve& v) {
    const auto [stretch1, stretch2] = prestretch(v.tissue);
    return std::array{(1.0 + v.tissue.circumferential_transition) / stretch1 - 1.0,
                      (1.0 + v.tissue.radial_transition) / stretch2 - 1.0};
  };
  EXPECT_NEAR(left(with_one(valve, along, 0.0))[0], 0.65 * 0.05, 1e-12);
  EXPECT_NEAR(left(with_one(valve, across, 0.0))[1], 0.65 * 0.12, 1e-12);  // 7.8 %
  valve.tissue.reference = TissueReference::Excised;
  EXPECT_NEAR(with_one(valve, along, 0.0).tissue.circumferential_transition, 0.65 * 0.13, 1e-12);
}

TEST(ModelDraw, NeochordaeKeepTheirLengthAndModulus) {
  Valve valve = shared_preset("human-normal", 150);
  valve.chordae[0].kind = ChordaKind::Neochorda;
  std::vector<double> shares = at_half();
  shares[index_of("chordal length")] = 0.0;
  shares[index_of("chordal modulus")] = 1.0;
  const Valve drawn = *with_model(valve, shares);
  const ChordaSegment &was = valve.chordae[0].segments[0], &is = drawn.chordae[0].segments[0];
  EXPECT_EQ(is.rest_length_mm, was.rest_length_mm);
  EXPECT_EQ(is.modulus_kpa, valve.tissue.chordae_kpa);
}

TEST(ModelDraw, WhatAFitHasFoundIsNotDrawnAgain) {
  Valve valve = shared_preset("human-normal", 150);
  std::vector<double> shares = at_half();
  shares[index_of("moduli above the transition")] = 1.0;
  EXPECT_EQ(with_model(valve, shares)->tissue.radial_post_kpa, 3.0 * valve.tissue.radial_post_kpa);
  valve.fitted = FittedValues{{"stiffness"}, Eigen::MatrixXd::Identity(1, 1)};
  EXPECT_EQ(with_model(valve, shares)->tissue.radial_post_kpa, valve.tissue.radial_post_kpa);
}

TEST(ModelDraw, AllEndsOfThePresetsAreValidValves) {
  for (const std::string& name : preset_names()) {
    const Valve& valve = shared_preset(name, 150);
    for (const double share : {0.0, 1.0})
      EXPECT_TRUE(with_model(valve, std::vector<double>(kModelParameters, share))) << name;
  }
}

TEST(ModelDraw, WhatLeavesTheLimitsOfAValveIsRefused) {
  Valve valve = small_valve();
  valve.tissue.bending_n_mm = 9.0;  // at most 10
  std::vector<double> shares = at_half();
  shares[index_of("bending rigidity")] = 1.0;
  const Expected<Valve> drawn = with_model(valve, shares);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.errors().front().path, "/tissue/bending_n_mm");
}

}  // namespace
}  // namespace coapt
