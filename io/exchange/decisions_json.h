// What an import decided and made, as JSON.
#pragma once

#include <vector>

#include "io/json/json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// [{"subject", "value", "reason", "look", "confidence"}, ...]
inline Json to_json(const std::vector<ImportDecision>& decisions) {
  Json list = Json::array();
  for (const ImportDecision& of : decisions)
    list.push_back({{"subject", of.subject},
                    {"value", of.value},
                    {"reason", of.reason},
                    {"look", of.look},
                    {"confidence", of.confidence}});
  return list;
}

/// [{"leaflet", "mean_mm", "p10_mm", "p90_mm"}, ...] of leaflets that came as shells; leaflets count from 0.
inline Json to_json(const std::vector<MeasuredThickness>& thickness) {
  Json list = Json::array();
  for (const MeasuredThickness& of : thickness)
    list.push_back({{"leaflet", of.leaflet},
                    {"mean_mm", of.mean_mm},
                    {"p10_mm", of.p10_mm},
                    {"p90_mm", of.p90_mm}});
  return list;
}

/// [{"number", "part"}, ...]; part: anterior, posterior or annulus, null where it was not used.
inline Json to_json(const std::vector<SourcePart>& parts) {
  Json list = Json::array();
  for (const SourcePart& of : parts)
    list.push_back({{"number", of.number}, {"part", of.part.empty() ? Json() : Json(of.part)}});
  return list;
}

/// coapt.import/2. Keys that scripts rely on: decisions[] (subject, value, reason, look, confidence).
inline Json import_to_json(const ImportedValve& imported) {
  return result_document("coapt.import/2", {{"name", imported.valve.name},
                                            {"triangles", imported.valve.faces.rows()},
                                            {"chordae", imported.valve.chordae.size()},
                                            {"unit", to_string(imported.unit)},
                                            {"closed", imported.input.closed},
                                            {"labels", to_json(imported.parts)},
                                            {"thickness", to_json(imported.thickness)},
                                            {"decisions", to_json(imported.decisions)}});
}

}  // namespace coapt
