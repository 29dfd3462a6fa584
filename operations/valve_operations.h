// The operations on one valve.
#pragma once

#include <span>

#include "operations/operation.h"

namespace coapt {

/// They need no files and no studies: every door has them, the browser's engine, too.
std::span<const Operation> valve_operations();

}  // namespace coapt
