// Options of commands that close valves.
#pragma once

#include <optional>

#include "core/closure/accuracy.h"
#include "core/closure/closure.h"
#include "io/command_line/command_line.h"

namespace coapt {

/// --method.
void add_method_option(Command command, Method& method);

/// --membrane.
void add_membrane_option(Command command, Membrane& membrane);

/// --accuracy.
void add_accuracy_option(Command command, std::optional<double>& accuracy_mm2);

/// Puts the tolerances for --accuracy, if it was given, into `closure` and says on standard error which
/// they are. Errors point to "/accuracy".
Expected<std::optional<AccuracyTier>> apply_accuracy(std::optional<double> accuracy_mm2,
                                                     ClosureOptions& closure);

}  // namespace coapt
