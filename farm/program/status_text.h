// What the database says of runs and workers (coapt.farm/1), for people and for Prometheus.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>

namespace coapt {

/// Behind "12 of 100": "items, 340/s, 17 s left, 3 workers".
std::string progress_words(const nlohmann::ordered_json& progress);

void print_farm(std::ostream& out, const nlohmann::ordered_json& status);

/// Prometheus' text format.
void print_prometheus(std::ostream& out, const nlohmann::ordered_json& status);

}  // namespace coapt
