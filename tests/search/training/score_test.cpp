#include "search/training/score.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

using enum Segment;

TrainingTrial trial(int number, bool right, double confidence, std::uint64_t seed = 1) {
  TrainingTrial made;
  made.block = number <= 2 ? "before" : "after";
  made.trial = number;
  made.seed = seed;
  made.judged = ChosenValve{right ? 2 : 1, 2};
  made.confidence = confidence;
  made.seconds = 10.0 * number;
  return made;
}

TEST(Score, OfAllTrialsAndOfEachBlock) {
  const auto scores = scores_of({trial(1, true, 1.0), trial(2, false, 0.5), trial(3, true, 0.5)});
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_FALSE(scores[0].block);
  EXPECT_EQ(scores[0].right, 2);
  EXPECT_DOUBLE_EQ(scores[0].brier, (0.0 + 0.25 + 0.25) / 3.0);
  EXPECT_DOUBLE_EQ(scores[0].seconds, 20.0);
  EXPECT_NEAR(scores[0].by_chance, 10.0 / 64.0, 1e-12);
  EXPECT_EQ(scores[1].block, "before");
  EXPECT_EQ(scores[2].block, "after");
  EXPECT_EQ(scores[2].right, 1);
}

TEST(Score, OfSegmentsCountsEight) {
  TrainingTrial judged;
  JudgedSegments segments;
  segments.choice.fill(Mobility::Normal);
  segments.answer.fill(Mobility::Normal);
  segments.answer[0] = Mobility::Tethered;
  judged.judged = segments;
  judged.confidence = 7.0 / 8.0;
  const auto scores = scores_of({judged});
  EXPECT_EQ(scores[0].answers, 8);
  EXPECT_EQ(scores[0].right, 7);
  EXPECT_DOUBLE_EQ(scores[0].chance, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(scores[0].brier, (7.0 / 64.0 + 49.0 / 64.0) / 8.0);
}

TEST(Score, BlocksComeInTheOrderOfTheTrialsAlsoWhereTheyAlternate) {
  const auto scores = scores_of({trial(2, true, 0.5), trial(3, true, 0.5), trial(1, false, 0.5)});
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_EQ(scores[1].block, "before");
  EXPECT_EQ(scores[1].trials, 2);
  EXPECT_EQ(scores[2].block, "after");
}

TEST(VisitingOrder, ARoundFromP1IsNoDistanceAndReturnsAreCounted) {
  const VisitingOrder surgeon = visiting_order({P1, AC, A1, P1, A2, A3, PC, P1, P3, P2});
  EXPECT_TRUE(surgeon.begins_at_p1);
  EXPECT_EQ(surgeon.segments, 8);
  EXPECT_EQ(surgeon.returns_to_p1, 2);
  EXPECT_EQ(surgeon.distance, 0);
}

TEST(VisitingOrder, ElsewhereARoundFromThereCounts) {
  const VisitingOrder round = visiting_order({A2, A3, PC, P3, P2, P1, AC, A1});
  EXPECT_FALSE(round.begins_at_p1);
  EXPECT_EQ(round.distance, 0);
  EXPECT_EQ(visiting_order({A2, A3, PC, P3, P2, P1, AC}).distance, 1);
  EXPECT_EQ(visiting_order({}).distance, 8);
}

TEST(Repetition, WhatFailedComesAgainAfterTwoThenFourThenEight) {
  const auto due = [](const std::vector<TrainingTrial>& trials) {
    const auto repeated = cases_to_repeat(trials);
    return repeated.empty() ? -1 : repeated.front().due_in;
  };
  std::vector<TrainingTrial> trials = {trial(1, false, 0.5, 9)};
  EXPECT_EQ(due(trials), 2);
  trials.push_back(trial(2, true, 0.5, 1));
  EXPECT_EQ(due(trials), 1);
  trials.push_back(trial(3, true, 0.5, 9));
  EXPECT_EQ(due(trials), 4);
  trials.push_back(trial(4, true, 0.5, 9));
  EXPECT_EQ(due(trials), 8);
  trials.push_back(trial(5, true, 0.5, 9));
  EXPECT_EQ(due(trials), -1);
}

}  // namespace
}  // namespace coapt
