// Reading the bodies of requests: objects whose fields are coapt's own documents.
#pragma once

#include "io/json/json_reader.h"

namespace coapt {

/// Lists `errors`, whose pointers start at `pointer`.
void add_below(ProblemList& problems, const std::string& pointer, const Errors& errors);

/// Reads a field with `from_json` (valve_from_json, plan_from_json, ...); `target` is set if it has
/// no problem.
template <class T>
std::function<void(const JsonPlace&)> document(T& target,
                                               Expected<T> (*from_json)(const nlohmann::json&)) {
  return [&target, from_json](const JsonPlace& place) {
    Expected<T> value = from_json(place.value);
    if (value) {
      target = *std::move(value);
    } else {
      add_below(place.problems, pointer(place), value.errors());
    }
  };
}

}  // namespace coapt
