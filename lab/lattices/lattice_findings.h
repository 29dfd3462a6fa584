// What solved lattices say of rings and anchors.
#pragma once

#include <vector>

#include "lab/lattices/lattice_benchmark.h"

namespace coapt {

/// Plans with a ring that close the valve as planned (leak below 1 mm2), by how much smaller it makes the
/// annulus (Effort::sizes_below).
struct RingTightness {
  double from = 0.0, to = 0.0;  ///< sizes
  int closing = 0;              ///< as planned
  int robust = 0;               ///< of these: mean + sd below 1 mm2, no failure over the 17 nodes
  double sd_mm2 = 0.0;          ///< mean over these of the leak's sd
};

/// Pairs of plans that differ in one anchor: the muscle moved as far, to its trigone or to the saddle peak.
struct AnchorPairs {
  int pairs = 0;            ///< of which one at least closes the valve as planned
  int trigone_cheaper = 0;  ///< smaller cost
  int trigone_tighter = 0;  ///< smaller sd of the leak
  double cost_difference = 0.0, mean_difference_mm2 = 0.0,
         sd_difference_mm2 = 0.0;  ///< trigone less saddle peak, medians
};

struct LatticeFindings {
  std::vector<RingTightness> rings;
  AnchorPairs anchors;
};

LatticeFindings findings_of(const SolvedLattice& lattice);

}  // namespace coapt
