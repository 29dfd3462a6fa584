#include "io/json/trials_csv.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/valve/problem_list.h"
#include "io/json/json.h"
#include "search/training/exam_a.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 15> kColumns = {
    "learner", "block", "trial",      "valve",   "exam",    "seed",      "difficulty", "choice",
    "answer",  "right", "confidence", "seconds", "path_mm", "largest_n", "visited"};
constexpr std::size_t kMostRows = 100'000;
constexpr std::string_view kLetters = "TNP";                   // of Mobility
constexpr std::size_t kLongestBlock = 64, kLongestName = 200;  // bytes

using Cells = std::vector<std::string>;

/// Cells of a line; none if a quote is not closed.
std::optional<Cells> cells_of(std::string_view line) {
  Cells cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  if (quoted) return std::nullopt;
  return cells;
}

/// Bytes of the first row, which may have ends of lines between quotes.
std::size_t row_size(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == '\n' && !quoted) return i;
  }
  return text.size();
}

/// Text from a file is shown cut short.
std::string shown_text(std::string_view text) {
  constexpr std::size_t kMost = 40;
  return '"' + std::string(text.substr(0, kMost)) + (text.size() > kMost ? "...\"" : "\"");
}

/// The library leaves broken sequences out.
bool is_utf8(const std::string& text) {
  const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore);
  return Json::parse(quoted, nullptr, false) == text;
}

bool is_refused(unsigned char byte) {
  return (byte < ' ' && byte != '\t' && byte != '\n' && byte != '\r') || byte == 127;
}

/// A row, and where its problems go.
struct RowPlace {
  std::size_t line;
  const std::map<std::string_view, std::size_t>& columns;
  const Cells& cells;
  ProblemList& problems;

  const std::string& cell(std::string_view column) const { return cells[columns.at(column)]; }
  void refuse(std::string_view column, std::string message) const {
    problems.add(ErrorCode::OutOfRange, '/' + std::to_string(line) + '/' + std::string(column),
                 std::move(message));
  }
};

std::string accepted(Range range) {
  return "must be from " + shown(range.min) + " to " + shown(range.max);
}

double number_at(const RowPlace& row, std::string_view column, Range range) {
  const std::string& text = row.cell(column);
  const Json value = Json::parse(text, nullptr, false);
  if (value.is_number() && value >= range.min && value <= range.max) return value.get<double>();
  row.refuse(column, "is " + shown_text(text) + ", " + accepted(range));
  return range.min;
}

std::uint64_t whole_at(const RowPlace& row, std::string_view column, std::uint64_t min,
                       std::uint64_t max) {
  const std::string& text = row.cell(column);
  const Json value = Json::parse(text, nullptr, false);
  if (value.is_number_unsigned() && value >= min && value <= max) return value.get<std::uint64_t>();
  row.refuse(column, "is " + shown_text(text) + ", must be a whole number from " +
                         std::to_string(min) + " to " + std::to_string(max));
  return min;
}

std::string text_at(const RowPlace& row, std::string_view column, std::size_t longest) {
  std::string text = row.cell(column);
  if (text.find_first_of("=+-@\t\r", 1) == 1 && text[0] == '\'') text.erase(0, 1);
  if (text.size() > longest)
    row.refuse(column, "is longer than " + std::to_string(longest) + " bytes");
  else if (!is_utf8(text))
    row.refuse(column, "must be UTF-8");
  else if (std::ranges::any_of(text, is_refused))
    row.refuse(column, "must have no control characters but tabs and ends of lines");
  return text;
}

std::array<Mobility, kSegments> mobilities_at(const RowPlace& row, std::string_view column) {
  std::array<Mobility, kSegments> found{};
  const std::string& text = row.cell(column);
  if (text.size() != kSegments || text.find_first_not_of(kLetters) != std::string::npos) {
    row.refuse(column, "is " + shown_text(text) +
                           ", must be eight letters T, N or P for A1 A2 A3 P1 P2 P3 AC PC");
    return found;
  }
  for (std::size_t s = 0; s < kSegments; ++s)
    found[s] = static_cast<Mobility>(kLetters.find(text[s]));
  return found;
}

std::vector<Segment> visited_at(const RowPlace& row) {
  std::vector<Segment> visited;
  std::string_view rest = row.cell("visited");
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (word.empty()) continue;
    const auto segment = std::find_if(kAllSegments.begin(), kAllSegments.end(),
                                      [&](Segment s) { return to_string(s) == word; });
    if (segment == kAllSegments.end()) {
      row.refuse("visited",
                 "has " + shown_text(word) +
                     ", must be segments (A1, A2, A3, P1, P2, P3, AC, PC) separated by spaces");
      break;
    }
    if (visited.empty() || visited.back() != *segment) visited.push_back(*segment);
  }
  return visited;
}

