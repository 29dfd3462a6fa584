// All operations.
#pragma once

#include <vector>

#include "operations/operation.h"

namespace coapt {

/// Those of valve_operations() first.
std::vector<Operation> operations();

}  // namespace coapt
