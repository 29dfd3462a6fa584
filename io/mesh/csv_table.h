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
  std::vector<std::string> names;  ///< of the columns (column_names.h); empty if they are not given
  std::string axes;                ///< that the names state beside x, y and z: "ras"; else empty
  std::vector<CsvRow> rows;
  /// Of the columns, as their names, a row below them or a comment state: "cm" of "x [cm]", "x_cm" or "# units: cm"; empty: not
  /// stated.
  std::vector<std::string> units;
  /// The first that a coordinate states; "mm" if that is micrometres; else empty.
  std::string unit;
  /// The first that a coordinate states and that is no unit of length ("px"), nor axes or a number; else empty.
  std::string no_unit;
  bool decimal_commas = false;  ///< "1,5" is a number
  bool may_go_on = false;  ///< rows may have more fields than names, as Slicer 5 writes its lists

  bool has(std::string_view column) const;
  std::optional<double> number(std::string_view field) const;
};

/// "csv", "txt", "tsv", "dat", "xyz" or "fcsv" (Slicer's old lists of points).
bool is_table_format(std::string_view format);

/// As columns are compared (column_names.h).
std::string plain_name(std::string_view name);

/// The names are those of the last line before the first row of three numbers, comment or not, that has one of
/// `columns` as a field or all axes: x, y, z, Slicer's r, a, s or l, p, s, or ins_x, ins_y, ins_z. Comments begin with #, % or //.
/// Numbers may have decimal commas where fields are between something else. A
/// first field of every row that has no name is a row's name, and left out; rows of nothing are, too. At most 100,000 rows.
/// Unsupported: UTF-16.
Expected<CsvTable> read_csv(std::string_view text, std::initializer_list<std::string_view> columns);

}  // namespace coapt
