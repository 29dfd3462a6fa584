// What a learner's trials say (thesis 3.3, 5.2.4): how often right, against chance; how sure with reason; how fast, how far, how
// hard and in which order; ability, and which case comes next.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "search/training/ability.h"

namespace coapt {

/// How a valve was gone through, against kVisitingOrder.
struct VisitingOrder {
  int segments = 0;  ///< different ones, of eight
  bool begins_at_p1 = false;
  int returns_to_p1 = 0;
  /// Insertions, deletions and exchanges (Levenshtein 1966) that make it one round from P1, or from where it began, returns to P1 left out.
  int distance = 0;
};
VisitingOrder visiting_order(const std::vector<Segment>& visited);

struct Score {
  int learner = 1;
  bool segments = false;             ///< exam B
  std::optional<std::string> block;  ///< none: of all of them
  int trials = 0, answers = 0, right = 0;
  double chance = 0.25;
  std::array<double, 2> interval95{};  ///< of the share of right answers
  double by_chance = 1.0;              ///< probability of as many right ones by chance alone
  /// Mean over answers of the squared difference of the trial's confidence and 1 if the answer is right, 0 if it is wrong (Brier
  /// 1950): 0 best; who guesses and always says chance has chance (1 - chance).
  double brier = 0.0;
  double seconds = 0.0, path_mm = 0.0;  ///< mean of a trial
  double largest_n = 0.0;
  double visited_segments = 0.0, order_distance = 0.0, returns_to_p1 = 0.0;  ///< mean of a trial
  double begins_at_p1 = 0.0;                                                 ///< share of trials
  Ability ability;
};

/// Of each learner and exam: over all blocks, then by block in the order of the trials. @pre each learner's trials are in their order.
std::vector<Score> scores_of(const std::vector<TrainingTrial>& trials);

/// A case that a learner did not get right.
struct RepeatedCase {
  std::string valve;
  bool segments = false;  ///< exam B
  std::uint64_t seed = 1;
  int due_in = 0;  ///< trials from now; 0: next
};

/// Spaced repetition (Leitner 1972): a case not wholly right comes again after 2 other trials, and after 4 and 8 once it was right; then
/// it is known. The most urgent first. @param trials of one learner, in order.
std::vector<RepeatedCase> cases_to_repeat(const std::vector<TrainingTrial>& trials);

}  // namespace coapt
