// The studies of displaced papillary muscles and rings as figures 4.6 to 4.9 of the thesis.
#pragma once

#include <string>

#include "search/studies/geometry_studies.h"

namespace coapt {

/// Figures 4.6 to 4.8: for each class orifice surfaces, and the gradient as arrows.
std::string papillary_svg(const PapillaryStudy& study);

/// Figure 4.9: orifice under a ring over that under the properly sized annulus.
std::string ring_svg(const RingStudy& study);

}  // namespace coapt
