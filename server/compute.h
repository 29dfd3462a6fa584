// Turns for what costs much at once, closures or memory: as many at a time as there are cores, so that each is as fast
// as alone. What takes long never has all of them: somebody's small closure waits for none of another's large ones.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

namespace coapt {

/// How long a turn is expected to take.
enum class TurnCost {
  Short,  ///< a second or less: a closure of some 1,000 vertices
  Long    ///< up to what a request may take (ServiceLimits::request_seconds)
};

class Compute {
 public:
  /// @param patience for a turn; longer than an answer may take. @param longest that a long turn takes
  explicit Compute(int turns = static_cast<int>(std::thread::hardware_concurrency()),
                   std::chrono::milliseconds patience = std::chrono::seconds(20),
                   std::chrono::milliseconds longest = std::chrono::seconds(10))
      : free_(std::max(1, turns)),
        most_long_(std::max(1, free_ - 1)),
        most_waiting_long_(static_cast<std::size_t>(most_long_ * (patience / longest))),
        patience_(patience),
        overdue_(patience / 4) {}

  /// Waits for its turn, which ends with it; false if it has none: the others took too long, or, at once, so many long ones wait
  /// already that it could not begin in time. Short ones go first, until a long one has waited for a quarter of the patience.
  class Turn {
   public:
    explicit Turn(Compute& compute, TurnCost cost = TurnCost::Short)
        : compute_(compute), cost_(cost) {
      std::unique_lock<std::mutex> lock(compute_.mutex_);
      std::list<Waiting>& queue = compute_.queue(cost_);
      if (cost_ == TurnCost::Long && !compute_.may_go_at_once(cost_) &&
          queue.size() >= compute_.most_waiting_long_)
        return;
      const auto place = queue.insert(queue.end(), {std::chrono::steady_clock::now()});
      is_mine_ = compute_.changed_.wait_for(lock, compute_.patience_,
                                            [&] { return compute_.next(cost_) == &*place; });
      queue.erase(place);
      if (is_mine_) {
        --compute_.free_;
        if (cost_ == TurnCost::Long) ++compute_.long_;
      }
      compute_.changed_.notify_all();  // the next may be free to go, too
    }
    ~Turn() {
      if (!is_mine_) return;
      const std::lock_guard<std::mutex> lock(compute_.mutex_);
      ++compute_.free_;
      if (cost_ == TurnCost::Long) --compute_.long_;
      compute_.changed_.notify_all();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    explicit operator bool() const { return is_mine_; }

   private:
    Compute& compute_;
    TurnCost cost_;
    bool is_mine_ = false;
  };

 private:
  struct Waiting {
    std::chrono::steady_clock::time_point since;
  };

  std::list<Waiting>& queue(TurnCost cost) { return cost == TurnCost::Short ? short_ : longs_; }

  /// Of those who wait for turns of this cost the one whose turn it is; null if it is nobody's.
  const Waiting* next(TurnCost cost) {
    if (free_ == 0) return nullptr;
    const bool is_long_free = !longs_.empty() && long_ < most_long_;
    const bool is_overdue =
        is_long_free && std::chrono::steady_clock::now() - longs_.front().since > overdue_;
    if (cost == TurnCost::Long)
      return is_long_free && (short_.empty() || is_overdue) ? &longs_.front() : nullptr;
    return short_.empty() || is_overdue ? nullptr : &short_.front();
  }

  bool may_go_at_once(TurnCost cost) const {
    return free_ > 0 && short_.empty() && longs_.empty() &&
           (cost == TurnCost::Short || long_ < most_long_);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Waiting> short_, longs_;  // in the order in which they came
  int free_, long_ = 0;               // turns that nobody has; those of long ones
  const int most_long_;
  const std::size_t most_waiting_long_;
  const std::chrono::milliseconds patience_, overdue_;
};

}  // namespace coapt
