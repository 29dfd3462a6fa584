#include "server/json_body.h"

#include <algorithm>

#include "core/presets/presets.h"
#include "core/valve/nearest_name.h"
#include "io/json/parse_json.h"
#include "io/json/valve_json.h"
#include "io/store/stored_valves.h"
#include "operations/repair_request.h"
#include "server/answers.h"
#include "server/memory.h"
#include "server/turns.h"

namespace coapt {
namespace {

/// Freed without taking memory.
struct Document {
  ~Document() {
    if (json) take_apart(*json);
  }
  Expected<Json> json;
};

Expected<Valve> found_valve(const ValveSource& source, const std::string& name) {
  const std::vector<std::string>& presets = preset_names();
  if (std::find(presets.begin(), presets.end(), name) != presets.end()) return make_preset(name);
  const Expected<std::optional<std::string>> stored = stored_valve(source.store, name);
  if (!stored) return stored.errors();
  if (!*stored)
    return Error{ErrorCode::BadReference, "",
                 "is neither the id of a stored valve nor the name of a preset (/v1/presets)" +
                     did_you_mean(name, presets)};
  return read_valve(**stored);
}

}  // namespace

Expected<Valve> named_valve(const ValveSource& source, const std::string& name) {
  if (const auto known = source.known.find(name)) return *known;
  Expected<Valve> valve = found_valve(source, name);
  if (valve) source.known.add(name, *valve);
  return valve;
}

std::function<void(const JsonPlace&)> valve_field(const ValveSource& source, Valve& target) {
  return [&target, source](const JsonPlace& place) {
    const Context context{
        .limits = operation_limits(source.limits),
        .valve_named = [&](const std::string& name) { return named_valve(source, name); }};
    valve_field(context, target)(place);
  };
}

std::size_t most_values(const ServiceLimits& limits) {
  constexpr std::size_t kOfAVertex = 75, kOfAChorda = 100, kOther = 100'000;
  return kOfAVertex * static_cast<std::size_t>(limits.vertices) +
         kOfAChorda * static_cast<std::size_t>(limits.chordae) + kOther;
}

double reading_seconds(const Request& request) {
  constexpr double kOfAMebibyte_s = 0.05;
  return 1e-3 + kOfAMebibyte_s * static_cast<double>(request.body.size()) / (1 << 20);
}

std::optional<Answer> read_body(const ValveSource& source, const Request& request,
                                const std::function<Errors(const Json&)>& read) {
  Compute::Turn turn(source.parsing, {reading_seconds(request), request.client});
  if (!turn) return retry_later(503, "too many requests are being read", turn.retry_after_s());
  const MayRunOut hungry;
  const Document document{parse_json(request.body, most_values(source.limits))};
  if (!document.json) return problem(400, document.json.errors());
  if (const Errors errors = read(*document.json); !errors.empty()) return problem(422, errors);
  return std::nullopt;
}

std::optional<Answer> read_body(const ValveSource& source, const Request& request,
                                const std::vector<JsonField>& fields) {
  return read_body(source, request, [&fields](const Json& document) {
    ProblemList problems;
    read_fields({document, problems}, fields);
    return std::move(problems).take();
  });
}

}  // namespace coapt
