#include "clients/cli/ask.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <string_view>
#include <utility>

#include "clients/cli/read_argument.h"
#include "clients/cli/service_job.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/json/named_file.h"
#include "io/json/plan_json.h"
#include "operations/operations.h"

namespace coapt {
namespace {

/// @pre there is one
Operation operation_named(std::string_view name) {
  const std::vector<Operation> all = operations();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Operation& one) { return name == one.name; });
  assert(found != all.end());
  return *found;
}

/// The valve as a request names it, and by that name in the context.
AskedRequest named_valve(const std::string& argument, std::shared_ptr<const Valve> valve) {
  AskedRequest asked{0, {{"valve", argument}}, {{"/valve", argument}}};
  asked.here.valve_named = [valve = std::move(valve)](const std::string&) -> Expected<Valve> {
    return *valve;
  };
  return asked;
}

}  // namespace

void on_run_by(Command command, const std::string& name, const ServerOption& option,
               const std::vector<std::string>& only_here, int& status,
               std::function<int(const std::optional<Service>&)> run) {
  command.on_run([=, &option, &status] {
    const auto service = service_of(command, option, only_here);
    status = service ? run(*service) : report_errors(name, service.errors());
  });
}

AskedRequest asked_repair(const std::string& valve, const PlanOption& plan,
                          const std::optional<Service>& service) {
  AskedRequest asked;
  std::shared_ptr<const Valve> known;  // what a ring is sized for
  if (service) {
    const Expected<Json> sent = valve_to_send(valve);
    if (!sent) return {.failed = report_errors(valve, sent.errors())};
    asked = {0, {{"valve", *sent}}, {{"/valve", valve}}};
    if (!plan.ring.empty())
      if (Expected<Valve> read = read_valve_argument(valve))
        known = std::make_shared<const Valve>(*std::move(read));
  } else {
    Expected<Valve> read = read_any_valve_argument(valve);
    if (!read) return {.failed = report_errors(valve, read.errors())};
    known = std::make_shared<const Valve>(*std::move(read));
    asked = named_valve(valve, known);
  }
  if (!is_given(plan)) return asked;
  const Expected<RepairPlan> repair = read_plan_option(plan, known.get());
  if (!repair) return {.failed = report_errors(source_of(plan), repair.errors())};
  asked.request["plan"] = to_json(*repair);
  asked.sources["/plan"] = source_of(plan);
  return asked;
}

Expected<Json> file_to_send(const std::string& path) {
  Expected<std::string> bytes = read_input(path);
  if (!bytes) return bytes.errors();
  return to_json(NamedFile{path, *std::move(bytes)});
}

Expected<OperationAnswer> ask(const std::optional<Service>& service, const char* operation,
                              const Json& request, Context& here) {
  const Operation asked = operation_named(operation);
  if (!service) {
    const Expected<OperationTask> task = asked.read(request, here);
    return task ? task->run(here) : task.errors();
  }
  if (asked.needs_store) {
    Expected<Json> result = ask_document(service, operation, request, here);
    if (!result) return result.errors();
    return OperationAnswer(*std::move(result));
  }
  Expected<ServiceAnswer> answer = post(*service, asked.path, request);
  if (!answer) return answer.errors();
  return OperationAnswer(AnswerFile{std::move(answer->type), std::move(answer->bytes),
                                    answer->is_saved ? "answer" : ""});
}

Expected<Json> ask_document(const std::optional<Service>& service, const char* operation,
                            const Json& request, Context& here) {
  if (service) {
    const Operation asked = operation_named(operation);
    if (!asked.needs_store) return post_json(*service, asked.path, request);
    const Expected<ServiceJob> job = run_job(*service, asked.path, request, catch_interrupts());
    if (!job) return job.errors();
    return get_json(*service, job->path + "/result");
  }
  Expected<OperationAnswer> answer = ask(service, operation, request, here);
  if (!answer) return answer.errors();
  return std::get<Json>(*std::move(answer));
}

int report_refusal(const std::string& command, const Errors& errors,
                   const std::map<std::string, std::string>& sources,
                   const std::map<std::string, std::string>& options) {
  int status = exit_code::kBadInput;
  for (Error error : errors) {
    const auto source = std::find_if(sources.rbegin(), sources.rend(), [&](const auto& part) {
      return error.path == part.first || error.path.starts_with(part.first + "/");
    });
    if (source != sources.rend()) {  // wrong input, whatever its reader calls it
      error.path.erase(0, source->first.size());
      report_errors(source->second, {error});
      continue;
    }
    report_option_errors(command, {error}, options);
    if (error.code == ErrorCode::InputOutput || error.code == ErrorCode::Busy ||
        error.code == ErrorCode::NoSpace)
      status = exit_code::kFailure;
  }
  return status;
}

}  // namespace coapt
