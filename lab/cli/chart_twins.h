#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

/// Charts of what is not seen of a valve: fits of twins, drawn chordae.
void add_twins(Command chart, int& status);
void add_drawn_chordae(Command chart, int& status);

}  // namespace coapt
