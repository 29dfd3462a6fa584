// What the database says of runs and workers (coapt.farm/1), for people and for Prometheus.
#pragma once

#include <ostream>
#include <string>

#include "io/json/json_fwd.h"

namespace coapt {

/// Behind "12 of 100": "items, 340/s, 17 s left, 3 workers".
std::string progress_words(const Json& progress);

void print_farm(std::ostream& out, const Json& status);

/// Prometheus' text format.
void print_prometheus(std::ostream& out, const Json& status);

}  // namespace coapt
