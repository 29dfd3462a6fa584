#include "clients/cli/print_preference.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/picture/text.h"
#include "search/preference/posterior.h"

namespace coapt {
namespace {

constexpr std::size_t kColumn = 48;       // two and a gap make at most 100
constexpr double kInterval90 = 1.644854;  // sds of a normal distribution

/// Adds `text` in lines of at most kColumn; later ones are indented.
void add_wrapped(std::vector<std::string>& lines, const std::string& text) {
  std::istringstream words(printable(text));
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kColumn) {
      lines.push_back(line);
      line = " ";
    }
    line += (line.empty() ? "" : " ") + word;
  }
  lines.push_back(line);
}

void add_figure(std::vector<std::string>& lines, const Json& plan, const char* key,
                const char* words, const char* unit) {
  if (!plan.contains(key) || plan[key].is_null()) return;
  lines.push_back(words + fixed(plan[key], 1) + ' ' + unit);
}

std::vector<std::string> column_of(const Json& plan, const std::string& key) {
  std::vector<std::string> lines = {'[' + key + ']'};
  for (const std::string step : plan["description"]) add_wrapped(lines, step);
  if (plan["description"].empty()) lines.push_back("no repair");
  add_figure(lines, plan, "leak_mm2", "leak: ", "mm2, mean over the region");
  add_figure(lines, plan, "opening_area_mm2", "opening: ", "mm2");
  add_figure(lines, plan, "durability_mm", "reserve against progression: ", "mm");
  return lines;
}

std::string term_words(const std::string& name) {
  std::string words = name;
  for (char& letter : words)
    if (letter == '_') letter = ' ';
  return words;
}

}  // namespace

void print_question(std::ostream& out, const Json& question) {
  const std::vector<std::string> left = column_of(question["plans"][0], "1");
  const std::vector<std::string> right = column_of(question["plans"][1], "2");
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    const std::string first = i < left.size() ? left[i] : "";
    out << first;
    if (i < right.size())
      out << std::string(kColumn + 4 - std::min(first.size(), kColumn), ' ') << right[i];
    out << '\n';
  }
}

void print_weights(std::ostream& out, const Json& learned) {
  out << counted(learned["answers"].get<long>(), "answer") << ", " << learned["unable"]
      << " of them undecided";
  if (!learned["consistency"].is_null())
    out << "; repeated questions answered the same way: " << percent(learned["consistency"]);
  out << "\n\nweight, mm2           default    learned   factor (90 %)\n";
  std::string silent;
  for (int term = 0; term < kLearnedTerms; ++term) {
    const std::string name = unknown_name(term);
    const Json& informed = learned["informed"];
    if (std::find(informed.begin(), informed.end(), name) == informed.end()) {
      silent += (silent.empty() ? "" : ", ") + term_words(name);
      continue;
    }
    const double before = CostWeights{}.*cost_term_rows()[static_cast<std::size_t>(term)].weight;
    const double after = learned["weights"][name], sd = learned["log_sd"][name];
    const double factor = after / before, far = std::exp(kInterval90 * sd);
    out << "  " << std::left << std::setw(20) << term_words(name) << std::right << std::setw(7)
        << fixed(before, 2) << "  ->" << std::setw(7) << fixed(after, 2) << "   x "
        << fixed(factor, 2) << ", " << fixed(factor / far, 2) << " to " << fixed(factor * far, 2)
        << '\n';
  }
  if (!silent.empty()) out << "Weights that the answers do not constrain: " << silent << '\n';
  out << "Response noise (sd): " << fixed(learned["noise_mm2"], 2) << " mm2.\n";
}

}  // namespace coapt
