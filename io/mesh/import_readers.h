// Tables that come beside leaflet meshes.
#pragma once

#include <string_view>
#include <vector>

#include "io/mesh/csv_table.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Columns x, y and z by name (csv_table.h), in any order beside others, or three columns without names. Where columns state
/// different units, all become that of the first, stated_unit().
Expected<Points> read_points_csv(std::string_view text);

/// The unit that the names of a table's coordinates state ("x [cm]"), the first of several; none: they state none of these.
/// @param columns of the table, one of which its line of names has.
std::optional<LengthUnit> stated_unit(std::string_view table,
                                      std::initializer_list<std::string_view> columns = {"x"});

/// The same with papillary, label or name, which papillary_side() reads; without names it comes first.
Expected<std::vector<ImportedTip>> read_tips_csv(std::string_view text);

struct LabelledPoint {
  std::string label;
  Vec3 position_mm = Vec3::Zero();
};

/// Columns label (or name), x, y and z; without names the label comes first.
Expected<std::vector<LabelledPoint>> read_labelled_points_csv(std::string_view text);

/// The named columns of a table but those `used` by a reader; x stands for the names of all axes.
LeftOver unused_columns(const CsvTable& table, std::initializer_list<std::string_view> used);

/// @param format is_table_format() or "json".
/// Table: columns id (else the number of the row), papillary (AL or PM), ins_x, ins_y, ins_z, tip_x, tip_y, tip_z and, if there is
/// one, kind (marginal, strut, basal), named in a comment or in the first line; other columns are
/// passed over. Without names: id,leaflet,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z, more
/// fields are passed over. JSON: {"chordae": [{"id": "1", "papillary": "AL", "kind": "marginal",
/// "insertion_mm": [x, y, z], "tip_mm": [x, y, z]}]}, kind may be left out. Errors name row and
/// column ("/chordae/3/ins_x"), in CSV also the line.
Expected<std::vector<ImportedChorda>> read_chordae(std::string_view text, std::string_view format);

}  // namespace coapt
