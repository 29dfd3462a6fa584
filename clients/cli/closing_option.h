// How a command closes valves: --method, --membrane, --certainty, --converge and what belongs to it, --accuracy.
#pragma once

#include <optional>

#include "clients/cli/converge_option.h"
#include "core/closure/closure.h"
#include "operations/certainty.h"

namespace coapt {

struct ClosingOption {
  ClosureOptions closure;
  std::optional<double> accuracy_mm2;
  ConvergeOption converge;
  Certainty certainty = Certainty::Quick;
};

void add_closing_option(Command command, ClosingOption& option);

/// What is not as usual, into the fields of a request (operations/closing.h).
void add_closing(const ClosingOption& option, Json& request);

}  // namespace coapt
