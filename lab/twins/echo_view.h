// A closed valve as an echocardiogram would show it: the atrial side alone, with noise, holes and smoothing.
#pragma once

#include <cstdint>

#include "core/closed/closed_valve.h"

namespace coapt {

struct EchoOptions {
  double spacing_mm = 0.7;    ///< of rays from the atrium
  double noise_mm = 0.5;      ///< sd, of each point along the surface's normal
  double hole_mm = 2.0;       ///< diameter of places that show nothing
  double holes_share = 0.1;   ///< of the surface, about
  double smoothing_mm = 1.0;  ///< sd of a Gaussian over the neighbours, after the noise
};

/// Points of the leaflets' atrial surface that rays along the valve's axis meet first, n x 3, in the valve's frame. The
/// same arguments give the same points.
Points echo_view(const ClosedValve& closed, const EchoOptions& options, std::uint64_t seed);

}  // namespace coapt
