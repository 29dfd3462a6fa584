#include "core/valve/printable.h"

#include <algorithm>
#include <cstddef>

namespace coapt {
namespace {

/// Length of the valid UTF-8 sequence that `text` starts with, 0 if it starts with none (RFC 3629).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool overlong = first == 0xE0 && second < 0xA0;
    const bool surrogate = first == 0xED && second > 0x9F;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool out_of_range = (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
    return continues(1) && continues(2) && continues(3) && !out_of_range ? 4 : 0;
  }
  return 0;
}

/// What moves a terminal or turns the order of what follows: C0, DEL, C1, and the signs that override direction.
bool is_control(std::string_view letter) {
  if (letter.size() == 1) {
    const auto code = static_cast<unsigned char>(letter[0]);  // a char is unsigned on ARM
    return code < 0x20 || code == 0x7F;
  }
  if (letter.size() == 2) return letter >= "\xC2\x80" && letter <= "\xC2\x9F";
  return (letter >= "\xE2\x80\xAA" && letter <= "\xE2\x80\xAE") ||
         (letter >= "\xE2\x81\xA6" && letter <= "\xE2\x81\xA9");
}

}  // namespace

std::string printable(std::string_view text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text.substr(i));
    if (length == 0) {
      clean += "\xEF\xBF\xBD";  // the replacement character
    } else if (is_control(text.substr(i, length))) {
      clean += ' ';
    } else {
      clean += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return clean;
}

std::string printable_lines(std::string_view text) {
  std::string clean;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    clean += printable(text.substr(begin, end - begin));
    if (end < text.size()) clean += '\n';
    begin = end + 1;
  }
  return clean;
}

}  // namespace coapt
