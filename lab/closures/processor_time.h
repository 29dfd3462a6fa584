// Processor time of the calling thread: other programs on the machine do not count in it.
#pragma once

#include <time.h>

namespace coapt {

inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace coapt
