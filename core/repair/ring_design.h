// A ring that was designed, with the rule by which its size is chosen.
#pragma once

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

struct RingDesign {
  DesignedShape shape;
  /// Sizing: the ring's width over the transverse diameter of the annulus before.
  double width_over_transverse = 0.9;

  bool operator==(const RingDesign&) const = default;
};

inline constexpr Range kRingWidthShares = {0.7, 1.05};

/// The size, of those on sale, whose width is nearest to the rule's.
double ring_size_mm(double width_over_transverse, double transverse_mm);

/// The ring in its size for this valve.
Annuloplasty sized_ring(const RingDesign& design, const Valve& valve);

/// Shape and rule; lists what is wrong. Paths as coapt.ring/1 has them.
Errors check_ring_design(const RingDesign& design);

}  // namespace coapt
