// What strangers sent is read in processes of their own: one for each question, in a sandbox (sandbox.h), gone with its answer. A
// fault of a reader, or memory without end, is then one client's problem.
//
//   this process, keeper -- control --> template --> a process a question
//        |__________________ question, answer ____________|
//
// The keeper is forked before any thread, and forks the template again should the system end it. The template is small, so that a
// fork takes less than a millisecond. Whoever asks holds a leash: when it lets go, whatever the reason, kill -9 included, the kernel
// ends the process that answers.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "server/connection.h"

namespace coapt {

class ReaderProcesses {
 public:
  /// From a question to its answer, by itself: nothing that it changes is seen elsewhere.
  using Work = std::function<std::string(std::string_view)>;

  /// Forks the keeper. @pre there is no other thread yet, and nothing secret in memory. @param bytes of address space of a
  /// process. @param prepare what needs files, done once before the template is forked
  ReaderProcesses(Work work, std::size_t bytes, const std::function<void()>& prepare = {});
  ~ReaderProcesses();
  ReaderProcesses(const ReaderProcesses&) = delete;

  enum class End {
    Answered,
    Cancelled,
    OutOfMemory,
    OutOfTime,
    Died,  ///< a fault of the reader; which signal it was stands on standard error
  };
  struct Result {
    End end = End::Died;
    std::string answer;  ///< of at most kMostAnswered bytes
  };
  static constexpr std::size_t kMostAnswered = std::size_t{128} << 20;

  struct Order {
    int cpu_seconds = 10;
    int nice = 0;  ///< added to the server's
  };

  /// From many threads at once. @param cancelled asked every 20 ms
  Result ask(std::string_view question, const Order& order,
             const std::function<bool()>& cancelled) const;

 private:
  Descriptor control_;
  pid_t keeper_ = -1;
};

}  // namespace coapt
