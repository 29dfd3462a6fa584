#include "search/plans/climb_model.h"

#include <cmath>

#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

// Plans of one suture each; what they leak is made up, by node: `first` as planned, `others` at nodes 1 to 4. Only
// the mean leak costs.
struct MadeUp {
  RepairPlan plan;
  double first = 0.0, others = 0.0;
};

/// Its cost rises by sinh(`asinh_rise`).
MadeUp climbing(const RepairPlan& plan, double first, double asinh_rise) {
  return {plan, first, first + std::sinh(asinh_rise) / 0.8};
}

RepairPlan at_mm(double length_mm) { return suture(Side::Anterolateral, length_mm); }

struct ClimbScene {
  explicit ClimbScene(const std::vector<MadeUp>& made_up)
      : scene(needs_suture, options_of(made_up)), model(1, 5) {
    for (const MadeUp& one : made_up) plans.push_back(&scene.closed(one.plan, 5));
  }
  static PlanEvaluationOptions options_of(const std::vector<MadeUp>& made_up) {
    PlanEvaluationOptions options = on_threads(1);
    options.weights = leak_alone();
    options.guide_by_price = true;
    for (const MadeUp& one : made_up)
      for (int d = 0; d < 5; ++d)
        options.known[plan_key(one.plan)][d] = closure_leaking(d == 0 ? one.first : one.others);
    return options;
  }
  /// Of the first `count` plans.
  void learn(std::size_t count) {
    model.learn(scene.evaluations,
                {plans.begin(), plans.begin() + static_cast<std::ptrdiff_t>(count)});
  }
  ClimbModel::Expectation expected(std::size_t plan) const {
    return model.expected(scene.evaluations, *plans[plan]);
  }

  EvaluationScene scene;
  ClimbModel model;
  std::vector<const PlanRecord*> plans;
};

TEST(ClimbModel, WithoutPlansItExpectsNoRise) {
  ClimbScene scene({climbing(at_mm(20.0), 3.0, 1.0)});
  const ClimbModel::Expectation expected = scene.expected(0);
  EXPECT_EQ(expected.cost, 3.0);
  EXPECT_EQ(expected.now, 3.0);
  EXPECT_EQ(expected.rise, 0.0);
  EXPECT_EQ(expected.scatter, 0.0);
  EXPECT_EQ(ClimbModel::least(expected, 2.0), 3.0);
}

TEST(ClimbModel, FromTooFewPlansItLearnsNothing) {
  std::vector<MadeUp> plans;
  for (int k = 0; k < 7; ++k) plans.push_back(climbing(at_mm(18.0 + k), 3.0, 1.0));
  ClimbScene scene(plans);
  scene.learn(5);
  EXPECT_EQ(scene.expected(6).rise, 0.0);
  scene.learn(6);
  EXPECT_GT(scene.expected(6).rise, 0.8);
}

TEST(ClimbModel, LearnsARiseThatGoesWithTheRootOfTheLeak) {
  // The plans that it is asked about are of another kind than those that it learns from.
  std::vector<MadeUp> plans;
  for (int k = 0; k < 40; ++k) {
    const double leak = 0.25 * k;
    plans.push_back(climbing(at_mm(15.0 + 0.3 * k), leak, 0.3 + 0.5 * std::sqrt(leak)));
  }
  for (const double leak : {0.0, 1.0, 4.0, 9.0})
    plans.push_back({{{Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 15.0 + leak}}}, leak, leak});
  ClimbScene scene(plans);
  scene.learn(40);
  for (std::size_t i = 40; i < plans.size(); ++i) {
    const ClimbModel::Expectation expected = scene.expected(i);
    const double leak = plans[i].first;
    EXPECT_NEAR(expected.rise, 0.3 + 0.5 * std::sqrt(leak), 0.02) << leak;
    EXPECT_EQ(expected.now, leak);
    EXPECT_NEAR(expected.cost, leak + std::sinh(expected.rise), 1e-12);
  }
}

TEST(ClimbModel, WhatTheLeakDoesNotTellPlansNearbyDo) {
  // All leak alike as planned; those of a muscle moved far rise, the others do not.
  std::vector<MadeUp> plans;
  for (int k = 0; k < 24; ++k) {
    const double length = 16.0 + 0.5 * k;
    plans.push_back(climbing(at_mm(length), 1.0, length < 22.0 ? 2.0 : 0.0));
  }
  plans.push_back(climbing(at_mm(17.2), 1.0, 0.0));
  plans.push_back(climbing(at_mm(26.2), 1.0, 0.0));
  plans.push_back({{{Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 15.0}}}, 1.0, 1.0});
  ClimbScene scene(plans);
  scene.learn(24);
  const ClimbModel::Expectation risen = scene.expected(24), flat = scene.expected(25);
  const ClimbModel::Expectation stranger = scene.expected(26);
  EXPECT_NEAR(risen.rise, 2.0, 0.15);
  EXPECT_NEAR(flat.rise, 0.0, 0.15);
  EXPECT_NEAR(stranger.rise, 1.0, 0.1) << "the mean";
  EXPECT_LT(risen.scatter, 0.2);
  EXPECT_NEAR(stranger.scatter, 1.0, 0.1) << "half rise by 2";
}

TEST(ClimbModel, MoreDeviationsLetItExpectLessButNeverLessThanTheBound) {
  const ClimbModel::Expectation expected{
      .cost = 3.0 + std::sinh(1.0), .now = 3.0, .rise = 1.0, .scatter = 0.5, .bound = 2.5};
  EXPECT_DOUBLE_EQ(ClimbModel::least(expected, 0.0), expected.cost);
  EXPECT_DOUBLE_EQ(ClimbModel::least(expected, 2.0), 3.0);
  EXPECT_LT(ClimbModel::least(expected, 1.0), ClimbModel::least(expected, 0.5));
  EXPECT_EQ(ClimbModel::least(expected, 20.0), 2.5);
}

TEST(ClimbModel, FailedClosuresLeaveNumbers) {
  std::vector<MadeUp> plans;
  for (int k = 0; k < 8; ++k)
    plans.push_back({at_mm(18.0 + k), k % 2 == 0 ? std::nan("") : 1.0, 2.0});
  ClimbScene scene(plans);
  scene.learn(8);
  for (std::size_t i = 0; i < 8; ++i) {
    const ClimbModel::Expectation expected = scene.expected(i);
    EXPECT_TRUE(std::isfinite(expected.cost) && std::isfinite(expected.scatter));
  }
}

}  // namespace
}  // namespace coapt::scene
