// Exam B (thesis 3.2.4): is each of the eight segments tethered, normal or prolapsing?
//
// The truth is what valve analysis finds: each free edge is pulled towards the atrium without pressure, with the force of a nerve
// hook, and the height that it reaches is compared with that in the valve without lesions.
#pragma once

#include <array>
#include <cstdint>

#include "core/closed/closed_valve.h"
#include "search/training/case_lesions.h"
#include "search/training/flaccid.h"

namespace coapt {

enum class Mobility { Tethered, Normal, Prolapsing };
inline constexpr double kChanceB = 1.0 / 3.0;

const char* to_string(Mobility mobility);

struct ExamBRules {
  double pull_n = kAnalysisPull_n;
  /// Lower than the unlesioned valve by more than this is tethered, higher prolapsing.
  double limit_mm = 2.0;
  /// No segment's change is nearer to the limit than this, which is more than heights are uncertain by.
  double margin_mm = 0.25;
  /// Nearer than this to the unlesioned valve without pressure (flaccid_difference_mm()).
  double flaccid_mm = 0.3;
  /// Segments of each kind in a case, so that who always says "normal" gains little.
  int fewest_of_kind = 2;
  int most_draws = 200;  ///< of valves
  LesionRanges lesions{.fewest_segments = 4,
                       .most_segments = 6,
                       .shorter = {0.82, 0.88},
                       .longer = {1.1, 1.24},
                       .by_side = false,
                       .tip_share = 0.0};
};

struct SegmentTruth {
  Mobility mobility = Mobility::Normal;
  double height_mm = 0.0;  ///< reached
  double normal_mm = 0.0;  ///< in the valve without lesions
};

struct ExamBCase {
  std::uint64_t seed = 0;
  CaseLesions lesions;
  ClosedValve closed;                          ///< with its valve
  Points flaccid_mm;                           ///< |V| x 3
  std::array<SegmentTruth, kSegments> truths;  ///< by Segment
  double flaccid_difference_mm = 0.0;          ///< from the valve without lesions
  /// Smallest change of height of a segment that is not normal, over the limit.
  double smallest_difference = 0.0;
  double difficulty = 0.0;  ///< minus its natural logarithm, as of exam A
  int draws = 0;
};

/// Each case has segments of all three kinds. Errors as of make_exam_a(). @pre likewise.
Expected<ExamBCase> make_exam_b(const Valve& valve, std::uint64_t seed,
                                const ExamBRules& rules = {});

/// Of a change of height against the unlesioned valve.
Mobility mobility_of(double change_mm, double limit_mm);

}  // namespace coapt
