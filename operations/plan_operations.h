// The operations that search.
#pragma once

#include <span>

#include "operations/operation.h"

namespace coapt {

/// For browsers in the larger of the two modules.
std::span<const Operation> plan_operations();

}  // namespace coapt
