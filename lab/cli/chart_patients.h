#pragma once

#include "io/command_line/command_line.h"

namespace coapt {

/// Charts of patients' valves: fits of twins, whole and with ruptured chordae, drawn chordae, Barlow's disease, anchors while disease goes on.
void add_twins(Command chart, int& status);
void add_ruptures(Command chart, int& status);
void add_drawn_chordae(Command chart, int& status);
void add_barlow(Command chart, int& status);
void add_durable_anchors(Command chart, int& status);

}  // namespace coapt
