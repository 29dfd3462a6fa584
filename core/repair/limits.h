// What repair steps accept, and what practice accepts of them: each number once, for the steps, the
// readers of plans, the search and its warnings. io/schema/plan.schema.json says the same (a test
// compares).
#pragma once

#include "core/valve/problem_list.h"

namespace coapt {

// Accepted; outside, a step is refused.
inline constexpr Range kRingSizesMm = {24.0, 40.0};  ///< labelled, catalogue shapes
inline constexpr double kRingSizeStep_mm = 2.0;      ///< one size, of the transverse dimension
inline constexpr Range kSizesBelow = {0.0, 6.0};     ///< own ring
inline constexpr double kLeastOwnRing = 0.5;         ///< of the transverse diameter must remain
inline constexpr Range kNeochordaMm = {5.0, 40.0};
inline constexpr Range kLengthChangeMm = {-20.0, 20.0};
inline constexpr Range kSutureMm = {12.0, 100.0};  ///< papillary approximation
inline constexpr double kLeastSutureShare = 0.5;   ///< of the present distance, at least
inline constexpr Range kEdgeAlong = {0.05, 0.95};  ///< edge-to-edge: not in a commissure
inline constexpr Range kEdgeWidthMm = {2.0, 15.0};
inline constexpr Range kGraspMm = {2.0, 12.0};  ///< the longest arms
inline constexpr Range kClipRows = {1.0, 5.0};
inline constexpr Range kDrawnInPercent = {0.0, 25.0};
// Leaflet resection. A wedge's base at the posterior free edge is 10 to 15 mm as a rule; of the
// anterior leaflet little may go (its range and the least widths are assumed).
inline constexpr Range kTriangularMm = {3.0, 20.0};
inline constexpr Range kAnteriorTriangularMm = {3.0, 10.0};
inline constexpr Range kQuadrangularMm = {3.0, 30.0};
inline constexpr double kMostResected = 1.0 / 3.0;  ///< of the posterior annulus (Carpentier 1983)
/// The annulus gathered without sliding; wider gaps are slid (assumed).
inline constexpr double kMostPlicated_mm = 15.0;
inline constexpr Range kResectionAlong = {0.15, 0.85};  ///< of the middle: not in a commissure
inline constexpr Range kTriangularHeight = {0.3, 0.95};
/// Of the leaflet between cut and commissure that must be left (assumed).
inline constexpr double kLeastBeside = 0.5;
inline constexpr Range kShare = {0.0, 1.0};  ///< leaflet coordinates, place on the annulus

// Usual; outside, the search does not look and a plan is warned of.
inline constexpr double kMostSizesBelow = 4.0;  ///< more is rejected in practice
/// Where nothing tethers the leaflets: the true size or the next below it. Full sizes of 33.0 +- 3.0 and 33.6 +- 3.4 mm were taken for
/// prolapse of P2 (CAMRA CardioLink-2), 36 to 40 mm for Barlow's disease (Adams 2006).
inline constexpr double kMostSizesBelowUntethered = 1.5;
inline constexpr Range kUsualSizesBelow = {2.0, kMostSizesBelow};
inline constexpr double kStenoticRing_mm = 27.0;  ///< labelled; this or less predicts stenosis
/// From a papillary tip to its trigone, 57 cadavers: mean, sd and their sum, up to which is normal.
inline constexpr double kTipToTrigone_mm = 23.5, kTipToTrigoneSd_mm = 3.8;
inline constexpr double kMostNormalTipToTrigone_mm = kTipToTrigone_mm + kTipToTrigoneSd_mm;
inline constexpr Range kUsualNeochordaMm = {10.0, 30.0};
inline constexpr double kUsualMovement_mm = 10.0;     ///< papillary relocation: more is unusual
inline constexpr double kRejectedMovement_mm = 15.0;  ///< more is rejected in practice

/// "24 to 40".
inline std::string shown(Range range) { return shown(range.min) + " to " + shown(range.max); }

}  // namespace coapt
