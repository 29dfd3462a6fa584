// Turns for closures that are answered at once: as many at a time as there are cores, so that each is as fast as
// alone, and their memory is bounded.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace coapt {

class Compute {
 public:
  explicit Compute(int turns = static_cast<int>(std::thread::hardware_concurrency()))
      : free_(std::max(1, turns)) {}

  class Turn {
   public:
    explicit Turn(Compute& compute) : compute_(compute) {
      std::unique_lock<std::mutex> lock(compute_.mutex_);
      compute_.changed_.wait(lock, [this] { return compute_.free_ > 0; });
      --compute_.free_;
    }
    ~Turn() {
      const std::lock_guard<std::mutex> lock(compute_.mutex_);
      ++compute_.free_;
      compute_.changed_.notify_one();
    }
    Turn(const Turn&) = delete;

   private:
    Compute& compute_;
  };

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
};

}  // namespace coapt
