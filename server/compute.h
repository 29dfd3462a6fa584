// Turns for what costs much at once, closures or memory: as many at a time as there are cores, so that each is as fast
// as alone. What takes long never has all of them: somebody's small closure waits for none of another's large ones. Clients
// alternate: whoever asks a hundred times waits for the others, and not they for all of these.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "server/rounds.h"

namespace coapt {

struct TurnAsk {
  double seconds = 0.1;     ///< that it takes on a core of its own, roughly
  std::string client = {};  ///< whose it is: turns alternate between clients
  std::size_t request =
      0;  ///< what is asked for, as a hash of it; 0: nothing that is to be known again
};

class Compute {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLong_s = 0.5;       ///< what takes longer is a long one
  static constexpr double kNotAgain_s = 30.0;  ///< for what ran out of time

  /// @param patience for a turn @param longest that one takes: then its request ends
  Compute(int turns, std::chrono::milliseconds patience, std::chrono::milliseconds longest);
  /// As many turns as there are cores.
  explicit Compute(double longest_s = 10.0);

  enum class End {
    Running,
    Busy,  ///< none: the others took too long; or, at once: what was asked for before does not leave it the time
    TooLong  ///< none, at once: the same ran out of time a moment ago
  };

  /// Waits for its turn, which ends with it. Short ones go first, until a long one has waited for a quarter of the patience.
  class Turn {
   public:
    explicit Turn(Compute& compute, TurnAsk ask = {});
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    explicit operator bool() const { return end_ == End::Running; }
    End end() const { return end_; }
    int retry_after_s() const { return retry_after_s_; }  ///< where there was none; 1 or more

    /// It is done: from how long it took the turns learn how fast the machine is.
    void done();
    /// It ended because its time was over.
    void ran_out();

   private:
    Compute& compute_;
    const TurnAsk ask_;
    Clock::time_point since_;
    End end_ = End::Busy;
    int retry_after_s_ = 1;
  };

 private:
  struct Asked {
    const TurnAsk* ask;
    Clock::time_point since;  ///< that it waits, or has its turn
  };

  static bool is_long(const TurnAsk& ask) { return ask.seconds > kLong_s; }
  std::list<Asked>& queue(const TurnAsk& ask) { return is_long(ask) ? longs_ : shorts_; }
  const Asked* fair(const std::list<Asked>& queue) const;
  const Asked* next(bool of_long) const;
  double slowness() const;
  double expected_s(const TurnAsk& ask) const;
  double wait_s(const TurnAsk& ask);
  int running(bool of_long) const;
  double not_again_s(std::size_t request);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Asked> shorts_, longs_, running_;  // in the order in which they came
  Rounds rounds_;
  std::map<std::size_t, Clock::time_point> ran_out_;  // requests, and until when they are refused
  std::array<double, 9> slowness_;  // of those done last: seconds by those expected
  std::size_t done_ = 0;
  const int turns_, most_long_;
  const std::chrono::milliseconds patience_, longest_;
};

}  // namespace coapt
