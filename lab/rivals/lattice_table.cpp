#include "lab/rivals/lattice_table.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

namespace coapt::rivals {
namespace {

constexpr std::string_view kFirstLine = "coapt-lattice 1";

/// All of `text` as a number.
template <class T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  /// Empty after the end.
  std::string_view next() {
    ++line_;
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, length);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    return line;
  }
  Error error(ErrorCode code, const std::string& message) const {
    return {code, "", "line " + std::to_string(line_) + ": " + message};
  }

 private:
  std::string_view rest_;
  int line_ = 0;  // that next() gave last, from 1
};

/// Takes the part before the first space off the line, and the space.
std::string_view take_word(std::string_view& line) {
  const std::size_t length = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(std::min(length + 1, line.size()));
  return word;
}

std::string range(std::size_t low, std::size_t high) {
  return std::to_string(low) + " to " + std::to_string(high);
}

/// `line` after its first word.
Expected<LatticeVariable> read_variable(std::string_view line, bool ordered, const Lines& lines) {
  const std::optional<int> count = number_of<int>(take_word(line));
  if (!count || *count < 2 || *count > kMostValues)
    return lines.error(ErrorCode::OutOfRange,
                       "a variable has " + range(2, kMostValues) + " values");
  if (line.empty()) return lines.error(ErrorCode::MissingField, "a variable has a name");
  return LatticeVariable{std::string(line), ordered, *count};
}

Expected<std::vector<double>> read_costs(std::size_t count, Lines& lines) {
  std::vector<double> costs;
  costs.reserve(count);
  while (costs.size() < count) {
    if (lines.at_end()) {
      lines.next();
      return lines.error(ErrorCode::InputOutput, "is truncated: " + std::to_string(costs.size()) +
                                                     " of " + std::to_string(count) + " costs");
    }
    const std::optional<double> cost = number_of<double>(lines.next());
    if (!cost || std::isnan(*cost) || *cost == -HUGE_VAL)
      return lines.error(ErrorCode::OutOfRange, "a cost is a finite number or inf");
    costs.push_back(*cost);
  }
  if (std::none_of(costs.begin(), costs.end(), [](double c) { return std::isfinite(c); }))
    return lines.error(ErrorCode::OutOfRange, "one cost at least is finite");
  return costs;
}

/// Nothing if the text ends here.
Expected<std::vector<int>> read_plans(std::size_t count, Lines& lines) {
  std::vector<int> plans;
  if (lines.at_end()) return plans;
  if (lines.next() != "plans " + std::to_string(count))
    return lines.error(ErrorCode::UnknownField,
                       "after the last cost comes nothing, or plans " + std::to_string(count));
  while (plans.size() < count) {
    const std::optional<int> plan = number_of<int>(lines.next());
    if (!plan || *plan < 0 || static_cast<std::size_t>(*plan) >= count)
      return lines.error(ErrorCode::OutOfRange,
                         "a plan is a number from 0, below the combinations");
    plans.push_back(*plan);
  }
  if (lines.at_end()) return plans;
  lines.next();
  return lines.error(ErrorCode::UnknownField, "nothing comes after the last plan");
}

}  // namespace

std::size_t index_of(const LatticeTable& table, std::span<const int> at) {
  assert(at.size() == table.variables.size());
  std::size_t index = 0;
  for (std::size_t k = at.size(); k-- > 0;) {
    assert(0 <= at[k] && at[k] < table.variables[k].count);
    index = index * static_cast<std::size_t>(table.variables[k].count) +
            static_cast<std::size_t>(at[k]);
  }
  return index;
}

std::vector<int> combination_of(const LatticeTable& table, std::size_t index) {
  std::vector<int> at;
  for (const LatticeVariable& variable : table.variables) {
    const auto count = static_cast<std::size_t>(variable.count);
    at.push_back(static_cast<int>(index % count));
    index /= count;
  }
  assert(index == 0);
  return at;
}

Expected<LatticeTable> read_lattice(std::string_view text) {
  Lines lines(text);
  if (lines.next() != kFirstLine)
    return lines.error(ErrorCode::Unsupported, "must be '" + std::string(kFirstLine) + "'");
  LatticeTable table;
  std::string_view line = lines.next();
  if (take_word(line) != "name" || line.empty())
    return lines.error(ErrorCode::MissingField, "must be 'name NAME'");
  table.name = line;

  std::size_t combinations = 1;
  std::string_view word;
  while (line = lines.next(), word = take_word(line), word == "ordered" || word == "category") {
    const Expected<LatticeVariable> variable = read_variable(line, word == "ordered", lines);
    if (!variable) return variable.errors();
    for (const LatticeVariable& other : table.variables)
      if (other.name == variable->name)
        return lines.error(ErrorCode::BadReference, "another variable has this name");
    table.variables.push_back(*variable);
    if (table.variables.size() > kMostVariables)
      return lines.error(ErrorCode::OutOfRange,
                         "there are " + range(2, kMostVariables) + " variables");
    combinations *= static_cast<std::size_t>(variable->count);
    if (combinations > kMostCombinations)
      return lines.error(ErrorCode::OutOfRange,
                         "there are " + range(4, kMostCombinations) + " combinations");
  }
  if (word != "costs")
    return lines.error(ErrorCode::UnknownField, "starts with none of ordered, category, costs");
  if (table.variables.size() < 2)
    return lines.error(ErrorCode::OutOfRange,
                       "there are " + range(2, kMostVariables) + " variables");
  if (number_of<std::size_t>(line) != combinations)
    return lines.error(ErrorCode::OutOfRange, "the variables have " + std::to_string(combinations) +
                                                  " combinations, as many costs follow");
  Expected<std::vector<double>> costs = read_costs(combinations, lines);
  if (!costs) return costs.errors();
  table.costs = *std::move(costs);
  Expected<std::vector<int>> plans = read_plans(combinations, lines);
  if (!plans) return plans.errors();
  table.plans = *std::move(plans);
  return table;
}

std::string write_lattice(const LatticeTable& table) {
  std::string text = std::string(kFirstLine) + "\nname " + table.name + '\n';
  for (const LatticeVariable& variable : table.variables)
    text += (variable.ordered ? "ordered " : "category ") + std::to_string(variable.count) + ' ' +
            variable.name + '\n';
  text += "costs " + std::to_string(table.costs.size()) + '\n';
  for (const double cost : table.costs) {
    char digits[32];
    const auto [end, error] =
        std::to_chars(digits, digits + sizeof digits, cost, std::chars_format::general, 17);
    assert(error == std::errc{});
    text.append(digits, end) += '\n';
  }
  if (!table.plans.empty()) text += "plans " + std::to_string(table.plans.size()) + '\n';
  for (const int plan : table.plans) text += std::to_string(plan) + '\n';
  return text;
}

}  // namespace coapt::rivals
