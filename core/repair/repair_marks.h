// What a repair put into a valve, as pictures draw it over the closed leaflets.
#pragma once

#include <vector>

#include "core/repair/plan.h"

namespace coapt {

/// A suture from the middle of a papillary muscle's tips to the annulus; the muscle came to it.
struct SutureMark {
  Side side = Side::Anterolateral;
  Vec3 tip_before_mm = Vec3::Zero(), tip_mm = Vec3::Zero(), anchor_mm = Vec3::Zero();
};

/// In the valve's frame, which a repair does not move. Neochordae are among the valve's
/// chordae, ties are its own.
struct RepairMarks {
  /// |A| x 3, a loop: where the ring drew the annulus from; no rows: no ring.
  Points annulus_before_mm;
  std::vector<SutureMark> sutures;
  std::vector<std::vector<Insertion>> seams;  ///< of resections, to the free edge
};

/// @param repaired apply_plan() of the others.
RepairMarks repair_marks(const Valve& before, const Valve& repaired, const RepairPlan& plan);

}  // namespace coapt
