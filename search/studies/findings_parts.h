// The findings, one function for each study.
#pragma once

#include <array>
#include <vector>

#include "search/studies/findings.h"

namespace coapt {

std::vector<Finding> annulus_findings(const AnnulusStudy& study);
std::vector<Finding> papillary_findings(const PapillaryStudy& study);
std::vector<Finding> belly_findings(const std::array<Vec3, 3>& shift_mm);
std::vector<Finding> ring_findings(const RingStudy& study);
/// Their names begin with the protocol.
std::vector<Finding> anchor_findings(const ApproximationStudy& study);

}  // namespace coapt
