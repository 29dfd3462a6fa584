#include "io/mesh/csv_table.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr std::size_t kMaxRows = 100'000;

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
      table.rows.push_back({line->number, std::move(row)});
    }
    if (table.rows.size() > kMaxRows) {
      return Error{ErrorCode::OutOfRange, "", "has more than the 100,000 rows accepted"};
    }
  }
  return table;
}

}  // namespace coapt