TrainingTrial trial_at(const RowPlace& row) {
  TrainingTrial trial;
  trial.learner = static_cast<int>(whole_at(row, "learner", 1, 1'000'000));
  trial.block = text_at(row, "block", kLongestBlock);
  trial.trial = static_cast<int>(whole_at(row, "trial", 1, 100'000));
  trial.valve = text_at(row, "valve", kLongestName);
  trial.seed = whole_at(row, "seed", 0, kLargestSeed);
  trial.difficulty = number_at(row, "difficulty", {-10.0, 10.0});
  const std::string& exam = row.cell("exam");
  if (exam == "B") {
    trial.judged = JudgedSegments{mobilities_at(row, "choice"), mobilities_at(row, "answer")};
  } else if (exam == "A") {
    trial.judged = ChosenValve{static_cast<int>(whole_at(row, "choice", 1, kChoices)),
                               static_cast<int>(whole_at(row, "answer", 1, kChoices))};
  } else {
    row.refuse("exam", "is " + shown_text(exam) + ", must be A or B");
  }
  const auto right = static_cast<int>(whole_at(row, "right", 0, kSegments));
  trial.confidence = number_at(row, "confidence", {0.0, 1.0});
  trial.seconds = number_at(row, "seconds", {0.0, 86'400.0});
  trial.path_mm = number_at(row, "path_mm", {0.0, 1e6});
  trial.largest_n = number_at(row, "largest_n", {0.0, 100.0});
  trial.visited = visited_at(row);
  if (row.problems.empty() && right != right_of(trial))
    row.refuse("right", "is " + std::to_string(right) + ", choice and answer say " +
                            std::to_string(right_of(trial)));
  return trial;
}

std::map<std::string_view, std::size_t> columns_of(const Cells& header, ProblemList& problems) {
  std::map<std::string_view, std::size_t> columns;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto known = std::find(kColumns.begin(), kColumns.end(), header[i]);
    if (known == kColumns.end())
      problems.add(ErrorCode::UnknownField, "/1", "has an unknown column " + shown_text(header[i]));
    else if (!columns.emplace(*known, i).second)
      problems.add(ErrorCode::UnknownField, "/1", "has the column " + header[i] + " twice");
  }
  for (const std::string_view name : kColumns)
    if (!columns.contains(name))
      problems.add(ErrorCode::MissingField, "/1", "has no column " + std::string(name));
  return columns;
}

}  // namespace

Expected<std::vector<TrainingTrial>> read_trials_csv(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  ProblemList problems;
  std::vector<TrainingTrial> trials;
  std::optional<Cells> header;
  std::map<std::string_view, std::size_t> columns;
  std::map<int, int> last_trial;  // of a learner
  for (std::size_t line = 1, next = 1; !text.empty() && !problems.crowded(); line = next) {
    const std::size_t end = row_size(text);
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    next += 1 + static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
    if (content.ends_with('\r')) content.remove_suffix(1);
    if (content.empty()) continue;
    std::optional<Cells> cells = cells_of(content);
    if (!cells) {
      problems.add(ErrorCode::WrongType, '/' + std::to_string(line),
                   "has a quote that is not closed");
      continue;
    }
    if (!header) {
      header = std::move(cells);
      columns = columns_of(*header, problems);
      if (!problems.empty()) break;
      continue;
    }
    if (cells->size() != header->size()) {
      problems.add(ErrorCode::WrongType, '/' + std::to_string(line),
                   "has " + std::to_string(cells->size()) + " cells, must have " +
                       std::to_string(header->size()));
      continue;
    }
    ProblemList of_row;
    trials.push_back(trial_at({line, columns, *cells, of_row}));
    if (of_row.empty()) {
      const auto [before, first] = last_trial.emplace(trials.back().learner, trials.back().trial);
      if (!first && trials.back().trial <= before->second)
        of_row.add(ErrorCode::OutOfRange, '/' + std::to_string(line) + "/trial",
                   "is " + std::to_string(trials.back().trial) + ", must be above " +
                       std::to_string(before->second) + ", the learner's trial before it");
      before->second = trials.back().trial;
    }
    for (const Error& error : of_row.listed()) problems.add(error.code, error.path, error.message);
    if (trials.size() > kMostRows)
      return Error{ErrorCode::OutOfRange, "", "has more than the 100,000 rows accepted"};
  }
  if (!header && problems.empty())
    problems.add(ErrorCode::MissingField, "", "is empty, must have a line with the columns");
  if (header && problems.empty() && trials.empty())
    problems.add(ErrorCode::MissingField, "", "has no trials below the line with the columns");
  if (!problems.empty()) return std::move(problems).take();
  return trials;
}

}  // namespace coapt
