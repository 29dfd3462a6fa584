#include "io/mesh/column_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "io/mesh/source_units.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view kAxisLetters = "xyzraslp";
constexpr std::array<std::string_view, 4> kUnitEndings = {"_mm", "_cm", "_in", "_m"};
// Units that stand right behind an axis: "m" and "in" would make axes of words.
constexpr std::array<std::string_view, 4> kJoinedUnits = {"mm", "cm", "um", "\xc2\xb5m"};
constexpr std::array<std::string_view, 7> kMicrometres = {
    "um", "\xc2\xb5m", "\xce\xbcm", "micron", "micrometre", "micrometer", "mum"};
/// What says no more than that a coordinate is one of a place.
constexpr std::array<std::string_view, 21> kPlaces = {
    "pos",         "position", "positions", "coord",   "coords", "coor",   "coordinate",
    "coordinates", "point",    "points",    "pt",      "node",   "vertex", "location",
    "loc",         "world",    "patient",   "annulus", "mitral", "ring",   "contour"};
/// Of tables of unnamed columns: R, MATLAB, spreadsheets.
constexpr std::array<std::string_view, 4> kUnnamed = {"v", "var", "column", "col"};
constexpr std::array<std::string_view, 6> kInsertion = {"ins",     "insert", "insertion",
                                                        "leaflet", "chorda", "chord"};
constexpr std::array<std::string_view, 7> kTip = {"tip",    "tips",   "papillary", "pap",
                                                  "muscle", "chorda", "chord"};
constexpr std::array<std::string_view, 6> kSide = {"papillary", "pap",  "muscle",
                                                   "muscles",   "side", "pm"};

bool is_one_of(std::string_view word, std::span<const std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string in_lower_case(std::string_view text) {
  std::string lower;
  for (const unsigned char letter : text) lower += static_cast<char>(std::tolower(letter));
  return lower;
}

std::string_view without_quotes(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

/// In lower case, parted where no letter or digit stands, and in "PosX", "XPos" and "coor1".
Words words_of_heading(std::string_view heading) {
  Words words(1);
  for (std::size_t i = 0; i < heading.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return k < heading.size() ? static_cast<unsigned char>(heading[k]) : 0;
    };
    const int c = at(i);
    if (std::isalnum(c) == 0 && c < 0x80) {
      if (!words.back().empty()) words.emplace_back();
      continue;
    }
    const int before = i > 0 ? at(i - 1) : 0;
    const bool begins = (std::isupper(c) != 0 && std::islower(before) != 0) ||
                        (std::isupper(c) != 0 && std::isupper(before) != 0 &&
                         std::islower(at(i + 1)) != 0 && i > 0) ||
                        (std::isdigit(c) != 0 && std::isalpha(before) != 0);
    if (begins && !words.back().empty()) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(c));
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool is_axis(std::string_view word) {
  return word.size() == 1 && kAxisLetters.find(word[0]) != std::string_view::npos;
}

/// "posx" and "xpos" become a place and an axis, "xmm" an axis and a unit.
Words parted(const Words& words) {
  Words all;
  for (const std::string& word : words) {
    const std::string_view front = std::string_view(word).substr(0, 1),
                           back = std::string_view(word).substr(word.size() - 1);
    const std::string_view behind = std::string_view(word).substr(1),
                           before = std::string_view(word).substr(0, word.size() - 1);
    if (is_one_of(word, kPlaces)) {
      all.push_back(word);
    } else if (word.size() > 1 && is_axis(front) &&
               (is_one_of(behind, kPlaces) || is_one_of(behind, kJoinedUnits))) {
      all.emplace_back(front);
      all.emplace_back(behind);
    } else if (word.size() > 3 && is_axis(back) && is_one_of(before, kPlaces)) {
      all.emplace_back(before);
      all.emplace_back(back);
    } else {
      all.push_back(word);
    }
  }
  return all;
}

bool are_all_of(const Words& words, std::span<const std::string_view> list) {
  return !words.empty() && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return is_one_of(word, list);
  });
}

struct Heading {
  std::string name;  ///< in lower case, without unit
  std::string unit;
  std::string means;  ///< a name of the readers; empty: none is known
  std::string axes;   ///< "ras" of "x_RAS", "r" of "x (R)"
  int place = -1;     ///< 1 of "coor1"
};

void take_bracket(std::string_view content, Heading& heading) {
  const std::string word = in_lower_case(trimmed(content));
  const bool letters = std::all_of(word.begin(), word.end(), [](char letter) {
    return std::string_view("rlaspi").find(letter) != std::string_view::npos;
  });
  if (letters && (word.size() == 1 || word.size() == 3))
    heading.axes = word;
  else
    heading.unit = std::string(trimmed(content));
}

/// "mm" of "x in mm", and takes it off.
void take_unit_word(Words& words, Heading& heading) {
  if (words.size() < 2 || !unit_in_mm(words.back())) return;
  const std::string unit = words.back();
  words.pop_back();
  if (words.size() > 1 && words.back() == "in") words.pop_back();
  if (heading.unit.empty()) heading.unit = unit;
}

