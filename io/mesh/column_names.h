// Headings of columns as spreadsheets, viewers and finite element codes write them, and what they mean.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coapt {

struct ColumnNames {
  /// Of each column: x, y, z, r, a, s, l, p, ins_x to tip_z, papillary; else the heading in lower case, without quotes and unit.
  std::vector<std::string> names;
  std::vector<std::string>
      units;  ///< of each, as stated: "cm" of "x [cm]", "x_cm", "Xcm" or "x in cm"; empty: not stated
  /// The axes that headings state beside x, y and z, in lower case: "ras" of "x (RAS)", "x_RAS" or "x (R), y (A), z (S)"; else empty.
  std::string axes;
};

/// "Pos X", "pos_x", "PosX", "x-coordinate", "X Location (mm)" and, of three columns, "Points:0", "COORD.COOR1" and "Var1" are x;
/// "Insertion X" is ins_x, "papillary tip x" tip_x, "Side" and "papillary muscle" papillary. Where several headings mean the same,
/// the one that says just that has it, or none.
ColumnNames column_names(const std::vector<std::string_view>& headings);

/// How many millimetres a unit has: those of unit_named() (source_units.h) and micrometres ("um", "microns").
std::optional<double> unit_in_mm(std::string_view name);

}  // namespace coapt
