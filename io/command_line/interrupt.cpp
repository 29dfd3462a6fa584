#include "io/command_line/interrupt.h"

#include <csignal>

namespace coapt {
namespace {

// A signal handler reaches nothing but a static object.
std::atomic<bool> interrupted = false;
std::atomic<int> interrupted_by = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int signal) {
  interrupted_by = signal;
  interrupted = true;
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return interrupted;
}

int caught_signal() { return interrupted_by; }

}  // namespace coapt
