// Tables as spreadsheets and other programs write them: fields between commas, semicolons, tabs or blanks, comments, and,
// perhaps, names of columns.
#pragma once

#include <initializer_list>
#include <string>

#include "core/valve/types.h"
#include "io/mesh/text_scan.h"

namespace coapt {

struct CsvRow {
  int line = 0;
  std::vector<std::string_view> fields;  ///< trimmed, without quotes
};

/// Views into the text that it was read from.
struct CsvTable {
  std::vector<std::string>
      names;  ///< of the columns, plain_name() of each; empty if they are not given
  std::vector<CsvRow> rows;
  /// Of the columns, as their names or a row below them state: "cm" of "x [cm]" or "x_cm"; empty: not stated.
  std::vector<std::string> units;
  std::string unit;  ///< the first that a coordinate states; else empty
  /// The first that a coordinate states and that is no unit of length ("px"), nor axes or a number; else empty.
  std::string no_unit;
  bool decimal_commas = false;  ///< "1,5" is a number
  bool may_go_on = false;  ///< rows may have more fields than names, as Slicer 5 writes its lists

  bool has(std::string_view column) const;
  std::optional<double> number(std::string_view field) const;
};

/// "csv", "txt", "tsv", "dat", "xyz" or "fcsv" (Slicer's old lists of points).
bool is_table_format(std::string_view format);

/// As columns are compared: in lower case, without quotes and units ("X [mm]", "x_mm" and ParaView's "Points:0" are x).
std::string plain_name(std::string_view name);

/// The names are those of the last line before the first row, comment or not, that has one of
/// `columns` as a field or, where x is one, the axes r, a, s or l, p, s. Comments begin with #, % or //. Numbers may have decimal commas where fields are between something else. A
/// first field of every row that has no name is a row's name, and left out. At most 100,000 rows. Unsupported: UTF-16.
Expected<CsvTable> read_csv(std::string_view text, std::initializer_list<std::string_view> columns);

}  // namespace coapt
