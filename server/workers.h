// A fixed number of threads that answer requests, and the queue before them.
#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/rounds.h"

namespace coapt {

/// Those with a body may take long to arrive and to answer: they get half of the threads at most, so
/// that the others always get through; those of one client get seven eighths of that half. Clients alternate.
class Workers {
 public:
  explicit Workers(int threads);  ///< throws std::system_error if there cannot be so many
  ~Workers();                     ///< when the queue is empty

  /// @param client whose it is @param work must not throw
  void add(bool with_body, const std::string& client, std::function<void()> work);

  int busy() const;

  /// Requests with a body of one client that so many threads answer at once.
  static int most_of_one_client(int threads);

 private:
  struct Waiting {
    bool with_body;
    std::string client;
    std::function<void()> work;
  };
  using Place = std::list<Waiting>::iterator;
  void end();
  void serve();
  Place next();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Waiting> waiting_;         ///< in the order of coming
  std::map<std::string, int> bodies_;  ///< that threads work on, by client
  Rounds rounds_;
  int busy_ = 0, busy_with_body_ = 0;
  const int most_with_body_, most_of_one_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace coapt
