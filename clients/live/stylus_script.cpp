#include "clients/live/stylus_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/valve/problem_list.h"
#include "io/mesh/csv_table.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 5> kColumns = {"t_ms", "x", "y", "z", "button"};

bool accepts(std::size_t column, double number) {
  if (column == 0) return number >= 0.0;
  if (column == 4) return number == 0.0 || number == 1.0;
  return std::abs(number) <= kFarthest_mm;
}

std::string accepted(std::size_t column) {
  if (column == 0) return "at least 0";
  if (column == 4) return "0 or 1";
  return "from " + shown(-kFarthest_mm) + " to " + shown(kFarthest_mm) + " mm";
}

/// What speaks against it, but for its place in the order; "" if nothing does.
std::string problem_with(const std::array<double, 5>& row) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    const bool is_number = std::isfinite(row[k]);
    if (is_number && accepts(k, row[k])) continue;
    return std::string(kColumns[k]) + " is " + (is_number ? shown(row[k]) : "not a number") +
           ", must be " + accepted(k);
  }
  return "";
}

}  // namespace

Expected<std::vector<StylusSample>> read_stylus_script(std::string_view csv) {
  const Expected<CsvTable> table = read_csv(csv, {"t_ms"});
  if (!table) return table.errors();
  std::array<std::size_t, 5> at = {0, 1, 2, 3, 4};
  ProblemList problems;
  for (std::size_t k = 0; k < at.size() && !table->names.empty(); ++k) {
    const auto found = std::find(table->names.begin(), table->names.end(), plain_name(kColumns[k]));
    at[k] = static_cast<std::size_t>(found - table->names.begin());
    if (found == table->names.end())
      problems.add(ErrorCode::MissingField, "", "has no column " + std::string(kColumns[k]));
  }
  if (table->rows.empty()) problems.add(ErrorCode::MissingField, "", "has no samples");
  if (!problems.empty()) return std::move(problems).take();
  std::vector<StylusSample> script;
  for (const CsvRow& row : table->rows) {
    std::array<double, 5> numbers{};
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto number =
          at[k] < row.fields.size() ? to_number(row.fields[at[k]]) : std::optional<double>{};
      numbers[k] = number.value_or(std::nan(""));
    }
    std::string problem = problem_with(numbers);
    if (problem.empty() && !script.empty() && numbers[0] <= script.back().time_ms)
      problem = "t_ms is " + shown(numbers[0]) + ", must be above that of the line before";
    if (!problem.empty())
      problems.add(ErrorCode::OutOfRange, "", "line " + std::to_string(row.line) + ": " + problem);
    script.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}, numbers[4] == 1.0});
  }
  if (!problems.empty()) return std::move(problems).take();
  return script;
}

StylusState stylus_at(const std::vector<StylusSample>& script, double time_ms) {
  const auto after = std::upper_bound(
      script.begin(), script.end(), time_ms,
      [](double time, const StylusSample& sample) { return time < sample.time_ms; });
  if (after == script.begin()) return {after->position_mm};
  const StylusSample& from = *(after - 1);
  if (after == script.end()) return {from.position_mm, from.grabs, true};
  const double share = (time_ms - from.time_ms) / (after->time_ms - from.time_ms);
  return {from.position_mm + share * (after->position_mm - from.position_mm), from.grabs};
}

HapticDevice scripted_stylus(std::vector<StylusSample> script) {
  return {[script = std::move(script)](double time_ms) -> Expected<StylusState> {
            return stylus_at(script, time_ms);
          },
          [](const Vec3&) {}};
}

}  // namespace coapt
