// What is done to a valve to make a case of it: lengths of chordae and places of papillary tips, nothing else, so that
// leaflets and annulus tell nothing (thesis 3.2.2).
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

/// All intact native chordae of a segment, of one muscle or of both.
struct ChordaeLesion {
  Segment segment = Segment::P2;
  std::optional<Side> side{};  ///< none: of both
  double factor = 1.0;         ///< on all their rest lengths
};

/// All heads of one muscle, under pressure.
struct TipLesion {
  Side side = Side::Anterolateral;
  Vec3 moved_mm = Vec3::Zero();  ///< in the valve's frame
};

struct CaseLesions {
  std::vector<ChordaeLesion> chordae;
  std::vector<TipLesion> tips;
};

/// What lesions are drawn from, uniformly. Defaults are what moves a free edge of the presets by a few mm when it is pulled or
/// closes, and leaves the flaccid valve as it was (docs/training.md).
struct LesionRanges {
  int fewest_segments = 1, most_segments = 3;
  Range shorter{0.84, 0.94}, longer{1.06, 1.22};  ///< factors
  bool by_side = true;     ///< chordae of one muscle alone, too, where a segment has some of both
  double tip_share = 0.5;  ///< of valves, that have one muscle displaced
  double tip_mm = 4.0;     ///< along each axis, at most
};

/// The segment that a chorda belongs to: that of its insertion nearest to the mean of them all.
Segment segment_of(const Valve& valve, const Chorda& chorda);

/// Segments that have chordae which a lesion may change, ascending.
std::vector<Segment> segments_with_chordae(const Valve& valve);

/// Other draws with the same engine give other lesions. No segment twice. @pre `segments` is not empty.
CaseLesions draw_lesions(const Valve& valve, const std::vector<Segment>& segments,
                         const LesionRanges& ranges, std::mt19937_64& engine);

/// Errors: what validate() refuses, of a valve near its limits. @pre validate(valve) is empty.
Expected<Valve> with_lesions(const Valve& valve, const CaseLesions& lesions);

}  // namespace coapt
