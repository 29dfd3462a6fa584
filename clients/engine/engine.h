// coapt's engine without a service: what it answers to requests on one valve, for the page in a browser (WebAssembly).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/valve/types.h"
#include "operations/operation.h"

namespace coapt {

struct EngineAnswer {
  int status = 200;  ///< as of HTTP
  std::string body;  ///< JSON
  /// What /v1/closures and /v1/scenes closed, |V| x 3, unrounded; else empty.
  Points closed_mm = {};
};

/// The service's own answers (server/openapi.json): to the requests of valve_operations(), and to GET /v1/rings, with an empty
/// body, and /version. A valve comes as a document, not by name; 404 for any other path.
///
/// What the service does not have, the trainer (docs/training.md): POST /v1/training/cases {"valve", "exam": "A" or "B", "seed"}
/// answers coapt.training_case/1 with its shapes; /v1/training/exams {"schedule", "seed", "first_case"} coapt.training_exam/1;
/// /v1/training/scores {"trials_csv"} coapt.training_score/1.
/// With `further`, if that is set, to the requests of its operations, too.
EngineAnswer answer(std::string_view path, std::string_view body);

/// What a program sets before main(): plan_operations(), which make the module half as large again, and Context::searches of them.
struct FurtherOperations {
  std::span<const Operation> (*all)() = nullptr;
  Errors (*searches)(const Valve&, const SearchOptions&, SearchContext&) = nullptr;
};
extern FurtherOperations further;

}  // namespace coapt
