// The one type of JSON. Two objects are equal if their members come in the same order, too, and a member is found by looking at
// those before it: an object of thousands is for writing, or is read by iterating.
#pragma once

#include <nlohmann/json.hpp>

#include "io/json/json_fwd.h"
