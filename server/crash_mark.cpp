#include "server/crash_mark.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace coapt {
namespace {

constexpr int kFaults[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};
// Written before the handler is set and then only read, by a handler that may call nothing that allocates.
std::array<char, 4096> mark_path{};

extern "C" void leave_mark(int signal) {
  const int file = open(mark_path.data(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file >= 0) close(file);
  raise(signal);  // whose handler is the usual one again
}

}  // namespace

bool take_crash_mark(const std::string& path) { return unlink(path.c_str()) == 0; }

void leave_crash_mark_at(const std::string& path) {
  if (path.size() >= mark_path.size()) return;
  path.copy(mark_path.data(), path.size());
  struct sigaction action {};
  action.sa_handler = leave_mark;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int fault : kFaults) sigaction(fault, &action, nullptr);
}

}  // namespace coapt
