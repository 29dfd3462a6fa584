// Options of commands that close valves.
#pragma once

#include "core/closure/closure.h"
#include "io/command_line/command_line.h"

namespace coapt {

/// --method.
void add_method_option(Command command, Method& method);

/// --membrane.
void add_membrane_option(Command command, Membrane& membrane);

}  // namespace coapt
