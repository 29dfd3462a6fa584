// How many answers it takes to know an expert's weights: simulated experts are asked about the plans of some cases, by informative
// pairs and by random ones; what was learned then ranks the plans of other cases.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/preference/simulated_expert.h"

namespace coapt {

struct PreferenceStudyOptions {
  int experts = 100;  ///< of either noise
  int answers = 40;
  std::uint64_t seed = 3;
  int threads = 0;  ///< 0: all cores; does not change the result
};

/// How pairs are chosen.
enum class Asking { Informative, Random };
const char* to_string(Asking asking);

/// What was known after some answers.
struct PreferenceOutcome {
  int expert = 0;
  ExpertNoise noise = ExpertNoise::Model;
  Asking asking = Asking::Informative;
  int answers = 0;
  double regret_mm2 = 0.0;           ///< mean over the cases asked about
  double held_out_regret_mm2 = 0.0;  ///< mean over the others
  int covered = 0;  ///< of kLearnedTerms true weights, within their intervals of 90 %
  int informed = 0, informed_covered = 0;
};

/// Outcomes after 0, 5, 10, ... answers of each expert, in order. @param asked, held_out cases with plans.
std::vector<PreferenceOutcome> study_preference(const std::vector<PlanCase>& asked,
                                                const std::vector<PlanCase>& held_out,
                                                const PreferenceStudyOptions& options = {},
                                                const std::function<void(int, int)>& progress = {});

/// Columns: expert, noise, asking, answers, regret_mm2, held_out_regret_mm2, covered, informed, informed_covered.
std::string preference_csv(const std::vector<PreferenceOutcome>& outcomes);

/// Over the experts after so many answers.
struct PreferenceSummary {
  ExpertNoise noise = ExpertNoise::Model;
  Asking asking = Asking::Informative;
  int answers = 0;
  int experts = 0;
  double regret_mm2 = 0.0;  ///< mean
  double held_out_regret_mm2 = 0.0, held_out_regret_sd_mm2 = 0.0;
  double below_half = 0.0;  ///< share of experts with a held-out regret below 0.5 mm2
  double covered = 0.0;     ///< share of the true weights
  double informed = 0.0;    ///< weights, mean
  double informed_covered = 0.0;
};
std::vector<PreferenceSummary> summaries(const std::vector<PreferenceOutcome>& outcomes);

}  // namespace coapt
