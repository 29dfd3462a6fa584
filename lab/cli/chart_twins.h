#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

void add_twins(Command chart, int& status);

}  // namespace coapt
