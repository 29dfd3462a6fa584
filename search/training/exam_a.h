// Exam A (thesis 3.2.2): four closed valves are shown, then one of them flaccid; which of the four does it become?
//
// Valves are drawn until four belong together: flaccid they look alike, closed they differ from each other, and each
// closes to the same shape at half the speed, so that a difference is the valve's and not the way's. Which of the four is the
// answer is drawn last, so that neither the order nor a rejection tells it.
#pragma once

#include <array>
#include <cstdint>

#include "core/closed/closed_valve.h"
#include "search/training/case_lesions.h"
#include "search/training/free_edge.h"

namespace coapt {

inline constexpr std::size_t kChoices = 4;
inline constexpr double kChanceA = 1.0 / kChoices;

/// How far two closed valves of one mesh are apart.
struct ClosedDifference {
  double edge_mm =
      0.0;  ///< rms over the vertices of the free edge, each to the same one of the other valve
  double leak_mm2 = 0.0;  ///< of the leaks, >= 0
};

struct ExamARules {
  /// Two flaccid valves are nearer than this (flaccid_difference_mm()): each is nearer than half of it to the valve without lesions,
  /// so that no valve is rejected for another one's sake.
  double flaccid_mm = 0.3;
  /// Two closed valves differ by at least one of these.
  double edge_mm = 1.0, leak_mm2 = 10.0;
  /// A valve closed at half the speed differs by no more than this share of those.
  double half_speed_share = 0.5;
  int most_draws = 120;  ///< of valves
  LesionRanges lesions{};
};

/// The larger of both differences over what two valves must differ by: 1 at the limit.
double scaled(const ClosedDifference& difference, const ExamARules& rules);

struct CaseChoice {
  CaseLesions lesions;
  ClosedValve closed;  ///< with its valve
  Points flaccid_mm;   ///< |V| x 3
  ClosedDifference half_speed;
};

struct ExamACase {
  std::uint64_t seed = 0;
  std::array<CaseChoice, kChoices> choices;
  std::size_t answer = 0;  ///< index of the choice that is shown flaccid
  std::array<std::array<ClosedDifference, kChoices>, kChoices> differences;  ///< symmetric
  double largest_flaccid_mm = 0.0;   ///< of two of the flaccid valves
  double smallest_difference = 0.0;  ///< scaled, of two of the closed valves
  /// Minus its natural logarithm: 0 where the two nearest differ just enough, less where all differ more. On the scale of
  /// abilities (ability.h), until learners have calibrated it.
  double difficulty = 0.0;
  int draws = 0;  ///< of valves, the four included
};

/// The same valve, seed and rules give the same case. Errors: a segment without a free edge, no chordae to change, or no four valves
/// found within the draws ("").
/// @pre validate(valve) is empty; the valve is mitral.
Expected<ExamACase> make_exam_a(const Valve& valve, std::uint64_t seed,
                                const ExamARules& rules = {});

/// @param closed_mm |V| x 3 each.
double edge_difference_mm(const FreeEdge& edge, const Points& closed_mm, const Points& other_mm);

}  // namespace coapt
