// Keeps with a valve what images show of it, by which later answers are weighed. Answers the file of the valve (coapt.valve/1).
#include "core/valve/validate.h"
#include "io/json/valve_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

struct ObserveRequest {
  Valve valve{};
  std::vector<Observation> observed{};
  bool forget = false;
};

Valve observed_valve(const ObserveRequest& asked) {
  Valve valve = asked.valve;
  if (asked.forget) valve.observed.clear();
  for (const Observation& seen : asked.observed) observe(valve.observed, seen);
  return valve;
}

}  // namespace

Expected<OperationTask> read_observe(const Json& request, const Context& context) {
  ObserveRequest asked;
  ProblemList problems;
  read_fields({request, problems}, {{"valve", valve_field(context, asked.valve)},
                                    {"observed", into(asked.observed, read_observed), false},
                                    {"forget", into(asked.forget, read_boolean), false}});
  if (problems.empty() && asked.observed.empty() && !asked.forget)
    problems.add(ErrorCode::MissingField, "/observed", "is required, or forget");
  if (!problems.empty()) return std::move(problems).take();
  const Valve valve = observed_valve(asked);
  if (Errors errors = validate(valve); !errors.empty()) return errors;
  return OperationTask{0, 0, [valve](Context&) -> Expected<OperationAnswer> {
                         return OperationAnswer(AnswerFile{"application/json", write_valve(valve)});
                       }};
}

}  // namespace coapt
