#include "clients/live/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace coapt {
namespace {

constexpr int kPriority = 50;  // below the kernel's own threads for interrupts
constexpr long long kNsPerS = 1'000'000'000;

long long now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return kNsPerS * now.tv_sec + now.tv_nsec;
}

}  // namespace

RealTime ask_for_real_time() {
  RealTime got;
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  got.priority = refused == 0;
  if (refused != 0)
    got.refused.push_back(std::string("no real-time priority (") + std::strerror(refused) + ")");
  // What is there now: memory that is asked for later would fail where little may be locked.
  got.memory_locked = mlockall(MCL_CURRENT) == 0;
  if (!got.memory_locked)
    got.refused.push_back(std::string("memory not locked (") + std::strerror(errno) + ")");
  return got;
}

Metronome::Metronome(double rate_hz)
    : period_ns_(static_cast<long long>(1e9 / rate_hz)), start_ns_(now_ns()), next_ns_(start_ns_) {}

double Metronome::wait() {
  next_ns_ += period_ns_;
  if (const long long late_ns = now_ns() - next_ns_; late_ns > period_ns_) {
    missed_ += static_cast<long>(late_ns / period_ns_);
    next_ns_ += late_ns / period_ns_ * period_ns_;
  }
  const timespec deadline{static_cast<time_t>(next_ns_ / kNsPerS),
                          static_cast<long>(next_ns_ % kNsPerS)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
  return 1e-3 * static_cast<double>(now_ns() - next_ns_);
}

double Metronome::time_ms() const { return 1e-6 * static_cast<double>(now_ns() - start_ns_); }

}  // namespace coapt
