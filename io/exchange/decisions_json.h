// What an import decided and made, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "io/json/result_json.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// [{"about", "decision", "reason"}, ...]
inline nlohmann::ordered_json to_json(const std::vector<ImportDecision>& decisions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ImportDecision& of : decisions)
    list.push_back({{"about", of.about}, {"decision", of.decision}, {"reason", of.reason}});
  return list;
}

/// coapt.import/1. Keys that scripts rely on: decisions[] (about, decision, reason).
inline nlohmann::ordered_json import_to_json(const ImportedValve& imported) {
  return {{"schema", "coapt.import/1"},
          {"version", version()},
          {"notice", kResearchNotice},
          {"name", imported.valve.name},
          {"triangles", imported.valve.faces.rows()},
          {"chordae", imported.valve.chordae.size()},
          {"decisions", to_json(imported.decisions)}};
}

}  // namespace coapt
