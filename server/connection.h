// A client's socket while a request is read and a stream is sent: with deadlines, so that no client
// can hold a thread for ever.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace coapt {

using Clock = std::chrono::steady_clock;

/// `seconds` from now.
Clock::time_point after(double seconds);

/// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }  ///< -1: none

 private:
  int number_;
};

/// What a client must keep up with.
struct Pace {
  double seconds = 60.0;          ///< in all
  double bytes_per_second = 0.0;  ///< at least, in the mean, once the grace is over
  double grace_seconds = 2.0;
  std::size_t most_bytes = 0;  ///< on the wire
};

/// Why no more could be read.
enum class ReadEnd { None, ClientEnded, TooSlow, TooMuch, GivenUp };

class Connection {
 public:
  /// @param socket non-blocking. @param received what has been read from it.
  /// @param given_up readable once nothing is to be waited for any more; must outlive it
  Connection(Descriptor socket, std::string received, int given_up);

  /// Starts the clock of what is read from here on, `received` included.
  void start_reading(const Pace& pace);
  /// Waits for 1 to `size` bytes; 0 if there are no more: see read_end().
  std::size_t read(char* to, std::size_t size);
  ReadEnd read_end() const { return end_; }

  /// Waits until all is sent; false if the client does not take it in time or is gone.
  bool send(std::string_view bytes, double seconds);
  /// Has closed the connection, or its own half of it.
  bool client_gone() const;

  Descriptor release() { return std::move(socket_); }

 private:
  enum class Wait { Ready, TimedOut, GivenUp };
  Wait wait(short events, Clock::time_point deadline) const;
  bool fill();

  Descriptor socket_;
  std::string received_;
  std::size_t taken_ = 0;  ///< of received_
  int given_up_;
  Pace pace_;
  Clock::time_point started_;
  std::size_t wire_bytes_ = 0;
  ReadEnd end_ = ReadEnd::None;
};

}  // namespace coapt
