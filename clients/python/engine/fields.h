// What a closed valve bears, as arrays.
#pragma once

#include <pybind11/pybind11.h>

#include "core/closed/closed_valve.h"

namespace coapt {

/// Arrays of coapt.meshes.Fields, by its names; empty: it diverged.
pybind11::dict fields_of(const ClosedValve& closed);

}  // namespace coapt
