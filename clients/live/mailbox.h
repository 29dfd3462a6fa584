// The latest value from one thread for another one; neither ever waits (three slots, of which one is always free).
#pragma once

#include <array>
#include <atomic>

namespace coapt {

template <class T>
class Mailbox {
 public:
  /// By the one thread that writes.
  void put(const T& value) {
    slots_[written_] = value;
    written_ = middle_.exchange(written_ | kFresh, std::memory_order_acq_rel) & kSlot;
  }

  /// By the one thread that reads; T{} until something was put.
  const T& latest() {
    if (middle_.load(std::memory_order_relaxed) & kFresh)
      read_ = middle_.exchange(read_, std::memory_order_acq_rel) & kSlot;
    return slots_[read_];
  }

 private:
  static constexpr unsigned kSlot = 3, kFresh = 4;
  std::array<T, 3> slots_{};
  std::atomic<unsigned> middle_ = 1;
  unsigned written_ = 0, read_ = 2;
};

}  // namespace coapt
