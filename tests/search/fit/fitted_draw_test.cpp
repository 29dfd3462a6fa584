#include "search/fit/fitted_draw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/valve/validate.h"
#include "search/latin_hypercube.h"
#include "search/model_draw.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr const char* kAnterior = "slack_anterior_AL";
constexpr const char* kTip = "tip_AL_z";

/// Slack known to 2 %, the tip to 0.5 mm, correlated by 0.6.
Valve fitted_valve() {
  Valve valve = small_preset("human-normal");
  Eigen::Matrix2d covariance;
  covariance << 0.02 * 0.02, 0.6 * 0.02 * 0.5, 0.6 * 0.02 * 0.5, 0.5 * 0.5;
  valve.fitted = FittedValues{{kAnterior, kTip}, covariance};
  return valve;
}

double anterior_length(const Valve& valve) {
  for (const Chorda& chorda : valve.chordae)
    if (chorda.id == "AL1-A2-marginal-1") return chorda.segments.front().rest_length_mm;
  return 0.0;
}

TEST(FittedDraw, SharesOfAHalfAreTheValveItself) {
  const Valve valve = fitted_valve();
  const Valve drawn = *with_fitted_draw(valve, {0.5, 0.5});
  EXPECT_NEAR(anterior_length(drawn), anterior_length(valve), 1e-12);
  EXPECT_NEAR(drawn.heads[0].tip_mm.z(), valve.heads[0].tip_mm.z(), 1e-12);
}

TEST(FittedDraw, DrawsHaveTheCovarianceOfTheFit) {
  const Valve valve = fitted_valve();
  double slack2 = 0.0, tip2 = 0.0, both = 0.0;
  constexpr int kDraws = 400;
  for (const std::vector<double>& shares : latin_hypercube(kDraws, 2, 5)) {
    const Valve drawn = *with_fitted_draw(valve, shares);
    const double slack = anterior_length(drawn) / anterior_length(valve) - 1.0;
    const double tip = drawn.heads[0].tip_mm.z() - valve.heads[0].tip_mm.z();
    slack2 += slack * slack / kDraws;
    tip2 += tip * tip / kDraws;
    both += slack * tip / kDraws;
  }
  EXPECT_NEAR(slack2, 4e-4, 4e-5);
  EXPECT_NEAR(tip2, 0.25, 0.025);
  EXPECT_NEAR(both, 6e-3, 1e-3);
}

TEST(FittedDraw, WhatAFitHasFoundIsNotDrawnOnceMoreWithTheModel) {
  const Valve valve = fitted_valve();
  std::vector<double> shares(kModelParameters, 0.9);
  const Valve drawn = *with_model(valve, shares);
  EXPECT_EQ(anterior_length(drawn), anterior_length(valve));
  EXPECT_GT(drawn.tissue.thickness_mm, valve.tissue.thickness_mm);
  EXPECT_NE(drawn.tissue.radial_transition, valve.tissue.radial_transition);
  Valve unfitted = valve;
  unfitted.fitted.reset();
  EXPECT_GT(anterior_length(*with_model(unfitted, shares)), anterior_length(valve));
}

TEST(FittedDraw, NamesThatAreNoParametersAreRefused) {
  Valve valve = fitted_valve();
  valve.fitted->parameters[1] = "tip_AL_w";
  const Errors errors = check_fitted_parameters(valve);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].path, "/fit/parameters/1");
  EXPECT_NE(errors[0].message.find("tip_AL_z"), std::string::npos);
}

TEST(FittedValues, AreValidIfTheirMatrixIsACovariance) {
  const auto problem = [](const Eigen::MatrixXd& covariance) {
    Valve valve = fitted_valve();
    valve.fitted->covariance = covariance;
    const Errors errors = validate(valve);
    return errors.empty() ? std::string() : errors[0].path;
  };
  EXPECT_EQ(problem(Eigen::Matrix2d::Identity()), "");
  EXPECT_EQ(problem(Eigen::Matrix3d::Identity()), "/fit/covariance");
  EXPECT_EQ(problem(-Eigen::Matrix2d::Identity()), "/fit/covariance");
  Eigen::Matrix2d skew;
  skew << 1.0, 0.5, -0.5, 1.0;
  EXPECT_EQ(problem(skew), "/fit/covariance");
  EXPECT_EQ(problem(Eigen::Matrix2d::Constant(std::nan(""))), "/fit/covariance");
  Valve twice = fitted_valve();
  twice.fitted->parameters[1] = kAnterior;
  EXPECT_EQ(validate(twice).at(0).path, "/fit/parameters");
}

}  // namespace
}  // namespace coapt
