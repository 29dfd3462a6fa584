#include "core/repair/ring_design.h"

#include <algorithm>
#include <cmath>

#include "core/repair/annuloplasty.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {

double ring_size_mm(double width_over_transverse, double transverse_mm) {
  const double sizes = std::round(width_over_transverse * transverse_mm / kRingSizeStep_mm);
  return std::clamp(kRingSizeStep_mm * sizes, kRingSizesMm.min, kRingSizesMm.max);
}

Annuloplasty sized_ring(const RingDesign& design, const Valve& valve) {
  const double transverse = transverse_diameter_mm(valve);
  return {DesignedRing{design.shape, ring_size_mm(design.width_over_transverse, transverse)}};
}

Errors check_ring_design(const RingDesign& design) {
  ProblemList problems;
  check_designed_shape(design.shape, "/ring", problems);
  check_range(problems, "/sizing/width_over_transverse", design.width_over_transverse,
              kRingWidthShares);
  return std::move(problems).take();
}

}  // namespace coapt
