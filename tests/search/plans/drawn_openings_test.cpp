#include "search/plans/drawn_openings.h"

#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

constexpr int kOpenedDraws = 8;

/// An opening of 100 mm2 times the stiffness of the chordae, a tenth less with a ring.
PlanOpening opened_by_stiffness(const Valve& valve) {
  PlanOpening opening;
  opening.measure.opening_area_mm2 = (has_ring(valve) ? 90.0 : 100.0) * stiffness(valve);
  return opening;
}

TEST(DrawnOpenings, AreOfTheDrawsOfClosuresAndOfErrorsOfTheHand) {
  PlanEvaluationOptions options = on_threads(2);
  options.open = opened_by_stiffness;
  EvaluationScene scene(leak_of(stiffness), std::move(options));
  PlanRecord* const ring = &scene.closed(own_ring(1), 1);
  ASSERT_TRUE(scene.evaluations.open({&ring, 1}, PlanEvaluations::Phase::Ranking));
  const ModelClosures model = close_under_draws(scene.evaluations, {ring}, kOpenedDraws);
  const std::vector<DrawnOpenings> drawn =
      open_under_draws(scene.evaluations, {nullptr, ring}, model);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_TRUE(drawn[0].errors.empty()) << "no hand has touched the valve as it is";
  ASSERT_EQ(std::ssize(drawn[0].draws), kOpenedDraws);
  ASSERT_EQ(std::ssize(drawn[1].draws), kOpenedDraws);
  for (int draw = 0; draw < kOpenedDraws; ++draw) {
    EXPECT_DOUBLE_EQ(drawn[0].draws[draw].measure.opening_area_mm2,
                     100.0 * model.before[draw].leak_mm2);
    EXPECT_DOUBLE_EQ(drawn[1].draws[draw].measure.opening_area_mm2,
                     90.0 * model.before[draw].leak_mm2);
  }
  ASSERT_EQ(std::ssize(drawn[1].errors), kDrawnOpenings);
  EXPECT_DOUBLE_EQ(drawn[1].errors[0].measure.opening_area_mm2, 90.0);
}

TEST(DrawnOpenings, AreNoneWithoutAnOpenerAndNoDrawsThatObservationsContradict) {
  EvaluationScene closed_only(leak_of(stiffness));
  const ModelClosures none = close_under_draws(closed_only.evaluations, {}, kOpenedDraws);
  EXPECT_TRUE(open_under_draws(closed_only.evaluations, {nullptr}, none)[0].draws.empty());

  PlanEvaluationOptions options = on_threads(1);
  options.open = opened_by_stiffness;
  EvaluationScene scene(leak_of(stiffness), std::move(options));
  PlanRecord* const ring = &scene.closed(own_ring(1), 1);
  ModelClosures model = close_under_draws(scene.evaluations, {}, kOpenedDraws);
  EXPECT_TRUE(open_under_draws(scene.evaluations, {ring}, model)[0].draws.empty())
      << "it was not opened as planned";
  ASSERT_TRUE(scene.evaluations.open({&ring, 1}, PlanEvaluations::Phase::Ranking));
  model.contradicts = true;
  const DrawnOpenings drawn = open_under_draws(scene.evaluations, {ring}, model)[0];
  EXPECT_TRUE(drawn.draws.empty());
  EXPECT_EQ(std::ssize(drawn.errors), kDrawnOpenings);
}

}  // namespace
}  // namespace coapt::scene
