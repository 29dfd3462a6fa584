// The valve file: schema coapt.valve/1, a mitral valve (io/schema/valve.schema.json), and coapt.valve/2,
// one with any number of leaflets (io/schema/leaflet_valve.schema.json).
#pragma once

#include <string>
#include <string_view>

#include "core/valve/valve.h"
#include "io/json/json_reader.h"

namespace coapt {

/// Reads and validates. Every problem is listed, with its JSON pointer and what is accepted; a
/// valve is returned only when there is none. Input over 64 MiB or nested deeper than 32 is
/// refused.
Expected<Valve> read_valve(std::string_view text);

/// The same, and coapt.valve/2 too: for what needs neither landmarks nor segments.
Expected<Valve> read_any_valve(std::string_view text);

/// The same as read_valve() for a document already parsed (by parse_json); pointers start at `json`.
Expected<Valve> valve_from_json(const Json& json);

/// Round trip: read_any_valve(write_valve(v)) gives the same bits.
/// @pre validate(valve) is empty.
std::string write_valve(const Valve& valve);

/// What a valve file says of a mitral valve's tissue and pressure, by itself: schema coapt.tissue/1.
struct TissueFile {
  Tissue tissue;
  double pressure_kpa = 0.0;
};

/// Form alone is checked.
Expected<TissueFile> read_tissue_file(std::string_view text);
std::string write_tissue_file(const TissueFile& file);

/// {"leak_mm2": {"value", "sd", "source"}, ...}, as of a valve's "observed"; form alone is checked.
std::vector<Observation> read_observed(const JsonPlace& place);
Json to_json(const std::vector<Observation>& observed);

/// Stand-in Anterolateral.
Side read_side(const JsonPlace& place);

}  // namespace coapt
