// Words and numbers on their way into pictures and HTML.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/metrics/estimate_text.h"
#include "core/valve/counted.h"
#include "core/valve/printable.h"

namespace coapt {

/// "45,678,901".
std::string grouped(std::int64_t count);

/// A share of 1: "62 %"; with a decimal near nothing and all, "99.2 %"; "n/a" if not finite.
std::string percent(double share);

/// printable(), and safe in HTML text and quoted attributes.
std::string escape_html(std::string_view text);

}  // namespace coapt
