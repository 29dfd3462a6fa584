#include "io/mesh/csv_table.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/mesh/column_names.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxRows = 100'000;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::array<std::string_view, 6> kFormats = {"csv", "txt", "tsv", "dat", "xyz", "fcsv"};
constexpr std::string_view kSlicersColumns = "columns =";
/// Columns of points; beside them, or in a comment, a line of names has all three axes.
constexpr std::array<std::string_view, 4> kOfPoints = {"x", "papillary", "label", "name"};

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

bool has_axes(const std::vector<std::string>& names) {
  const auto has_all = [&](std::initializer_list<const char*> axes) {
    return std::all_of(axes.begin(), axes.end(), [&](const char* axis) {
      return std::find(names.begin(), names.end(), axis) != names.end();
    });
  };
  return has_all({"x", "y", "z"}) || has_all({"r", "a", "s"}) || has_all({"l", "p", "s"}) ||
         has_all({"ins_x", "ins_y", "ins_z"});
}

/// Between two blanks and more: "Pos X  Pos Y".
std::vector<std::string_view> split_wide(std::string_view row) {
  std::vector<std::string_view> found;
  while (!row.empty() && found.size() < kMaxWords) {
    const std::size_t gap = row.find("  ");
    found.push_back(trimmed(row.substr(0, gap)));
    row = gap == std::string_view::npos ? std::string_view() : trimmed(row.substr(gap));
  }
  return found;
}

std::optional<double> with_decimal_comma(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return to_number(text);
}

bool is_number(std::string_view field) { return with_decimal_comma(field).has_value(); }

bool holds_a_point(const std::vector<std::string_view>& fields) {
  return std::count_if(fields.begin(), fields.end(), is_number) >= 3;
}

/// Lines above the names that hold no point, as some programs write a title.
bool are_titles(const std::vector<CsvRow>& rows) {
  return std::none_of(rows.begin(), rows.end(),
                      [](const CsvRow& row) { return holds_a_point(row.fields); });
}

/// Of a line that has one of `columns`, whatever is between its fields; else none. Of points, words between blanks and comments are
/// names if all three axes are among them; words of a comment after two blanks are not of its names.
std::optional<ColumnNames> names_in(std::string_view line, bool comment,
                                    std::initializer_list<std::string_view> columns) {
  if (line.starts_with(kSlicersColumns)) line = trimmed(line.substr(kSlicersColumns.size()));
  const char separator = separator_of(line);
  if (comment && separator != ' ') line = line.substr(0, line.find("  "));
  if (separator == ' ' && line.find("  ") != std::string_view::npos)
    if (ColumnNames wide = column_names(split_wide(line)); has_axes(wide.names)) return wide;
  const std::vector<std::string_view> fields = split(line, separator);
  if (holds_a_point(fields)) return {};
  ColumnNames names = column_names(fields);
  if (has_axes(names.names)) return names;
  const bool needs_axes = comment || separator == ' ';
  const bool has_one = std::any_of(columns.begin(), columns.end(), [&](std::string_view column) {
    const bool of_points = std::find(kOfPoints.begin(), kOfPoints.end(), column) != kOfPoints.end();
    return !(needs_axes && of_points) &&
           std::find(names.names.begin(), names.names.end(), column) != names.names.end();
  });
  if (has_one) return names;
  return {};
}

/// Of a row of units, as some programs write below the names: one for each field, or nothing for what has none; else empty.
std::vector<std::string> unit_row(std::string_view line) {
  std::vector<std::string> units;
  for (const std::string_view field : split(line, separator_of(line))) {
    const std::string_view word = trimmed(field.substr(0, field.find_last_not_of(")]") + 1));
    const std::string_view name = word.substr(std::min(word.find_first_not_of("[("), word.size()));
    const bool none = name.empty() || name == "-";
    if (!none && !unit_in_mm(name)) return {};
    units.emplace_back(none ? "" : name);
  }
  const auto stated = std::count_if(units.begin(), units.end(),
                                    [](const std::string& unit) { return !unit.empty(); });
  return stated < 3 ? std::vector<std::string>{} : units;
}

