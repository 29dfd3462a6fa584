// A thread that wakes once a period.
#pragma once

#include <time.h>

#include <string>
#include <vector>

namespace coapt {

struct RealTime {
  bool priority =
      false;  ///< the calling thread goes before all that are not real-time (SCHED_FIFO)
  bool memory_locked = false;        ///< no page that there is now goes to disk
  std::vector<std::string> refused;  ///< why not, for people
};

/// Asks for both, for the calling thread.
RealTime ask_for_real_time();

/// Deadlines of CLOCK_MONOTONIC, one a period, none of which waits for another: a late period does not shift the next.
class Metronome {
 public:
  explicit Metronome(double rate_hz);

  /// Sleeps to the next deadline. Those that have passed are left out and counted. @return how late it woke, us.
  double wait();

  double time_ms() const;  ///< since it was made
  long missed() const { return missed_; }

 private:
  long long period_ns_ = 0, start_ns_ = 0, next_ns_ = 0;
  long missed_ = 0;
};

}  // namespace coapt
