// What coapt does on request: one operation, whoever asks for it.
//
// An operation reads a request, a JSON object, and answers with a document or a file. It knows no HTTP, no queue, no options of a
// command line and no threads but the search's; who carries its requests does (doors): the command line, the service, Python, the
// page's engine in a browser.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/json/json.h"
#include "operations/context.h"

namespace coapt {

/// Bytes of some other kind than JSON.
struct AnswerFile {
  std::string type;  ///< "image/png"
  std::string bytes;
  std::string name = {};  ///< to be saved under; empty: to be shown
  std::string closure =
      {};  ///< whether what is shown of a closure counts: "converged", "crossing", ...
};
using OperationAnswer = std::variant<Json, AnswerFile>;

/// A request that was read, and what it will cost.
struct OperationTask {
  Index vertices = 0;  ///< of its valve; 0: none
  std::ptrdiff_t closures =
      1;  ///< that it makes, roughly, or what takes as long; 0: nothing that is worth a turn
  std::function<Expected<OperationAnswer>(Context& context)> run;
  double seconds = 0.0;  ///< of a core that it takes beside its closures, roughly
  /// Reads the files of the request, which `run` does where this was not called. Returns `vertices`, which may depend on them. Empty:
  /// there are none.
  std::function<Expected<Index>(Context& context)> read_files = {};
};

/// Who carries requests for an operation.
namespace door {
inline constexpr unsigned kCommandLine = 1, kService = 2, kPython = 4, kBrowser = 8, kFarm = 16;
inline constexpr unsigned kEverywhere = kCommandLine | kService | kPython | kBrowser;
}  // namespace door

struct Operation {
  const char* name;     ///< "close"
  const char* command;  ///< of coapt: "close", "study physiology"
  const char* path;     ///< POST, of the service and the browser's engine; empty: neither has it
  const char* what;     ///< what it does, in a sentence
  unsigned doors = 0;
  /// Errors: every problem of the request, with pointers into it. Null: a door of its own reads and runs it.
  Expected<OperationTask> (*read)(const Json& request, const Context& context) = nullptr;
  bool needs_store = false;  ///< of what outlives a request: jobs, closures
  bool as_job =
      false;  ///< a service runs `read`'s task as a job of this name; it answers a document
};

/// "command_line", "service", ...
std::vector<std::string> door_names(unsigned doors);

/// Null if there is none. @param path "/v1/closures"
const Operation* operation_at(std::span<const Operation> among, std::string_view path);

}  // namespace coapt
