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

constexpr std::array<std::string_view, 3> kAnteriorScallops = {"a1", "a2", "a3"};
constexpr std::array<std::string_view, 3> kPosteriorScallops = {"p1", "p2", "p3"};
constexpr std::string_view kMitral = "mitral";
constexpr std::array<std::string_view, 7> kMitralWords = {"mv",   "aml", "pml", "amvl",
                                                          "pmvl", "mva", "ma"};

/// The words of a name, in lower case: what stands between what is neither letter nor digit.
class NameWords {
 public:
  explicit NameWords(std::string_view name) : words_(1) {
    for (const char letter : name) {
      const auto c = static_cast<unsigned char>(letter);
      if (std::isalnum(c) != 0)
        words_.back() += static_cast<char>(std::tolower(c));
      else if (!words_.back().empty())
        words_.emplace_back();
    }
  }

  bool has_part(std::string_view part) const {
    return std::any_of(words_.begin(), words_.end(), [&](const std::string& word) {
      return word.find(part) != std::string::npos;
    });
  }
  bool has_any(std::span<const std::string_view> list) const {
    return std::any_of(words_.begin(), words_.end(), [&](const std::string& word) {
      return std::find(list.begin(), list.end(), word) != list.end();
    });
  }

 private:
  std::vector<std::string> words_;
};

}  // namespace

std::optional<NamedPart> part_named(std::string_view name) {
  const NameWords words(name);
  constexpr std::array<std::string_view, 4> kRing = {"ring", "ma", "mva", "hinge"};
  constexpr std::array<std::string_view, 2> kTip = {"tip", "tips"};
  constexpr std::array<std::string_view, 5> kOtherValves = {"tricuspid", "septal", "aortic",
                                                            "pulmon", "coronar"};
  // Of the tricuspid valve; of the aortic one.
  constexpr std::array<std::string_view, 8> kOtherLeaflets = {"atl", "ptl", "stl", "tv",
                                                              "tvl", "ncc", "lcc", "rcc"};
  const bool of_other_valve =
      !words.has_part(kMitral) && !words.has_any(kMitralWords) &&
      (std::any_of(kOtherValves.begin(), kOtherValves.end(),
                   [&](std::string_view part) { return words.has_part(part); }) ||
       words.has_any(kOtherLeaflets));
  if (words.has_part("annul") || words.has_any(kRing))
    return of_other_valve ? NamedPart::Other : NamedPart::Annulus;
  if (words.has_part("chord")) return NamedPart::Chordae;
  if (words.has_part("papill") || words.has_any(kTip)) return NamedPart::Tips;
  constexpr std::array<std::string_view, 9> kChambers = {
      "atrium", "ventric", "aorta", "myocard", "blood", "background", "lumen", "root", "outflow"};
  constexpr std::array<std::string_view, 6> kChamberWords = {"la", "lv", "ra", "rv", "lvot", "ao"};
  if (std::any_of(kChambers.begin(), kChambers.end(),
                  [&](std::string_view part) { return words.has_part(part); }) ||
      words.has_any(kChamberWords))
    return NamedPart::Other;
  if (of_other_valve) return NamedPart::OtherLeaflet;
  const bool commissure = words.has_part("commissur");
  const bool anterior =
      words.has_part("anterior") || words.has_any(kAnterior) || words.has_any(kAnteriorScallops);
  const bool posterior = words.has_part("posterior") || words.has_any(kPosterior) ||
                         words.has_any(kPosteriorScallops) ||
                         (commissure && words.has_part("leaflet"));
  if (commissure && !posterior) return NamedPart::Commissure;
  if (anterior == posterior) return {};
  return anterior ? NamedPart::Anterior : NamedPart::Posterior;
}

std::optional<Side> side_named(std::string_view name) {
  constexpr std::array<std::string_view, 2> kLateral = {"a1", "p1"}, kMedial = {"a3", "p3"};
  constexpr std::array<std::string_view, 1> kAl = {"al"}, kPm = {"pm"};
  const NameWords words(name);
  // PM is a papillary muscle, too: of which side says what stands before it.
  const bool short_side =
      words.has_part("commissur") || words.has_part("papill") || words.has_part("tip");
  if (words.has_any(kLateral) || words.has_part("anterolateral") ||
      (short_side && words.has_any(kAl)))
    return Side::Anterolateral;
  if (words.has_any(kMedial) || words.has_part("posteromedial") ||
      (short_side && words.has_any(kPm)))
    return Side::Posteromedial;
  return {};
}

std::optional<AnnulusSide> annulus_side_named(std::string_view name) {
  // An appendage and an outflow tract lie beside the annulus.
  constexpr std::array<std::string_view, 4> kElsewhere = {"right", "append", "outflow", "sept"};
  constexpr std::array<std::string_view, 4> kElsewhereWords = {"ra", "rv", "laa", "lvot"};
  constexpr std::array<std::string_view, 1> kLa = {"la"}, kLv = {"lv"};
  const NameWords words(name);
  if (words.has_any(kElsewhereWords) ||
      std::any_of(kElsewhere.begin(), kElsewhere.end(),
                  [&](std::string_view part) { return words.has_part(part); }))
    return {};
  if (words.has_part("papill") || words.has_part("ventric") || words.has_any(kLv))
    return AnnulusSide::Ventricle;
  if (words.has_part("atrium") || words.has_part("atrial") || words.has_any(kLa))
    return AnnulusSide::Atrium;
  return {};
}

bool is_mitral(std::string_view name) {
  const NameWords words(name);
  return words.has_part(kMitral) || words.has_any(kMitralWords);
}

bool is_scallop(std::string_view name) {
  const NameWords words(name);
  return words.has_any(kAnteriorScallops) || words.has_any(kPosteriorScallops) ||
         words.has_part("commissur") || words.has_part("scallop");
}

}  // namespace coapt
