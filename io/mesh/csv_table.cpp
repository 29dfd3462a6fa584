#include "io/mesh/csv_table.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/mesh/source_units.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxRows = 100'000;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::array<std::string_view, 6> kFormats = {"csv", "txt", "tsv", "dat", "xyz", "fcsv"};
constexpr std::string_view kSlicersColumns = "columns =";
constexpr std::array<std::string_view, 4> kUnitEndings = {"_mm", "_cm", "_in", "_m"};

/// What is between fields; a blank stands for any number of blanks and tabs.
char separator_of(std::string_view row) {
  if (row.find(';') != std::string_view::npos) return ';';
  if (row.find('\t') != std::string_view::npos) return '\t';
  if (row.find(',') == std::string_view::npos) return ' ';
  // "1,5 2,5 3,5": decimal commas, because between commas there would be two numbers in a field.
  for (const std::string_view field : fields(row))
    if (field.find(' ') != std::string_view::npos && to_number(field.substr(0, field.find(' '))))
      return ' ';
  return ',';
}

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

std::vector<std::string_view> split(std::string_view row, char separator) {
  std::vector<std::string_view> found;
  if (separator == ' ') {
    found = words(row);
  } else {
    for (std::size_t start = 0; found.size() < kMaxWords;) {
      // What stands in quotes is one field, whatever it holds: "1,5","2,5".
      const std::size_t open = std::min(row.find_first_not_of(" \t", start), row.size());
      const std::size_t close =
          row.substr(open).starts_with('"') ? row.find('"', open + 1) : std::string_view::npos;
      const std::size_t end = row.find(separator, close == std::string_view::npos ? start : close);
      found.push_back(row.substr(start, end - start));
      if (end == std::string_view::npos) break;
      start = end + 1;
    }
  }
  for (std::string_view& field : found) field = unquoted(field);
  return found;
}

/// Without the mark of a comment, if it is one.
std::string_view without_mark(std::string_view line, bool& comment) {
  const std::size_t mark = line.starts_with("//")                           ? 2
                           : line.starts_with('#') || line.starts_with('%') ? 1
                                                                            : 0;
  comment = mark > 0;
  return trimmed(line.substr(mark));
}

bool has_all(const std::vector<std::string>& names, std::string_view letters) {
  return std::all_of(letters.begin(), letters.end(), [&](char letter) {
    return std::find(names.begin(), names.end(), std::string(1, letter)) != names.end();
  });
}

/// Of a line that has one of `columns`, whatever is between its fields; else none. Where x is looked for, Slicer's r, a, s and
/// l, p, s will do; a comment has all three axes, and words after two blanks are not of its names.
std::vector<std::string> names_in(std::string_view line, bool comment,
                                  std::initializer_list<std::string_view> columns) {
  if (line.starts_with(kSlicersColumns)) line = trimmed(line.substr(kSlicersColumns.size()));
  if (comment && separator_of(line) != ' ') line = line.substr(0, line.find("  "));
  std::vector<std::string> names;
  for (const std::string_view field : split(line, separator_of(line)))
    names.push_back(plain_name(field));
  const bool points = std::find(columns.begin(), columns.end(), "x") != columns.end();
  const bool has_one = std::any_of(columns.begin(), columns.end(), [&](std::string_view column) {
    return !(comment && column == "x") &&
           std::find(names.begin(), names.end(), column) != names.end();
  });
  const bool has_axes =
      points && (has_all(names, "ras") || has_all(names, "lps") || has_all(names, "xyz"));
  if (!has_one && !has_axes) names.clear();
  return names;
}

/// Of a row of units, as some programs write below the names: one for each field, or nothing for what has none; else empty.
std::vector<std::string> unit_row(std::string_view line) {
  std::vector<std::string> units;
  for (const std::string_view field : split(line, separator_of(line))) {
    const std::string_view word = trimmed(field.substr(0, field.find_last_not_of(")]") + 1));
    const std::string_view name = word.substr(std::min(word.find_first_not_of("[("), word.size()));
    const bool none = name.empty() || name == "-";
    if (!none && !unit_named(name)) return {};
    units.emplace_back(none ? "" : name);
  }
  const auto stated = std::count_if(units.begin(), units.end(),
                                    [](const std::string& unit) { return !unit.empty(); });
  return stated < 3 ? std::vector<std::string>{} : units;
}

/// Between brackets, or behind an underscore.
std::string unit_of_name(std::string_view name) {
  name = unquoted(name);
  if (const std::size_t open = name.find_first_of("[("); open != std::string_view::npos)
    return std::string(trimmed(name.substr(open + 1, name.find_first_of("])") - open - 1)));
  for (const std::string_view unit : kUnitEndings)
    if (name.size() > unit.size() && name.ends_with(unit)) return std::string(unit.substr(1));
  return {};
}

