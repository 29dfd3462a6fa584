#pragma once

#include <atomic>

namespace coapt {

/// From this call on the first Ctrl-C (SIGINT) or SIGTERM only sets the returned flag; a second one
/// ends the program.
const std::atomic<bool>& catch_interrupts();

/// SIGINT or SIGTERM, whichever set the flag; 0 before.
int caught_signal();

}  // namespace coapt
