// Holds every connection that no thread works on, in one thread for all: until its header has come, until the
// client has taken the answer, until it has closed. So slow clients cost memory, but stop nobody.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "server/connection.h"

namespace coapt {

struct GateLimits {
  std::size_t header_bytes = 16 << 10;
  double header_seconds = 10.0;
  double answer_seconds = 60.0;  ///< for the client to take the answer
  std::size_t answer_bytes =
      256 << 20;  ///< of all answers that are not taken yet; then the longest waiting is dropped
  double linger_seconds =
      5.0;  ///< for the client to close; closing on unread bytes can lose the answer
  std::size_t linger_bytes = std::size_t{128} << 20;  ///< of a refused body, read and dropped
  int connections = 1024;     ///< at once, those that threads work on included
  double stop_seconds = 2.0;  ///< from stop() to giving up what clients hold up
};

/// A connection whose header has come.
struct Arrival {
  Descriptor socket;
  std::string bytes;             ///< the header and what came with it
  std::size_t header_bytes = 0;  ///< of them
  Clock::time_point since;       ///< its end
};

class HeaderGate {
 public:
  /// Both are called by the thread in run(). @param refused with the status that the gate itself has
  /// answered: 400, 408, 431, 503
  HeaderGate(const GateLimits& limits, std::function<void(Arrival)> admit,
             std::function<void(int)> refused);

  /// Serves until stop() and until every arrival has been given back. False if it cannot accept.
  bool run(Descriptor listening);
  void stop();  ///< from any thread, also before run()
  /// Takes an admitted connection again: sends what is left of the answer and closes. From any thread.
  void give_back(Descriptor socket, std::string answer);

  int given_up() const {
    return given_up_.number();
  }  ///< readable from stop_seconds after stop() on
  int connections() const { return connections_; }

 private:
  enum class State { Header, Answer, Linger };
  struct Held {
    Descriptor socket;
    State state = State::Header;
    Clock::time_point deadline;
    std::string bytes = {};  ///< received, or to be sent
    std::size_t done = 0;    ///< of them looked at, or sent; in Linger: dropped
  };
  using Place = std::map<std::uint64_t, Held>::iterator;  ///< in the order of coming

  bool accept_some();
  bool make_room();
  void receive(Place place);
  void refuse(Place place, int status, const char* why);
  void answer(Place place, std::string bytes);
  void send(Place place);
  void linger(Place place);
  void close(Place place);
  void close_all(State state);
  void limit_answers();
  void expire();
  void take_back();
  void begin_stop();
  void listen_to(Place place, std::uint32_t events, int operation);

  GateLimits limits_;
  std::function<void(Arrival)> admit_;
  std::function<void(int)> refused_;
  Descriptor epoll_, wake_, given_up_, listening_;
  std::map<std::uint64_t, Held> held_;
  std::uint64_t last_ = 0;
  int admitted_ = 0;
  std::atomic<int> connections_ = 0;
  std::atomic<bool> stopping_ = false;
  Clock::time_point give_up_at_ = Clock::time_point::max();
  std::mutex mutex_;
  std::vector<std::pair<Descriptor, std::string>> given_back_;
};

}  // namespace coapt
