// Whether a Valve is one: every reason why it is not, as JSON pointers of the format coapt.valve/1.
#pragma once

#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

/// All problems of topology, references, ranges and geometry, in the order of the file; empty if
/// the valve can be closed. Never throws; cost O(|V| + |F|). At most 200 are listed, then a last
/// one says how many more there are.
Errors validate(const Valve& valve);

/// The same, before the last one is added.
ProblemList problems_in(const Valve& valve);

}  // namespace coapt
