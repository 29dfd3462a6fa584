#include "clients/python/engine/local_valve.h"

#include <chrono>
#include <utility>

#include "clients/python/engine/problems.h"
#include "core/closure/closure.h"
#include "core/repair/apply_plan.h"
#include "core/valve/validate.h"
#include "io/json/parse_json.h"
#include "io/json/plan_json.h"
#include "io/json/repair_answers.h"
#include "io/json/valve_json.h"
#include "search/plans/gates.h"

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

namespace {

Expected<std::vector<MaterialValue>> parse_material(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  std::vector<MaterialValue> material = read_material({*json, problems});
  if (!problems.empty()) return std::move(problems).take();
  return material;
}

}  // namespace

LocalValve with_material(const LocalValve& valve, std::string_view material) {
  return {std::make_shared<const Valve>(taken(
      with_material(*valve.valve, taken(parse_material(material), "/material")), "/material"))};
}

LocalClosure close_locally(const LocalValve& valve, std::string_view plan,
                           std::string_view material) {
  LocalClosure closed{.valve = valve.valve, .repaired = valve.valve};
  if (!material.empty()) closed.valve = with_material(valve, material).valve;
  closed.repaired = closed.valve;
  if (!plan.empty()) {
    closed.plan = taken(read_plan(plan), "/plan");
    closed.repaired =
        std::make_shared<const Valve>(taken(apply_plan(*closed.valve, closed.plan), "/plan"));
  }
  const auto start = std::chrono::steady_clock::now();
  closed.closure = close_valve(*closed.repaired);
  closed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  closed.measure = measure(*closed.repaired, closed.closure);
  closed.warnings = warnings_of(operation_gates({closed.plan, *closed.valve, *closed.repaired}));
  return closed;
}

std::string document_of(const LocalClosure& closed) {
  Json json = closure_answer({*closed.valve, closed.plan, *closed.repaired}, closed.closure,
                             closed.measure, closed.seconds);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace coapt
