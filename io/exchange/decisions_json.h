#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "io/mesh/import_valve.h"

namespace coapt {

/// [{"about", "decision", "reason"}, ...]
inline nlohmann::ordered_json to_json(const std::vector<ImportDecision>& decisions) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ImportDecision& of : decisions)
    list.push_back({{"about", of.about}, {"decision", of.decision}, {"reason", of.reason}});
  return list;
}

}  // namespace coapt
