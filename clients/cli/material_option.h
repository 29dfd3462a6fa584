// --pressure, --radial-extension, ...: pressure and tissue in place of a valve's own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/valve/dimension_table.h"
#include "io/command_line/command_line.h"
#include "io/json/json.h"

namespace coapt {

/// "--ap-mm" of "ap_mm"; "--pressure" of "pressure_mmhg", as of `open`.
std::string flag_of(const Dimension& dimension);

struct MaterialOption {
  std::vector<std::optional<double>> given{};  ///< order of material_table()
};

/// @param option must not move afterwards.
void add_material_option(Command command, MaterialOption& option);

bool is_given(const MaterialOption& option);
std::vector<MaterialValue> values_of(const MaterialOption& option);
/// For a request's "material".
Json material_json(const MaterialOption& option);

}  // namespace coapt
