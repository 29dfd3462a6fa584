// What a fit of a valve to its measured closed state answers, as JSON.
#pragma once

#include <optional>
#include <string>

#include "io/json/json.h"
#include "search/fit/fit.h"

namespace coapt {

/// What a command was given.
struct FittedFiles {
  std::string valve, closed;
  MeasuredClosure measured;
};

/// coapt.fit/1. Keys that scripts rely on: rms_mm, rms_before_mm, best_rms_mm, look (a person should check it; doubts[] says why), parameters[] (name, value, sd, identifiable); with FitOptions::ruptures
/// hypotheses[] (name, probability, rms_mm, leak_mm2, refitted, taken).
Json fit_to_json(const ValveFit& fit, const FittedFiles& files);

/// Where a fit was, for whoever keeps it: numbers come back bit for bit. None if `json` is no such state.
Json to_json(const FitState& state);
std::optional<FitState> fit_state_from_json(const Json& json);

}  // namespace coapt
