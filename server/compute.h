// Turns for what costs much at once, closures or memory: as many at a time as there are cores, so that each is as fast
// as alone.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace coapt {

class Compute {
 public:
  /// @param patience for a turn; longer than an answer may take (ServiceLimits::request_seconds)
  explicit Compute(int turns = static_cast<int>(std::thread::hardware_concurrency()),
                   std::chrono::milliseconds patience = std::chrono::seconds(20))
      : free_(std::max(1, turns)), patience_(patience) {}

  /// Waits for its turn, which ends with it; false if it has none, because the others took too long.
  class Turn {
   public:
    explicit Turn(Compute& compute) : compute_(compute) {
      std::unique_lock<std::mutex> lock(compute_.mutex_);
      is_mine_ = compute_.changed_.wait_for(lock, compute_.patience_,
                                            [this] { return compute_.free_ > 0; });
      if (is_mine_) --compute_.free_;
    }
    ~Turn() {
      if (!is_mine_) return;
      const std::lock_guard<std::mutex> lock(compute_.mutex_);
      ++compute_.free_;
      compute_.changed_.notify_one();
    }
    Turn(const Turn&) = delete;
    explicit operator bool() const { return is_mine_; }

   private:
    Compute& compute_;
    bool is_mine_ = false;
  };

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
  const std::chrono::milliseconds patience_;
};

}  // namespace coapt
