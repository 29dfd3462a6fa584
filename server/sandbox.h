// A process that reads what strangers sent: from here on it computes, and answers through the descriptors that it has.
#pragma once

#include <cstddef>

namespace coapt {

struct SandboxLimits {
  std::size_t bytes = 0;  ///< of address space, the program's own included
  int cpu_seconds = 0;    ///< then SIGXCPU, a second later SIGKILL
};

/// No more descriptors of any kind, and where the kernel filters system calls none but those of memory, clocks, and of reading and
/// writing what is open: no files, no network, no processes, no signals to others. For good. Memory is not limited under the
/// address sanitizer, whose shadow takes all of it.
void enter_sandbox(const SandboxLimits& limits);

}  // namespace coapt
