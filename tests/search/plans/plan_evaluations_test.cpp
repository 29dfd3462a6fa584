#include "search/plans/plan_evaluations.h"

#include <cmath>
#include <limits>
#include <mutex>
#include <set>

#include "search/parallel.h"
#include "search/plans/disturbance.h"
#include "tests/search/plans/search_scene.h"

namespace coapt::scene {
namespace {

const RepairPlan kSuture = suture(Side::Posteromedial, 22.0);

/// Of one lattice finer than a surgeon's: up to 300 plans.
RepairPlan numbered(int k) { return suture(Side::Anterolateral, 16.0 + 0.04 * k); }

TEST(PlanEvaluations, ClosesTheUnrepairedValveWhenItIsMade) {
  EvaluationScene scene(leak_of([](const Valve&) { return 7.0; }));
  EXPECT_EQ(scene.evaluations.before().measure.leak.area_mm2, 7.0);
  EXPECT_EQ(scene.evaluations.closures(), 1);
  EXPECT_EQ(scene.evaluations.known(), 0);
}

TEST(PlanEvaluations, TensionCostsNothingWhereThatOfTheUnrepairedValveIsUnknown) {
  const auto evaluate = [](ClosureStatus status) {
    return [status](const Valve&, const ClosureResult*) {
      Evaluation evaluation = leaking(0.0);
      evaluation.status = status;
      evaluation.measure.tension_max_n = 3.0;
      return ClosedPlan{evaluation, nullptr};
    };
  };
  EvaluationScene trusted_one(evaluate(ClosureStatus::Converged)),
      failed(evaluate(ClosureStatus::StepLimit));
  EXPECT_EQ(trusted_one.evaluations.context().tension_before_n, 3.0);
  EXPECT_EQ(failed.evaluations.context().tension_before_n, std::numeric_limits<double>::infinity());
  EXPECT_EQ(failed.evaluations.not_converged(), 1);
}

TEST(PlanEvaluations, OnePlanHasOneRecordInWhateverOrderItsSteps) {
  EvaluationScene scene(needs_suture);
  PlanRecord& record = scene.evaluations.record(both(own_ring(2), kSuture));
  EXPECT_EQ(&scene.evaluations.record(both(kSuture, own_ring(2))), &record);
  EXPECT_NE(&scene.evaluations.record(kSuture), &record);
  EXPECT_EQ(record.effort.steps, 2);
  EXPECT_EQ(record.lowest_cost, effort_price(record.effort));
}

TEST(PlanEvaluations, ManyThreadsAskingForAPlanGetTheSameRecord) {
  EvaluationScene scene(needs_suture);
  std::vector<PlanRecord*> records(40);
  for_each_index(40, 4, [&](int i) {
    records[static_cast<std::size_t>(i)] = &scene.evaluations.record(numbered(i % 4));
  });
  for (std::size_t i = 4; i < 40; ++i) EXPECT_EQ(records[i], records[i - 4]);
  EXPECT_EQ((std::set<PlanRecord*>(records.begin(), records.end()).size()), 4u);
}

TEST(PlanEvaluations, ABatchIsClosedOnceWhateverItAsksForTwice) {
  for (const int threads : {1, 3}) {
    std::atomic<int> calls = 0;
    std::set<std::pair<std::string, int>> kept;
    PlanEvaluationOptions options = on_threads(threads);
    options.keep = [&kept](const std::string& key, int d, const PlanClosure&) {
      EXPECT_TRUE(kept.emplace(key, d).second);
    };
    EvaluationScene scene(counted(needs_suture, calls), std::move(options));
    std::vector<PlanEvaluations::Wanted> wanted;
    for (int twice = 0; twice < 2; ++twice)
      for (int k = 0; k < 5; ++k)
        for (int d = 0; d < 4; ++d) wanted.push_back({&scene.evaluations.record(numbered(k)), d});
    EXPECT_TRUE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    EXPECT_TRUE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    EXPECT_EQ(calls, 1 + 5 * 4);
    EXPECT_EQ(scene.evaluations.closures(), 1 + 5 * 4);
    EXPECT_EQ(kept.size(), 5u * 4u);
  }
}

TEST(PlanEvaluations, ADisturbedClosureStartsFromThatOfThePlan) {
  // Leaks as much as the closure that it started from says; none as planned.
  const Evaluator evaluate = [](const Valve& valve, const ClosureResult* from) {
    auto closure = std::make_shared<ClosureResult>();
    closure->residual = moved_mm(valve, Side::Posteromedial);
    return ClosedPlan{leaking(from == nullptr ? 0.0 : from->residual), closure};
  };
  EvaluationScene scene(evaluate);
  const PlanRecord& record = scene.closed(kSuture, 5);
  EXPECT_EQ(record.closures.at(0).leak_mm2, 0.0);
  for (int d = 1; d < 5; ++d)
    EXPECT_NEAR(record.closures.at(d).leak_mm2, kTipToTrigone_mm - 22.0, 1e-3);
}

/// Closes where the posteromedial tip says, but for a thousandth of the way from where it started: the leak
/// is how far that is, and its bits tell where the closure started.
ClosedPlan following(const Valve& valve, const ClosureResult* from) {
  auto closure = std::make_shared<ClosureResult>();
  closure->status = ClosureStatus::Converged;
  const Vec3 tip = papillary_tip_mm(valve, Side::Posteromedial);
  closure->closed_mm = valve.rest_mm.rowwise() + tip.transpose();
  for (Index i = 0; i < valve.rest_mm.rows(); ++i)  // flat faces cross by rounding
    closure->closed_mm(i, 2) += 0.3 * std::sin(static_cast<double>(i * i));
  if (from) closure->closed_mm += 1e-3 * (from->closed_mm - closure->closed_mm);
  return {leaking((closure->closed_mm.row(0) - valve.rest_mm.row(0)).norm()), closure};
}

TEST(PlanEvaluations, ADisturbedClosureStartsWhereTheFrameLetsItBeExpected) {
  std::mutex mutex;
  std::map<double, int> predictions;  // by how far from where they end
  const Evaluator evaluate = [&](const Valve& valve, const ClosureResult* from) {
    ClosedPlan closed = following(valve, from);
    const std::lock_guard<std::mutex> lock(mutex);
    if (from && from->predicted)
      ++predictions[(from->closed_mm - closed.closure->closed_mm).row(0).norm()];
    return closed;
  };
  EvaluationScene scene(evaluate);
  scene.closed(kSuture, 100);
  int count = 0;
  for (const auto& [far, n] : predictions) count += n;
  EXPECT_EQ(count, 99 - 3);
  EXPECT_LT(predictions.rbegin()->first, 0.3) << "of tips that go up to 2.9 mm";
}

TEST(PlanEvaluations, PredictedClosuresHaveTheSameBitsInWhateverOrderByHoweverManyThreads) {
  const auto leaks = [](const std::vector<int>& order, PlanEvaluationOptions options) {
    EvaluationScene scene(following, std::move(options));
    PlanRecord& record = scene.evaluations.record(kSuture);
    for (const int d : order) {
      std::vector<PlanEvaluations::Wanted> wanted = {{&record, d}};
      if (d % 5 == 0) wanted.push_back({&record, d / 2});
      EXPECT_TRUE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
    }
    std::vector<PlanEvaluations::Wanted> all;
    for (int d = 0; d < kDisturbances; ++d) all.push_back({&record, d});
    EXPECT_TRUE(scene.evaluations.close(all, PlanEvaluations::Phase::Ranking));
    EXPECT_EQ(scene.evaluations.closures(), 1 + kDisturbances);
    return record.closures;
  };
  const PlanClosures once = leaks({}, on_threads(1));
  const auto expect_once = [&once](const PlanClosures& closures) {
    ASSERT_EQ(closures.size(), once.size());
    for (const auto& [d, closure] : closures)
      EXPECT_EQ(bits(closure.leak_mm2), bits(once.at(d).leak_mm2)) << d;
  };
  expect_once(leaks({}, on_threads(3)));
  expect_once(leaks({1372, 40, 1300, 7, 16, 1100, 2, 900}, on_threads(2)));
  PlanEvaluationOptions knowing = on_threads(2);
  for (const auto& [d, closure] : once)
    if (d % 3 != 1) knowing.known[plan_key(kSuture)][d] = closure;
  expect_once(leaks({}, knowing));
}

TEST(PlanEvaluations, FewNodesMakeNoFrame) {
  std::atomic<int> calls = 0;
  EvaluationScene scene(counted(following, calls));
  scene.closed(kSuture, 5);
  EXPECT_EQ(calls, 1 + 5);
  PlanRecord& record = scene.closed(kSuture, 17);
  EXPECT_EQ(calls, 1 + 17);
  EXPECT_TRUE(scene.evaluations.close_here(record, 20));
  EXPECT_EQ(calls, 1 + 20);
}

TEST(PlanEvaluations, AFrameThatCannotBeTrustedLeavesThePlanItselfToStartFrom) {
  std::atomic<int> predicted = 0;
  for (const bool planned : {true, false}) {  // whether that is what fails, or its frame
    predicted = 0;
    const Evaluator evaluate = [&](const Valve& valve, const ClosureResult* from) {
      predicted += from && from->predicted;
      ClosedPlan closed = following(valve, from);
      ClosureResult failed = *closed.closure;
      if (planned == (from == nullptr)) failed.crossing = true;
      return ClosedPlan{closed.evaluation, std::make_shared<ClosureResult>(failed)};
    };
    EvaluationScene scene(evaluate);
    scene.closed(kSuture, 30);
    EXPECT_EQ(predicted, 0);
  }
}

TEST(PlanEvaluations, WhatIsKnownIsNotClosedAndNotKept) {
  std::atomic<int> calls = 0, kept = 0;
  PlanEvaluationOptions options = on_threads(1);
  options.known[plan_key(kSuture)] = {{0, closure_leaking(1.5)}, {2, closure_leaking(2.5)}};
  options.keep = [&kept](const std::string&, int, const PlanClosure&) { ++kept; };
  EvaluationScene scene(counted(needs_suture, calls), std::move(options));
  const PlanRecord& record = scene.closed(kSuture, 3);
  EXPECT_EQ(record.closures.at(0).leak_mm2, 1.5);
  EXPECT_EQ(record.closures.at(2).leak_mm2, 2.5);
  EXPECT_EQ(scene.evaluations.closures(), 1 + 3);
  EXPECT_EQ(scene.evaluations.known(), 2);
  EXPECT_EQ(kept, 1);
  EXPECT_EQ(calls, 1 + 2) << "node 1, and the plan as planned to start it from";
}

TEST(PlanEvaluations, AForgottenClosureIsMadeAgainWhereItIsNeeded) {
  std::atomic<int> calls = 0;
  EvaluationScene scene(counted(needs_suture, calls));
  std::vector<PlanEvaluations::Wanted> wanted;
  for (int k = 0; k < 300; ++k) wanted.push_back({&scene.evaluations.record(numbered(k)), 0});
  EXPECT_TRUE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
  EXPECT_EQ(calls, 1 + 300);
  scene.closed(numbered(299), 2);
  EXPECT_EQ(calls, 1 + 300 + 1);
  const PlanRecord& first = scene.closed(numbered(0), 2);
  EXPECT_EQ(calls, 1 + 300 + 1 + 2);
  EXPECT_EQ(scene.evaluations.closures(), 1 + 300 + 2);
  EvaluationScene fresh(needs_suture);
  const PlanRecord& same = fresh.closed(numbered(0), 2);
  EXPECT_EQ(bits(first.closures.at(1).leak_mm2), bits(same.closures.at(1).leak_mm2));
}

TEST(PlanEvaluations, CostsCountTheFirstNodesOnly) {
  PlanEvaluationOptions options = on_threads(1);
  options.weights = leak_alone();
  options.weights.sd_share = 1.0;
  for (int d = 0; d < 4; ++d)
    options.known[plan_key(kSuture)][d] = closure_leaking(d == 0 ? 2.0 : 4.0);
  EvaluationScene scene(needs_suture, std::move(options));
  const PlanRecord& record = scene.closed(kSuture, 4);
  EXPECT_DOUBLE_EQ(scene.evaluations.cost(record, 1), 2.0);
  EXPECT_DOUBLE_EQ(scene.evaluations.cost(record, 2), 3.0 + 1.0);
  EXPECT_DOUBLE_EQ(scene.evaluations.cost(record, 4), 3.5 + std::sqrt(0.75));
}

TEST(PlanEvaluations, AnImpossiblePlanCostsMoreThanAnyFailureAndIsNotClosed) {
  std::atomic<int> calls = 0;
  EvaluationScene scene(counted(needs_suture, calls));
  const PlanRecord& slack = scene.closed(suture(Side::Posteromedial, 99.0), 0);
  EXPECT_FALSE(slack.possible);
  std::vector<PlanEvaluations::Wanted> wanted = {{&scene.evaluations.record(slack.plan), 0}};
  EXPECT_TRUE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
  EXPECT_TRUE(scene.evaluations.close_here(*wanted[0].plan, 1));
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(slack.closures.empty());
  EXPECT_EQ(scene.evaluations.cost(slack, 1), 10.0 * CostWeights{}.untrusted);
}

TEST(PlanEvaluations, CloseHereGoesNoFurtherThanTheWatchSays) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> calls = 0;
  EvaluationScene scene(cancelling(needs_suture, calls, 4, cancelled), {}, &cancelled);
  PlanRecord& record = scene.evaluations.record(kSuture);
  EXPECT_FALSE(scene.evaluations.close_here(record, 5));
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(record.closures.size(), 3u);
  EXPECT_FALSE(scene.evaluations.close_here(record, 4));
  EXPECT_TRUE(scene.evaluations.close_here(record, 3)) << "they are closed";
  std::vector<PlanEvaluations::Wanted> wanted = {{&record, 2}, {&record, 3}};
  EXPECT_FALSE(scene.evaluations.close(wanted, PlanEvaluations::Phase::Ranking));
  EXPECT_EQ(calls, 4);
}

TEST(PlanEvaluations, CountsFailuresAndWhatPracticeRejects) {
  const Evaluator evaluate = [](const Valve& valve, const ClosureResult*) {
    Evaluation evaluation = leaking(1.0);
    evaluation.crossing = has_ring(valve);
    return ClosedPlan{evaluation, nullptr};
  };
  EvaluationScene scene(evaluate);
  scene.closed(own_ring(1), 3);
  scene.closed(kSuture, 2);
  EXPECT_EQ(scene.evaluations.crossed(), 3);
  EXPECT_EQ(scene.evaluations.not_converged(), 0);
  EXPECT_TRUE(scene.evaluations.rejections().empty());
  EXPECT_EQ(scene.evaluations.record(own_ring(6)).rejected_by, "undersizing");
  scene.evaluations.record(own_ring(5));
  EXPECT_EQ(scene.evaluations.rejections(), (std::map<std::string, int>{{"undersizing", 2}}));
}

TEST(PlanEvaluations, UndersizedRingsAreWarnedOfOnceItIsSureThatNoLeafletIsTethered) {
  const auto warnings = [](const std::optional<Diagnosis>& diagnosis) {
    EvaluationScene scene(needs_suture);
    if (diagnosis) scene.evaluations.tell(*diagnosis);
    return scene.evaluations.record(own_ring(4)).avoidable_warnings;
  };
  Diagnosis diagnosis;
  EXPECT_EQ(warnings(std::nullopt), 0);
  for (const CarpentierType type : {CarpentierType::I, CarpentierType::II}) {
    diagnosis.types = {type};
    EXPECT_EQ(warnings(diagnosis), 1);
  }
  diagnosis.types = {CarpentierType::II, CarpentierType::IIIb};
  EXPECT_EQ(warnings(diagnosis), 0);
  diagnosis.types = {CarpentierType::I};
  diagnosis.type_sure = false;
  EXPECT_EQ(warnings(diagnosis), 0);
}

TEST(PlanEvaluations, PlansAtNearbyPlacesAreNearAndOtherKindsFar) {
  EvaluationScene scene(needs_suture);
  const auto apart = [&scene](const RepairPlan& a, const RepairPlan& b) {
    return (scene.evaluations.record(a).place - scene.evaluations.record(b).place).norm();
  };
  // The tip moves 0.5 mm: a quarter of its unit.
  EXPECT_NEAR(apart(kSuture, suture(Side::Posteromedial, 22.5)), 0.25, 1e-9);
  EXPECT_GT(apart(own_ring(1), own_ring(2)), 0.9);
  const RepairPlan neochorda = {{Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 20.0}}};
  EXPECT_GT(apart(neochorda, {}), 9.9);
}

}  // namespace
}  // namespace coapt::scene
