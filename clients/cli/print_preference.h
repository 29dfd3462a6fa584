#pragma once

#include <iosfwd>

#include "io/json/json_fwd.h"

namespace coapt {

/// The two plans of a question of coapt.question/1, side by side in at most 100 columns.
void print_question(std::ostream& out, const Json& question);

/// Of coapt.weights/1: what answers say of each price, and of which they say little.
void print_weights(std::ostream& out, const Json& learned);

}  // namespace coapt