std::vector<std::string> units_in(std::string_view line) {
  std::vector<std::string> units;
  for (const std::string_view field : split(line, separator_of(line)))
    units.push_back(unit_of_name(field));
  return units;
}

/// "x", "s", "tip_z".
bool is_coordinate(std::string_view name) {
  const std::size_t before = name.size() < 3 ? 0 : name.size() - 2;
  return (name.size() == 1 && std::string_view("xyzraslp").find(name) != std::string_view::npos) ||
         (before > 0 && name[before] == '_' &&
          std::string_view("xyz").find(name.back()) != std::string_view::npos);
}

/// "RAS", "l", "0": brackets hold these, too.
bool is_axes_or_number(std::string_view word) {
  return std::all_of(word.begin(), word.end(),
                     [](unsigned char letter) { return std::isdigit(letter) != 0; }) ||
         (word.size() <= 3 && std::all_of(word.begin(), word.end(), [](unsigned char letter) {
            return std::string_view("rlaspi").find(static_cast<char>(std::tolower(letter))) !=
                   std::string_view::npos;
          }));
}

void take_unit_of_coordinates(CsvTable& table) {
  table.unit.clear();
  table.no_unit.clear();
  for (std::size_t i = 0; i < std::min(table.names.size(), table.units.size()); ++i) {
    const std::string& unit = table.units[i];
    if (unit.empty() || !is_coordinate(table.names[i])) continue;
    if (table.unit.empty()) table.unit = unit;
    if (table.no_unit.empty() && !unit_named(unit) && !is_axes_or_number(unit))
      table.no_unit = unit;
  }
}

/// Whether a first field that has no name is the name of its row, as R writes it: a word, or the row's number.
bool is_row_name(const std::optional<double>& number, std::size_t row) {
  return !number || *number == static_cast<double>(row) || *number == static_cast<double>(row + 1);
}

/// Rows end where the names end, but for fields that are not empty; what stands before the first name in every row is the row's name.
void drop_row_names(CsvTable& table) {
  const std::size_t columns = table.names.size();
  if (columns == 0 || table.may_go_on) return;
  bool all = true;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& fields = table.rows[row].fields;
    while (fields.size() > columns && fields.back().empty()) fields.pop_back();
    all = all && fields.size() == columns + 1 && is_row_name(table.number(fields[0]), row);
  }
  if (!all) return;
  for (CsvRow& row : table.rows) row.fields.erase(row.fields.begin());
}

}  // namespace

bool CsvTable::has(std::string_view column) const {
  return std::find(names.begin(), names.end(), column) != names.end();
}

std::optional<double> CsvTable::number(std::string_view field) const {
  if (!decimal_commas) return to_number(field);
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return to_number(text);
}

bool is_table_format(std::string_view format) {
  return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end();
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char letter : unquoted(name))
    plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (const std::size_t unit = plain.find_first_of("[("); unit != std::string::npos)
    plain = std::string(trimmed(std::string_view(plain).substr(0, unit)));
  for (const std::string_view unit : kUnitEndings)
    if (plain.size() > unit.size() && plain.ends_with(unit)) {
      plain.resize(plain.size() - unit.size());
      break;
    }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const char between : {':', '_'})
      if (plain == std::string("points") + between + std::to_string(axis))
        return std::string(1, "xyz"[axis]);
  return plain;
}

Expected<CsvTable> read_csv(std::string_view text,
                            std::initializer_list<std::string_view> columns) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    return Error{ErrorCode::Unsupported, "", "is a table in UTF-16; save it as UTF-8"};
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CsvTable table;
  char separator = 0;
  LineScanner lines(text);
  while (const auto line = lines.next()) {
    bool comment = false;
    const std::string_view content = without_mark(trimmed(line->text), comment);
    if (content.empty()) continue;
    if (table.rows.empty()) {
      if (auto names = names_in(content, comment, columns); !names.empty()) {
        table.names = std::move(names);
        table.may_go_on = content.starts_with(kSlicersColumns);
        table.units = units_in(content);
        take_unit_of_coordinates(table);
        continue;
      }
    }
    if (comment) continue;
    if (table.rows.empty() && !table.names.empty())
      if (std::vector<std::string> units = unit_row(content); !units.empty()) {
        table.units = std::move(units);
        take_unit_of_coordinates(table);
        continue;
      }
    if (separator == 0) {
      separator = separator_of(content);
      table.decimal_commas = separator != ',';
    }
    table.rows.push_back({line->number, split(content, separator)});
    for (const std::string_view field : table.rows.back().fields)
      table.decimal_commas = table.decimal_commas || field.find(',') != std::string_view::npos;
    if (table.rows.size() > kMaxRows)
      return Error{ErrorCode::OutOfRange, "", "has more than the 100,000 rows accepted"};
  }
  drop_row_names(table);
  return table;
}

}  // namespace coapt
