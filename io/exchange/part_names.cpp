#include "io/exchange/part_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <vector>

namespace coapt {
namespace {

// Those of SlicerHeart's leaflet models and of papers: anterior mitral (valve) leaflet.
constexpr std::array<std::string_view, 4> kAnterior = {"ant", "aml", "amvl", "a"};
constexpr std::array<std::string_view, 4> kPosterior = {"post", "pml", "pmvl", "p"};

/// In lower case, between what is neither letter nor digit.
std::vector<std::string> words_in(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) != 0)
      words.back() += static_cast<char>(std::tolower(c));
    else if (!words.back().empty())
      words.emplace_back();
  }
  return words;
}

}  // namespace

std::optional<NamedPart> part_named(std::string_view name) {
  const std::vector<std::string> words = words_in(name);
  const auto part_of_word = [&](std::string_view part) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return word.find(part) != std::string::npos;
    });
  };
  const auto word_of = [&](std::span<const std::string_view> list) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return std::find(list.begin(), list.end(), word) != list.end();
    });
  };
  constexpr std::array<std::string_view, 1> kRing = {"ring"};
  constexpr std::array<std::string_view, 2> kTip = {"tip", "tips"};
  if (part_of_word("annul") || word_of(kRing)) return NamedPart::Annulus;
  if (part_of_word("chord")) return NamedPart::Chordae;
  if (part_of_word("papill") || word_of(kTip)) return NamedPart::Tips;
  if (part_of_word("commissur")) return {};
  const bool anterior = part_of_word("anterior") || word_of(kAnterior);
  const bool posterior = part_of_word("posterior") || word_of(kPosterior);
  if (anterior == posterior) return {};
  return anterior ? NamedPart::Anterior : NamedPart::Posterior;
}

}  // namespace coapt
