// Locks, teams of threads and exceptions that are held back. The module for browsers has one thread and no exceptions, but there may
// be other workers that run the same program on the same input.
#pragma once

#if defined(__wasm__)
// Of whoever runs the module (clients/web/src/engine/team.ts): the calls of a loop, handed out to its workers.
extern "C" {
/// 0: this worker makes all of them, and asks for none.
[[clang::import_module("coapt"), clang::import_name("loop_begin")]] int coapt_loop_begin(int count);
/// An index that nobody has begun; -1 after the last, when all have ended.
[[clang::import_module("coapt"), clang::import_name("loop_take")]] int coapt_loop_take();
[[clang::import_module("coapt"), clang::import_name("loop_end")]] void coapt_loop_end();
}

namespace coapt {

struct Mutex {
  void lock() {}
  void unlock() {}
};
class [[nodiscard]] Lock {
 public:
  explicit Lock(Mutex& /*mutex*/) {}
  ~Lock() {}
};
inline int all_cores() { return 1; }

/// What a call threw, until it may be thrown on: nothing throws here.
class Thrown {
 public:
  template <class Function>
  bool returns(const Function& function) {
    function();
    return true;
  }
  void rethrow() const {}
};

}  // namespace coapt
#else
#include <omp.h>

#include <exception>
#include <mutex>

namespace coapt {

using Mutex = std::mutex;
using Lock = std::lock_guard<std::mutex>;
inline int all_cores() { return omp_get_max_threads(); }

/// What a call threw, until it may be thrown on.
class Thrown {
 public:
  /// Whether function() returned; what it throws is held.
  template <class Function>
  bool returns(const Function& function) {
    try {
      function();
    } catch (...) {
      held_ = std::current_exception();
    }
    return !held_;
  }
  void rethrow() const {
    if (held_) std::rethrow_exception(held_);
  }

 private:
  std::exception_ptr held_;
};

}  // namespace coapt
#endif
