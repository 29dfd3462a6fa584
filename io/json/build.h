// Which build a program is, for reports of defects: with the same input these figures give the same bits.
#pragma once

#include <string_view>

#include "io/json/json.h"

namespace coapt {

/// "program", "version", "revision" (revision_json()), "instruction_set" that closures use on this machine, "compiler", "notice".
Json build_json(std::string_view program);

}  // namespace coapt
