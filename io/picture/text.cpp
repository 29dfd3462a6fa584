#include "io/picture/text.h"

#include <cmath>

namespace coapt {

std::string grouped(std::int64_t count) {
  std::string text = std::to_string(count);
  const std::size_t sign = count < 0 ? 1 : 0;
  for (std::size_t at = text.size(); at > sign + 3;) text.insert(at -= 3, 1, ',');
  return text;
}

std::string percent(double share) {
  if (!std::isfinite(share)) return fixed(share, 0);
  const double value = 100.0 * share;
  const bool near_an_end = (value > 0.0 && value < 10.0) || (value > 90.0 && value < 100.0);
  return fixed(value, near_an_end ? 1 : 0) + " %";
}

std::string escape_html(std::string_view text) {
  std::string safe;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

}  // namespace coapt
