// --ring FILE or FILE:SIZE: a designed ring (coapt.ring/1), in the size that its rule gives for the valve, or in that one.
#pragma once

#include <string>

#include "core/repair/ring_design.h"
#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

inline constexpr const char* kRingHelp =
    "Implant a designed ring (coapt.ring/1) in the size of its sizing rule, or in SIZE mm";

/// The design in a file, whether or not a size follows its name. Messages begin with the file.
Expected<RingDesign> read_ring_argument(const std::string& argument);

/// The ring's step. @param valve may be null: then a size must be given.
Expected<RepairStep> read_ring_step(const std::string& argument, const Valve* valve);

}  // namespace coapt
