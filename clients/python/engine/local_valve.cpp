#include "clients/python/engine/local_valve.h"

#include <chrono>
#include <utility>

#include "clients/python/engine/problems.h"
#include "core/closure/closure.h"
#include "core/valve/validate.h"
#include "io/json/plan_json.h"
#include "io/json/valve_json.h"

namespace coapt {

LocalValve local_valve(std::string_view document, const std::string& path) {
  return {std::make_shared<const Valve>(taken(read_valve(document), path))};
}

LocalValve with_arrays(const LocalValve& valve, const NewArrays& arrays) {
  Valve changed = *valve.valve;
  if (arrays.vertices_mm) changed.rest_mm = *arrays.vertices_mm;
  if (arrays.faces) changed.faces = *arrays.faces;
  if (arrays.annulus_mm) changed.annulus_mm = *arrays.annulus_mm;
  if (const Errors errors = validate(changed); !errors.empty()) throw Problems(errors);
  return {std::make_shared<const Valve>(std::move(changed))};
}

LocalClosure close_locally(const LocalValve& valve, std::string_view plan) {
  LocalClosure closed;
  closed.asked.valve = *valve.valve;
  if (!plan.empty()) closed.asked.plan = taken(read_plan(plan), "/plan");
  if (const Errors errors = apply(closed.asked); !errors.empty()) throw Problems(errors);
  const auto start = std::chrono::steady_clock::now();
  closed.closure = close_valve(closed.asked.repaired);
  closed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return closed;
}

std::string document_of(const LocalClosure& closed) {
  nlohmann::ordered_json json = closure_answer(closed.asked, closed.closure, closed.seconds);
  json["notice"] = kResearchNotice;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace coapt
