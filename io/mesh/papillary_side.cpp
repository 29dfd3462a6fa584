#include "io/mesh/papillary_side.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <vector>

namespace coapt {

std::optional<Side> papillary_side(std::string_view text) {
  constexpr std::array<std::string_view, 5> kLateral = {"al", "alpm", "apm", "alp", "ant"};
  constexpr std::array<std::string_view, 4> kMedial = {"pmpm", "ppm", "pmp", "post"};
  std::vector<std::string> words(1);
  std::string letters;
  for (const unsigned char c : text) {
    if (std::isalpha(c) == 0) {
      if (!words.back().empty()) words.emplace_back();
      continue;
    }
    words.back() += static_cast<char>(std::tolower(c));
    letters += static_cast<char>(std::tolower(c));
  }
  const auto is_word = [&](std::span<const std::string_view> list) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return std::find(list.begin(), list.end(), word) != list.end();
    });
  };
  const auto has = [&](std::string_view part) { return letters.find(part) != std::string::npos; };
  const auto has_word = [&](std::string_view word) { return is_word(std::span(&word, 1)); };
  if (has("commissur") || has_word("alc") || has_word("pmc")) return {};
  // "Medial" and "lateral" tell it where "anterior" and "posterior" stand for front and back of one muscle.
  bool lateral = is_word(kLateral) || has("lateral"), medial = is_word(kMedial) || has("medial");
  if (!lateral && !medial) {
    lateral = has("anterior");
    medial = has("posterior");
  }
  // "PM" alone is the posteromedial one; beside another word, a papillary muscle.
  if (!lateral && !medial) {
    lateral = letters.starts_with("al");
    medial = letters.starts_with("pm") || has_word("pm");
  }
  if (lateral == medial) return {};
  return lateral ? Side::Anterolateral : Side::Posteromedial;
}

}  // namespace coapt
