#include "io/mesh/csv_table.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr std::size_t kMaxRows = 100'000;

/// Whether fields are between semicolons; their numbers may then have decimal commas, one more than there are semicolons.
bool has_semicolons(std::string_view row) {
  const auto semicolons = std::count(row.begin(), row.end(), ';');
  return semicolons >= 2 && std::count(row.begin(), row.end(), ',') <= semicolons + 1;
}

}  // namespace

Expected<CsvTable> read_csv(std::string_view text,
                            std::initializer_list<std::string_view> columns) {
  CsvTable table;
  LineScanner lines(text);
  while (const auto line = lines.next()) {
    std::string_view content = trimmed(line->text);
    const bool comment = content.starts_with('#');
    if (comment) content = trimmed(content.substr(1));
    if (content.empty()) continue;
    auto row = fields(content);
    if (table.rows.empty() &&
        std::find_first_of(row.begin(), row.end(), columns.begin(), columns.end()) != row.end()) {
      table.names = std::move(row);
    } else if (!comment) {
      if (table.rows.empty() && has_semicolons(content))
        return Error{
            ErrorCode::WrongType, "",
            "line " + std::to_string(line->number) +
                " has semicolons between its fields; must have commas, and points in numbers"};
      table.rows.push_back({line->number, std::move(row)});
    }
    if (table.rows.size() > kMaxRows) {
      return Error{ErrorCode::OutOfRange, "", "has more than the 100,000 rows accepted"};
    }
  }
  return table;
}

}  // namespace coapt
