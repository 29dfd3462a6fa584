// Whether the server before this one died of a fault of its own (SIGSEGV, SIGABRT and others), not of a kill or of a machine that
// went: a file that is written while it dies.
#pragma once

#include <string>

namespace coapt {

/// Whether there is such a file; it is removed.
bool take_crash_mark(const std::string& path);

/// From now on a fault of this process leaves the file, and then ends it as it would have. Once, before other threads.
void leave_crash_mark_at(const std::string& path);

}  // namespace coapt
