// A program as a child: bytes in, bytes out, lines of its standard error as they come.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct ChildCall {
  std::string program;  ///< a path, or a name that is looked for in PATH
  std::vector<std::string> arguments;
  /// In addition to this program's, or in their place: other accounts cannot read them, as they can arguments.
  std::vector<std::pair<std::string, std::string>> environment;
  std::string_view input;
  std::function<void(std::string_view)> error_line;
  /// When it becomes true the child gets SIGTERM, some seconds later SIGKILL. May be null.
  const std::atomic<bool>* stop = nullptr;
};

struct ChildEnd {
  int status = 0;  ///< its exit code; 128 and the signal's number if a signal ended it
  std::string output;
};

/// Ends when the child has ended. However much goes in and comes out, neither waits for the other. From any thread; the
/// signals that this thread blocks or the program ignores are the child's own again. Errors: it cannot be started.
Expected<ChildEnd> run_child(const ChildCall& call);

}  // namespace coapt
