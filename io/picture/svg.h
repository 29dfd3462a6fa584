// Elements that the charts are drawn from.
#pragma once

#include <string>

namespace coapt {

/// `attributes`: as they stand in the tag; `text` is escaped. Pixels, y downwards.
std::string text_at(double x, double y, const std::string& attributes, const std::string& text);

/// `style`: its class.
std::string line_at(const char* style, double x1, double y1, double x2, double y2);

}  // namespace coapt
