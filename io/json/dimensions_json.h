// A valve by its dimensions and what disease changed: coapt.dimensions/1, what `coapt valve make` reads and `coapt valve calibrate`
// writes.
//
// {"schema": "coapt.dimensions/1", "name": "...", "dimensions": {"ap_mm": 25.9, ...}, "remodelling": {"ap_dilation_percent": 18,
// "ruptured": ["P2"], ...}, "disease": "in words"}: all but the schema may be left out. Names and ranges are those of
// dimension_table() and Remodelling.
#pragma once

#include <string>
#include <string_view>

#include "core/presets/human_presets.h"
#include "io/json/json_reader.h"

namespace coapt {

/// Every problem is listed, with its pointer and what is accepted.
Expected<HumanValve> read_dimensions(std::string_view text);
std::string write_dimensions(const HumanValve& valve);

/// Parts of such a document. Ranges of dimensions are checked, those of a remodelling by remodel().
void read_dimension_fields(const JsonPlace& place, ParametricValve& dimensions);
Remodelling read_remodelling(const JsonPlace& place);

/// Rounded: what is derived from a tissue is off in the last of sixteen digits, and files are read by people.
double six_digits(double value);

}  // namespace coapt
