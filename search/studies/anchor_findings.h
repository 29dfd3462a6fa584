#pragma once

#include <vector>

#include "search/studies/findings.h"

namespace coapt {

/// Their names begin with the protocol.
std::vector<Finding> anchor_findings(const ApproximationStudy& study);

}  // namespace coapt
