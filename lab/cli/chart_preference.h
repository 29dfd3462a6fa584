#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

/// What is learned from simulated experts' answers on the plans of lab/preference/cases.
void add_preference(Command chart, int& status);

}  // namespace coapt
