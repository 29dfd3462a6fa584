// Weights learned from an expert's answers, as JSON (coapt.weights/1).
#pragma once

#include <optional>
#include <string_view>

#include "core/valve/types.h"
#include "io/json/json.h"
#include "search/preference/posterior.h"

namespace coapt {

struct LearnedWeights {
  PreferencePosterior posterior;
  CostWeights weights;  ///< as a search takes them, those that are not learned among them
};

/// What the answers were like.
struct AnswerCounts {
  int answers = 0;
  int unable = 0;                     ///< of these
  std::optional<double> consistency;  ///< see raters.h
};

/// Keys that scripts rely on: weights (each name of CostWeights), noise_mm2, tie, log_sd and covariance (of natural logarithms, by
/// name), informed (names), answers, unable, consistency (null without repeats).
Json to_json(const LearnedWeights& learned, const AnswerCounts& counts);

/// Without the counts. Errors: a covariance that is none, a learned weight of 0.
Expected<LearnedWeights> read_learned_weights(std::string_view text);

/// Puts into each plan of a coapt.plans/2 how likely an expert prefers it to the next one (preferred_over_next; null
/// for the last), averaged over the posterior.
void add_preferred_over_next(Json& result, const PreferencePosterior& posterior);

}  // namespace coapt
