// Comma-separated tables with '#' comments and, perhaps, names of columns.
#pragma once

#include <initializer_list>
#include <string>

#include "core/valve/types.h"
#include "io/mesh/text_scan.h"

namespace coapt {

struct CsvRow {
  int line = 0;
  std::vector<std::string_view> fields;
};

/// Views into the text it was read from.
struct CsvTable {
  std::vector<std::string_view> names;  ///< of the columns; empty if they are not given
  std::vector<CsvRow> rows;
};

/// The names are those of the last line before the first row, comment or not, that has one of
/// `columns` as a field. At most 100,000 rows;
/// fields between semicolons, as spreadsheets in some languages write them, are one error.
Expected<CsvTable> read_csv(std::string_view text, std::initializer_list<std::string_view> columns);

}  // namespace coapt