/// "cm" of a comment "units: cm" or "coordinates in cm"; empty: it states none.
std::string unit_in_comment(std::string_view comment) {
  constexpr std::array<std::string_view, 8> kWhat = {
      "unit", "units", "coordinate", "coordinates", "positions", "points", "length", "lengths"};
  bool stated = false;
  std::string word;
  for (std::size_t i = 0; i <= comment.size(); ++i) {
    const auto c = i < comment.size() ? static_cast<unsigned char>(comment[i]) : 0;
    if (std::isalpha(c) != 0 || c >= 0x80) {
      word += static_cast<char>(std::tolower(c));
      continue;
    }
    if (stated && word != "in" && unit_in_mm(word)) return word;
    stated = stated || std::find(kWhat.begin(), kWhat.end(), word) != kWhat.end();
    word.clear();
  }
  return {};
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
    if (table.unit.empty()) table.unit = unit_named(unit) || !unit_in_mm(unit) ? unit : "mm";
    if (table.no_unit.empty() && !unit_in_mm(unit) && !is_axes_or_number(unit))
      table.no_unit = unit;
  }
}

/// Whether a first field that has no name is the name of its row, as R writes it: a word, or the row's number.
bool is_row_name(const std::optional<double>& number, std::size_t row) {
  return !number || *number == static_cast<double>(row) || *number == static_cast<double>(row + 1);
}

/// "0,1,2" above rows with decimals: pandas's names of columns that have none.
void take_numbered_names(CsvTable& table) {
  if (!table.names.empty() || table.rows.size() < 2) return;
  std::vector<std::string_view> first = table.rows[0].fields;
  const bool row_names = first.size() == 4 && first[0].empty();
  if (row_names) first.erase(first.begin());
  const auto& second = table.rows[1].fields;
  if (first != std::vector<std::string_view>{"0", "1", "2"} ||
      std::none_of(second.begin(), second.end(), [](std::string_view field) {
        return field.find_first_of(".,e") != std::string_view::npos;
      }))
    return;
  table.names = {"x", "y", "z"};
  if (row_names) table.names.insert(table.names.begin(), "");
  table.rows.erase(table.rows.begin());
}

/// Of coordinates without one of their own.
void take_unit_of_comment(CsvTable& table, const std::string& unit) {
  if (unit.empty() || !table.unit.empty() || table.rows.empty()) return;
  table.units.assign(table.rows[0].fields.size(), unit);
  table.unit = unit_named(unit) ? unit : "mm";
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
  return decimal_commas ? with_decimal_comma(field) : to_number(field);
}

bool is_table_format(std::string_view format) {
  return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end();
}

std::string plain_name(std::string_view name) { return column_names({name}).names[0]; }

Expected<CsvTable> read_csv(std::string_view text,
                            std::initializer_list<std::string_view> columns) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    return Error{ErrorCode::Unsupported, "", "is a table in UTF-16; save it as UTF-8"};
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CsvTable table;
  char separator = 0;
  std::string unit_of_comment;
  LineScanner lines(text);
  while (const auto line = lines.next()) {
    bool comment = false;
    const std::string_view content = without_mark(trimmed(line->text), comment);
    if (content.empty() || (content.starts_with("sep=") && content.size() == 5)) continue;
    if (table.names.empty() ? are_titles(table.rows) : table.rows.empty()) {
      if (auto names = names_in(content, comment, columns)) {
        table.names = std::move(names->names);
        table.units = std::move(names->units);
        table.axes = std::move(names->axes);
        table.may_go_on = content.starts_with(kSlicersColumns);
        take_unit_of_coordinates(table);
        table.rows.clear();
        separator = 0;
        continue;
      }
      if (unit_of_comment.empty() && comment) unit_of_comment = unit_in_comment(content);
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
    std::vector<std::string_view> fields = split(content, separator);
    if (std::all_of(fields.begin(), fields.end(), [](auto field) { return field.empty(); }))
      continue;  // ";;;", a spreadsheet's empty row
    for (const std::string_view field : fields)
      table.decimal_commas = table.decimal_commas || field.find(',') != std::string_view::npos;
    table.rows.push_back({line->number, std::move(fields)});
    if (table.rows.size() > kMaxRows)
      return Error{ErrorCode::OutOfRange, "", "has more than the 100,000 rows accepted"};
  }
  if (std::find(columns.begin(), columns.end(), "x") != columns.end()) take_numbered_names(table);
  take_unit_of_comment(table, unit_of_comment);
  drop_row_names(table);
  return table;
}

}  // namespace coapt
