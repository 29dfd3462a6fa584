#include "lab/preference/preference_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

PlanCase case_of(std::initializer_list<std::pair<double, double>> steps_and_leaks) {
  PlanCase plans;
  for (const auto& [steps, leak_mm2] : steps_and_leaks) {
    ComparedPlan plan;
    plan.terms[CostTerm::Step] = steps;
    plan.terms[CostTerm::Leak] = leak_mm2;
    plans.plans.push_back(plan);
  }
  return plans;
}

TEST(SimulatedExpert, RegretIsWhatTheWrongPlanCostsMore) {
  const PlanCase plans = case_of({{0.0, 3.0}, {2.0, 0.0}});
  CostWeights expert;
  expert.step = 2.0;  // 3 against 4 mm2; today's weights say 3 against 2
  EXPECT_DOUBLE_EQ(regret_mm2(plans, {}, expert), 1.0);
  EXPECT_DOUBLE_EQ(regret_mm2(plans, expert, expert), 0.0);
}

TEST(SimulatedExpert, OneAnswerInTenIsWrong) {
  SimulatedExpert expert{ExpertNoise::Flips, prior_mean({})};
  CostTerms worse;
  worse[CostTerm::Leak] = 5.0;
  std::mt19937_64 engine(1);
  int wrong = 0;
  for (int i = 0; i < 2000; ++i)
    wrong += answer(expert, worse, engine) == Preference::First ? 1 : 0;
  EXPECT_NEAR(wrong / 2000.0, kFlippedShare, 0.02);
}

TEST(PreferenceStudy, IsTheSameOnAnyNumberOfThreadsAndStartsAtThePrior) {
  const std::vector<PlanCase> cases = {
      case_of({{0.0, 3.0}, {1.0, 1.5}, {2.0, 0.6}, {3.0, 0.0}, {4.0, 0.1}})};
  PreferenceStudyOptions options;
  options.experts = 2;
  options.answers = 5;
  options.threads = 1;
  const auto one = study_preference(cases, cases, options);
  options.threads = 2;
  EXPECT_EQ(preference_csv(one), preference_csv(study_preference(cases, cases, options)));
  ASSERT_EQ(one.size(), 16u) << "2 experts, 2 noises, 2 ways to ask, after 0 and 5 answers";
  EXPECT_EQ(one[0].informed, 0);
  EXPECT_EQ(one[0].regret_mm2, one[0].held_out_regret_mm2);
  EXPECT_EQ(summaries(one).size(), 8u);
}

}  // namespace
}  // namespace coapt
