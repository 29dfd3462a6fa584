// Raters without eyes and hands: they show what an exam measures before anybody has sat it.
//
// Who answers at random must be at chance, who knows all right. Who looks at the flaccid valve alone must be at chance, too, or the
// cases leak their answers; who pulls each segment must be far above it, or pulling tells nothing.
#pragma once

#include <cstdint>
#include <random>

#include "search/training/exam_a.h"
#include "search/training/exam_b.h"

namespace coapt {

/// What is known of the valve without lesions, to a rater who has handled it.
struct KnownValve {
  FreeEdge edge;
  Points flaccid_mm;            ///< |V| x 3
  Points closed_mm;             ///< |V| x 3
  SegmentHeights heights_mm{};  ///< pulled
};
/// @pre free_edge() of the valve is no error.
KnownValve known_valve(const Valve& valve);

struct Eyes {
  /// Standard deviation of each coordinate of a segment's mean place that is seen, mm. 0.3 is what the thesis calls visually
  /// undetectable, as a number; 0 reads the computer's own digits.
  double error_mm = 0.3;
};

/// Sees how the flaccid valve lies at each segment's free edge against the unlesioned one, and takes the closed valve whose free edge
/// lies apart from the unlesioned closed one in the most similar direction: the choice with the largest cosine over segments and axes.
std::size_t choose_by_looking(const ExamACase& made, const KnownValve& known, const Eyes& eyes,
                              std::mt19937_64& engine);

/// Pulls the middle of each segment's free edge of the valve that is shown, and takes the closed valve that stands high where the segment gives and
/// low where it is held: the choice with the largest cosine of both changes of height over the segments. `error_mm`: standard deviation
/// of a height that is felt.
std::size_t choose_by_pulling(const ExamACase& made, const KnownValve& known, double error_mm,
                              std::mt19937_64& engine);

/// Of exam B. Looking: from how high each segment's free edge lies, over the spread of all; pulling: from heights felt with an error.
std::array<Mobility, kSegments> judge_by_looking(const ExamBCase& made, const KnownValve& known,
                                                 const Eyes& eyes, std::mt19937_64& engine);
std::array<Mobility, kSegments> judge_by_pulling(const ExamBCase& made, double error_mm,
                                                 double limit_mm, std::mt19937_64& engine);

}  // namespace coapt
