// A valve and a repair plan in a request: what most operations are asked for with.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "io/json/repair_answers.h"
#include "operations/operation.h"

namespace coapt {

enum class AcceptedValve {
  Mitral,
  Any  ///< coapt.valve/2, too, by name; it takes neither plan nor material
};

/// Reads a valve that is written there (coapt.valve/1) or named there (Context::valve_named), of the size that the context takes.
std::function<void(const JsonPlace&)> valve_field(const Context& context, Valve& target,
                                                  AcceptedValve accepted = AcceptedValve::Mitral);

/// Reads "valve", "plan" and "material" (optional) and the fields `more`, and applies the plan. Returns every problem.
Errors read_repair(const Json& request, const Context& context, std::vector<JsonField> more,
                   RepairRequest& asked, AcceptedValve accepted = AcceptedValve::Mitral);

/// The task that `run(asked, context)` is, by some `closures` closures of the valve.
template <class Asked, class Run>
OperationTask task_of(std::shared_ptr<Asked> asked, std::ptrdiff_t closures, Run run) {
  return {
      asked->repair.repaired.rest_mm.rows(), closures,
      [asked, run](Context& context) -> Expected<OperationAnswer> { return run(*asked, context); }};
}

/// What `run(repair, context)` answers to a request without fields of its own.
template <class Run>
Expected<OperationTask> plain_task(const Json& request, const Context& context,
                                   std::ptrdiff_t closures, Run run) {
  struct Asked {
    RepairRequest repair{};
  };
  const auto asked = std::make_shared<Asked>();
  if (Errors errors = read_repair(request, context, {}, asked->repair); !errors.empty())
    return errors;
  return task_of(asked, closures,
                 [run](const Asked& read, Context& within) { return run(read.repair, within); });
}

}  // namespace coapt
