#pragma once

#include <vector>

#include "search/studies/findings.h"

namespace coapt {

std::vector<Finding> ring_findings(const RingStudy& study);

}  // namespace coapt
