// Keeps with a valve what images show of it, by which later answers are weighed. Answers the file of the valve (coapt.valve/1).
#include <algorithm>
#include <optional>

#include "core/valve/effective_leak.h"
#include "core/valve/validate.h"
#include "io/json/valve_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct ObserveRequest {
  Valve valve{};
  std::vector<Observation> observed{};
  std::optional<EffectiveLeak> effective{};
  bool forget = false;
};

Valve observed_valve(const ObserveRequest& asked) {
  Valve valve = asked.valve;
  if (asked.forget) valve.observed.clear();
  for (const Observation& seen : asked.observed) observe(valve.observed, seen);
  if (asked.effective) observe(valve.observed, anatomic_leak(*asked.effective));
  return valve;
}

EffectiveLeak read_effective_leak(const JsonPlace& place) {
  EffectiveLeak seen;
  const auto in = [](Range range, const char* unit) {
    return [=](const JsonPlace& at) { return read_number_in(at, range, unit); };
  };
  read_fields(place, {{"value", into(seen.value_mm2, in(kEffectiveLeaks_mm2, " mm2"))},
                      {"sd", into(seen.sd_mm2, in(kEffectiveLeakSds_mm2, " mm2"))},
                      {"discharge", into(seen.discharge, in(kDischarges, "")), false},
                      {"discharge_sd", into(seen.discharge_sd, in(kDischargeSds, "")), false},
                      {"source", into(seen.source, read_string), false}});
  return seen;
}

bool has_leak(const std::vector<Observation>& observed) {
  return std::any_of(observed.begin(), observed.end(),
                     [](const Observation& seen) { return seen.figure == ObservedFigure::Leak; });
}

}  // namespace

Expected<OperationTask> read_observe(const Json& request, const Context& context) {
  ObserveRequest asked;
  ProblemList problems;
  read_fields({request, problems},
              {{"valve", valve_field(context, asked.valve)},
               {"observed", into(asked.observed, read_observed), false},
               {"effective_leak", into(asked.effective, read_effective_leak), false},
               {"forget", into(asked.forget, read_boolean), false}});
  if (asked.effective && has_leak(asked.observed))
    problems.add(ErrorCode::Unsupported, "/effective_leak",
                 "states the same measurement as observed/leak_mm2; give only one of them");
  if (problems.empty() && asked.observed.empty() && !asked.effective && !asked.forget)
    problems.add(ErrorCode::MissingField, "/observed",
                 "is missing; give observed, effective_leak or forget");
  if (!problems.empty()) return std::move(problems).take();
  const Valve valve = observed_valve(asked);
  if (Errors errors = validate(valve); !errors.empty()) return errors;
  return OperationTask{0, 0, [valve](Context&) -> Expected<OperationAnswer> {
                         return OperationAnswer(AnswerFile{"application/json", write_valve(valve)});
                       }};
}

}  // namespace coapt
