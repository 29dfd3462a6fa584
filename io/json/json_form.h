// Whether a document of unknown origin has the form of one that was written here.
#pragma once

#include <string>

#include "io/json/json_fwd.h"

namespace coapt {

/// The pointer to what differs first in form: a member of `example` that is missing, or a value of another type; empty if nothing
/// does. Elements of an array are held against the first of the example's. Null stands for anything, and anything for null.
std::string differs_in_form(const Json& example, const Json& json);

}  // namespace coapt
