#include "lab/preference/preference_study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "core/metrics/mean_and_sd.h"
#include "search/parallel.h"
#include "search/preference/question.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr double kInterval90 = 1.6448536269514722;  // sds of a normal distribution
constexpr int kEvery = 5;                           // answers between outcomes
constexpr double kSmallRegret_mm2 = 0.5;

double mean_regret_mm2(const std::vector<PlanCase>& cases, const CostWeights& weights,
                       const CostWeights& expert) {
  double sum = 0.0;
  for (const PlanCase& plans : cases) sum += regret_mm2(plans, weights, expert);
  return sum / static_cast<double>(cases.size());
}

/// Of all pairs with a difference that were not asked, alike.
PlanPair random_pair(const std::vector<PlanCase>& cases, const std::vector<GivenAnswer>& given,
                     std::mt19937_64& engine) {
  std::set<PlanPair> asked;
  for (const GivenAnswer& of : given) asked.insert(in_order(of).pair);
  std::vector<PlanPair> left;
  for (int c = 0; c < std::ssize(cases); ++c) {
    const auto plans = static_cast<int>(cases[static_cast<std::size_t>(c)].plans.size());
    for (int first = 0; first < plans; ++first)
      for (int second = first + 1; second < plans; ++second)
        if (!asked.contains({c, first, second}) &&
            (difference({c, first, second}, cases).amounts != 0.0).any())
          left.push_back({c, first, second});
  }
  return left[static_cast<std::size_t>(random_share(engine) * static_cast<double>(left.size()))];
}

struct StudyCases {
  const std::vector<PlanCase>&asked, &held_out;
};

PreferenceOutcome outcome_of(const StudyCases& cases, const PreferencePosterior& posterior,
                             const SimulatedExpert& expert, PreferenceOutcome outcome) {
  const CostWeights learned = learned_weights(posterior);
  const CostWeights truth = learned_weights({expert.truth, UnknownsMatrix::Identity()});
  outcome.regret_mm2 = mean_regret_mm2(cases.asked, learned, truth);
  outcome.held_out_regret_mm2 = mean_regret_mm2(cases.held_out, learned, truth);
  const Unknowns sd = log_sd(posterior);
  const std::vector<bool> said = informed(posterior);
  for (int term = 0; term < kLearnedTerms; ++term) {
    const bool within =
        std::abs(expert.truth[term] - posterior.mean[term]) <= kInterval90 * sd[term];
    outcome.covered += within ? 1 : 0;
    if (!said[static_cast<std::size_t>(term)]) continue;
    ++outcome.informed;
    outcome.informed_covered += within ? 1 : 0;
  }
  return outcome;
}

/// The same expert answers both ways of asking.
std::vector<PreferenceOutcome> interview(const StudyCases& cases,
                                         const PreferenceStudyOptions& options,
                                         PreferenceOutcome of) {
  std::seed_seq seeds{options.seed, static_cast<std::uint64_t>(of.expert),
                      static_cast<std::uint64_t>(of.noise)};
  std::mt19937_64 engine(seeds);
  const SimulatedExpert expert = drawn_expert(of.noise, engine);
  std::vector<PreferenceOutcome> outcomes;
  for (const Asking asking : {Asking::Informative, Asking::Random}) {
    of.asking = asking;
    std::vector<GivenAnswer> given;
    for (of.answers = 0;; ++of.answers) {
      const PreferencePosterior posterior = learn_preferences(comparisons(given, cases.asked));
      if (of.answers % kEvery == 0) outcomes.push_back(outcome_of(cases, posterior, expert, of));
      if (of.answers == options.answers) break;
      const PlanPair pair = asking == Asking::Random
                                ? random_pair(cases.asked, given, engine)
                                : next_question(cases.asked, given, draw(posterior))->pair;
      given.push_back({pair, answer(expert, difference(pair, cases.asked), engine)});
    }
  }
  return outcomes;
}

}  // namespace

const char* to_string(Asking asking) {
  return asking == Asking::Informative ? "informative" : "random";
}

std::vector<PreferenceOutcome> study_preference(const std::vector<PlanCase>& asked,
                                                const std::vector<PlanCase>& held_out,
                                                const PreferenceStudyOptions& options,
                                                const std::function<void(int, int)>& progress) {
  const StudyCases cases{asked, held_out};
  std::vector<PreferenceOutcome> all;
  for (int expert = 0; expert < options.experts; ++expert) {
    if (progress) progress(expert, options.experts);
    std::vector<std::vector<PreferenceOutcome>> of_noise(2);
    for_each_index(2, options.threads, [&](int i) {
      PreferenceOutcome of;
      of.expert = expert;
      of.noise = i == 0 ? ExpertNoise::Model : ExpertNoise::Flips;
      of_noise[static_cast<std::size_t>(i)] = interview(cases, options, of);
    });
    for (const auto& outcomes : of_noise) all.insert(all.end(), outcomes.begin(), outcomes.end());
  }
  if (progress) progress(options.experts, options.experts);
  return all;
}

std::string preference_csv(const std::vector<PreferenceOutcome>& outcomes) {
  std::ostringstream out;
  out << "expert,noise,asking,answers,regret_mm2,held_out_regret_mm2,covered,informed,"
         "informed_covered\n";
  for (const PreferenceOutcome& of : outcomes)
    out << of.expert << ',' << to_string(of.noise) << ',' << to_string(of.asking) << ','
        << of.answers << ',' << of.regret_mm2 << ',' << of.held_out_regret_mm2 << ',' << of.covered
        << ',' << of.informed << ',' << of.informed_covered << '\n';
  return out.str();
}

std::vector<PreferenceSummary> summaries(const std::vector<PreferenceOutcome>& outcomes) {
  std::map<std::tuple<ExpertNoise, Asking, int>, std::vector<PreferenceOutcome>> groups;
  for (const PreferenceOutcome& of : outcomes)
    groups[{of.noise, of.asking, of.answers}].push_back(of);
  std::vector<PreferenceSummary> all;
  for (const auto& [key, group] : groups) {
    PreferenceSummary summary;
    std::tie(summary.noise, summary.asking, summary.answers) = key;
    summary.experts = static_cast<int>(group.size());
    std::vector<double> regrets, held_out;
    int informed = 0, covered = 0, informed_covered = 0;
    for (const PreferenceOutcome& of : group) {
      regrets.push_back(of.regret_mm2);
      held_out.push_back(of.held_out_regret_mm2);
      covered += of.covered;
      informed += of.informed;
      informed_covered += of.informed_covered;
    }
    const auto small = std::count_if(held_out.begin(), held_out.end(),
                                     [](double regret) { return regret < kSmallRegret_mm2; });
    summary.regret_mm2 = mean_and_sd(regrets).mean;
    summary.held_out_regret_mm2 = mean_and_sd(held_out).mean;
    summary.held_out_regret_sd_mm2 = mean_and_sd(held_out).sd;
    summary.below_half = static_cast<double>(small) / summary.experts;
    summary.covered = static_cast<double>(covered) / (summary.experts * kLearnedTerms);
    summary.informed = static_cast<double>(informed) / summary.experts;
    summary.informed_covered =
        informed > 0 ? static_cast<double>(informed_covered) / informed : 0.0;
    all.push_back(summary);
  }
  return all;
}

}  // namespace coapt
