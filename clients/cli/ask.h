// An operation that a command asks for: run here, or by the service of --server. The same request, answered with the same document.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/plan_option.h"
#include "clients/cli/server_option.h"
#include "operations/operation.h"

namespace coapt {

/// When the command `name` runs: `run` with the service of its --server; or what is wrong with that option. @param option must live as long as
/// `run`. @param only_here as of service_of()
void on_run_by(Command command, const std::string& name, const ServerOption& option,
               const std::vector<std::string>& only_here, int& status,
               std::function<int(const std::optional<Service>&)> run);

/// A request, and what its parts came from, for report_refusal().
struct AskedRequest {
  int failed = 0;  ///< an exit code; what is wrong was said on standard error
  Json request{};
  std::map<std::string, std::string> sources{};  ///< by pointers into the request: files
  /// Of what is run here: knows the valve that the request names.
  Context here{.limits = OperationLimits::unlimited()};
};

/// Of a command's valve, mitral or not, and plan: "valve", and "plan" if there is one.
AskedRequest asked_repair(const std::string& valve, const PlanOption& plan,
                          const std::optional<Service>& service);

/// A file of the command line as it is sent: {"name", "base64"}. Errors: it cannot be read.
Expected<Json> file_to_send(const std::string& path);

/// @param operation its name. Errors: of the request, with pointers into it; InputOutput, Busy or NoSpace where the service failed.
Expected<OperationAnswer> ask(const std::optional<Service>& service, const char* operation,
                              const Json& request, Context& here);

/// The same for an operation that answers a document.
Expected<Json> ask_document(const std::optional<Service>& service, const char* operation,
                            const Json& request, Context& here);

/// Prints every error as report_errors() does: those below a pointer of `sources` (the longest) with that file, others as options of the
/// command ("/accuracy_mm2" as `options` says, else as "--accuracy-mm2"). Returns an exit code: kFailure for what is not the request's fault.
int report_refusal(const std::string& command, const Errors& errors,
                   const std::map<std::string, std::string>& sources,
                   const std::map<std::string, std::string>& options = {});

}  // namespace coapt