/// "X1": of a table of one point a row; where there is an x2, both mean nothing (part_rivals).
bool is_numbered(std::string_view axis, const Words& left) {
  return left.empty() && std::string_view("xyz").find(axis) != std::string_view::npos;
}

void take_meaning(Words words, Heading& heading) {
  take_unit_word(words, heading);
  bool of_place = false, unnamed = false;
  std::string axis, digit;
  Words left;
  for (const std::string& word : words) {
    const bool is_digit =
        word.size() == 1 && std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    if (word == "ras" || word == "lps")
      heading.axes = word;
    else if (is_one_of(word, kPlaces))
      of_place = true;
    else if (is_one_of(word, kUnnamed))
      unnamed = true;
    else if (is_axis(word) && axis.empty())
      axis = word;
    else if (is_digit && digit.empty())
      digit = word;
    else
      left.push_back(word);
  }
  if (axis.empty() && left.empty() && !digit.empty() && of_place != unnamed) {
    heading.place = digit[0] - '0';
  } else if (!axis.empty() && !unnamed && (digit.empty() || is_numbered(axis, left))) {
    if (left.empty())
      heading.means = axis;
    else if (are_all_of(left, kInsertion))
      heading.means = "ins_" + axis;
    else if (are_all_of(left, kTip))
      heading.means = "tip_" + axis;
  } else if (axis.empty() && digit.empty() && !unnamed && !of_place && are_all_of(left, kSide)) {
    heading.means = "papillary";
  }
}

Heading heading_of(std::string_view text) {
  text = without_quotes(text);
  Heading heading;
  std::string outside(text);
  if (const std::size_t open = text.find_first_of("[("); open != std::string_view::npos) {
    const std::size_t close = std::min(text.find_first_of("])", open), text.size());
    take_bracket(text.substr(open + 1, close - open - 1), heading);
    outside = std::string(trimmed(text.substr(0, open)));
    heading.name = in_lower_case(outside);
    if (close + 1 < text.size()) outside += ' ' + std::string(text.substr(close + 1));
  } else {
    heading.name = in_lower_case(text);
  }
  for (const std::string_view unit : kUnitEndings)
    if (heading.name.size() > unit.size() && heading.name.ends_with(unit)) {
      heading.name.resize(heading.name.size() - unit.size());
      if (heading.unit.empty()) heading.unit = std::string(unit.substr(1));
      break;
    }
  const std::string stated = heading.unit;
  take_meaning(parted(words_of_heading(outside)), heading);
  if (heading.means.empty() && heading.place < 0) {
    heading.unit = stated;
    heading.axes.clear();
  }
  return heading;
}

/// Columns 0 to 2, or 1 to 3, of one place or of a table whose columns have no names are x, y and z.
void take_places(std::vector<Heading>& headings) {
  for (const int first : {0, 1}) {
    std::array<std::size_t, 3> count{};
    for (const Heading& heading : headings)
      if (heading.place >= first && heading.place < first + 3)
        ++count[static_cast<std::size_t>(heading.place - first)];
    if (count != std::array<std::size_t, 3>{1, 1, 1}) continue;
    for (Heading& heading : headings)
      if (heading.place >= first && heading.place < first + 3)
        heading.means = std::string(1, "xyz"[heading.place - first]);
    return;
  }
}

/// Several that mean the same: the one whose name is just that has it, or none.
void part_rivals(std::vector<Heading>& headings) {
  for (Heading& heading : headings) {
    if (heading.means.empty() || heading.name == heading.means) continue;
    const bool rival = std::any_of(headings.begin(), headings.end(), [&](const Heading& other) {
      return &other != &heading && (other.name == heading.means || other.means == heading.means);
    });
    if (rival && std::none_of(headings.begin(), headings.end(), [&](const Heading& other) {
          return &other != &heading && other.name == heading.means;
        }))
      for (Heading& other : headings)
        if (&other != &heading && other.means == heading.means) other.means.clear();
    if (rival) heading.means.clear();
  }
}

std::string stated_axes_of(const std::vector<Heading>& headings) {
  std::string letters;
  for (const char* axis : {"x", "y", "z"})
    for (const Heading& heading : headings)
      if (heading.means == axis && heading.axes.size() == 1) letters += heading.axes;
  for (const Heading& heading : headings)
    if (heading.axes.size() == 3) return heading.axes;
  return letters.size() == 3 ? letters : std::string();
}

}  // namespace

ColumnNames column_names(const std::vector<std::string_view>& headings) {
  std::vector<Heading> read;
  for (const std::string_view heading : headings) read.push_back(heading_of(heading));
  take_places(read);
  part_rivals(read);
  ColumnNames columns;
  columns.axes = stated_axes_of(read);
  for (const Heading& heading : read) {
    columns.names.push_back(heading.means.empty() ? heading.name : heading.means);
    columns.units.push_back(heading.unit);
  }
  return columns;
}

std::optional<double> unit_in_mm(std::string_view name) {
  if (const auto unit = unit_named(name)) return in_mm(*unit);
  std::string_view one = name;
  if (one.size() > 3 && one.ends_with('s')) one.remove_suffix(1);
  if (is_one_of(in_lower_case(one), kMicrometres)) return 1e-3;
  return {};
}

}  // namespace coapt
