// What the studies of the annulus, of displaced papillary muscles and of the belly show.
#pragma once

#include <array>
#include <vector>

#include "search/studies/findings.h"

namespace coapt {

std::vector<Finding> annulus_findings(const AnnulusStudy& study);
std::vector<Finding> papillary_findings(const PapillaryStudy& study);
std::vector<Finding> belly_findings(const std::array<Vec3, 3>& shift_mm);

}  // namespace coapt
