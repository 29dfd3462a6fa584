// Where new chordae would go, and how long they would be.
#pragma once

#include <vector>

#include "core/repair/plan.h"

namespace coapt {

/// Neochordae of one side with one length, as loops are made.
struct NeochordaGroup {
  std::vector<Neochorda> steps;
  double length_mm = 0.0;  ///< to start with
};

/// `count` (2 or 4) neochordae to the free edge where marginal chordae are ruptured, half of them
/// on either side of the middle of the lesion, each from the nearest head of the same half of the
/// valve. Length: the mean of the intact marginal chordae of that leaflet, from head to leaflet (of
/// all, if it has none). Empty if no marginal chorda is ruptured.
std::vector<NeochordaGroup> neochordae_for_ruptures(const Valve& valve, int count);

}  // namespace coapt
