#include "operations/repair_request.h"

#include "core/valve/leaflets.h"
#include "io/json/plan_json.h"
#include "io/json/valve_json.h"

namespace coapt {

std::function<void(const JsonPlace&)> valve_field(const Context& context, Valve& target,
                                                  AcceptedValve accepted) {
  return [&context, &target, accepted](const JsonPlace& place) {
    const bool named = place.value.is_string() && context.valve_named;
    Expected<Valve> valve =
        named ? context.valve_named(place.value.get<std::string>()) : valve_from_json(place.value);
    if (!valve) return add_below(place.problems, pointer(place), valve.errors());
    if (accepted == AcceptedValve::Mitral && !is_mitral(*valve))
      return place.problems.add(ErrorCode::Unsupported, pointer(place) + "/schema",
                                "is \"coapt.valve/2\", which can only be closed and checked; must "
                                "be \"coapt.valve/1\", a mitral valve");
    add_below(place.problems, pointer(place), check_size(*valve, context.limits));
    target = *std::move(valve);
  };
}

Errors read_repair(const Json& request, const Context& context, std::vector<JsonField> more,
                   RepairRequest& asked, AcceptedValve accepted) {
  more.insert(more.begin(), {{"valve", valve_field(context, asked.valve, accepted)},
                             {"plan", document(asked.plan, plan_from_json), false},
                             material_field(asked.material)});
  ProblemList problems;
  read_fields({request, problems}, more);
  if (!problems.empty()) return std::move(problems).take();
  if (is_mitral(asked.valve)) return apply(asked);
  for (const char* name : {"plan", "material"})
    if (request.contains(name))
      problems.add(ErrorCode::Unsupported, std::string("/") + name,
                   "needs a mitral valve (coapt.valve/1); this is coapt.valve/2");
  asked.repaired = asked.valve;
  return std::move(problems).take();
}

}  // namespace coapt
