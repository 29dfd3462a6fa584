// Tables that come beside leaflet meshes.
#pragma once

#include <string_view>
#include <vector>

#include "io/mesh/import_valve.h"

namespace coapt {

/// Lines x,y,z in millimetres; '#' comments; a first line x,y,z or x_mm,y_mm,z_mm is passed over.
Expected<Points> read_points_csv(std::string_view text);

/// Lines papillary,x,y,z in millimetres, papillary AL or PM; '#' comments; a first line of these names is passed over.
Expected<std::vector<ImportedTip>> read_tips_csv(std::string_view text);

/// @param format "csv" or "json".
/// CSV: columns id, papillary (AL or PM), ins_x, ins_y, ins_z, tip_x, tip_y, tip_z and, if there is
/// one, kind (marginal, strut, basal), named in a comment or in the first line; other columns are
/// passed over. Without names: id,leaflet,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z, more
/// fields are passed over. JSON: {"chordae": [{"id": "1", "papillary": "AL", "kind": "marginal",
/// "insertion_mm": [x, y, z], "tip_mm": [x, y, z]}]}, kind may be left out. Errors name row and
/// column ("/chordae/3/ins_x"), in CSV also the line.
Expected<std::vector<ImportedChorda>> read_chordae(std::string_view text, std::string_view format);

}  // namespace coapt
