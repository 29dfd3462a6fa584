// Judges a valve document without closing it: {"valid", "problems"}. The request is the document itself.
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "operations/table.h"

namespace coapt {

Expected<OperationTask> read_check(const Json& request, const Context& context) {
  const Expected<Valve> valve = valve_from_json(request);
  const Errors problems = valve ? check_size(*valve, context.limits) : valve.errors();
  return OperationTask{
      0, 0, [problems](Context&) -> Expected<OperationAnswer> {
        return OperationAnswer(Json{{"valid", problems.empty()}, {"problems", to_json(problems)}});
      }};
}

}  // namespace coapt
