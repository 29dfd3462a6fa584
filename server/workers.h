// A fixed number of threads that answer requests, and the queue before them.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace coapt {

/// Those with a body may take long to arrive and to answer: they get half of the threads at most, so
/// that the others always get through.
class Workers {
 public:
  explicit Workers(int threads);  ///< throws std::system_error if there cannot be so many
  ~Workers();                     ///< when the queue is empty

  /// First come, first served among those that may run. `work` must not throw.
  void add(bool with_body, std::function<void()> work);

  int busy() const;

 private:
  struct Waiting {
    long number = 0;
    std::function<void()> work;
  };
  void end();
  void serve();
  std::deque<Waiting>* next_queue();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Waiting> plain_, with_body_;
  long added_ = 0;
  int busy_ = 0, busy_with_body_ = 0, most_with_body_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace coapt
