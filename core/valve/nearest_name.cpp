#include "core/valve/nearest_name.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace coapt {
namespace {

constexpr std::size_t kLongest = 64, kLettersOfAnEdit = 3;

/// Optimal string alignment distance.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({changed, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view given, std::span<const std::string> known) {
  if (given.size() > kLongest) return "";
  std::string_view nearest;
  std::size_t fewest = given.size() / kLettersOfAnEdit + 1;
  for (const std::string& name : known) {
    if (const std::size_t count = edits(given, name); count < fewest) {
      fewest = count;
      nearest = name;
    }
  }
  return nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
}

}  // namespace coapt
