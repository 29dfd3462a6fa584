#include "clients/python/engine/local_valve.h"

#include <optional>
#include <utility>
#include <variant>

#include "clients/python/engine/problems.h"
#include "core/valve/validate.h"
#include "io/json/parse_json.h"
#include "io/json/repair_answers.h"
#include "io/json/valve_json.h"
#include "operations/table.h"

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

LocalClosure close_locally(const LocalValve& valve, std::string_view request) {
  Json asked = taken(parse_json(request));
  asked["valve"] = "this one";
  Context context{.limits = OperationLimits::unlimited()};
  context.valve_named = [&valve](const std::string&) -> Expected<Valve> { return *valve.valve; };
  std::optional<ClosedValve> closed;
  context.closed = [&closed](const ClosedValve& made) { closed = made; };
  OperationAnswer answer = taken(taken(read_close(asked, context)).run(context));
  return {*std::move(closed), std::get<Json>(std::move(answer))};
}

std::string document_of(const LocalClosure& closed) { return json_text(closed.answer); }

}  // namespace coapt
