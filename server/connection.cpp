#include "server/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace coapt {
namespace {

constexpr std::size_t kReadBytes = 64 << 10;

bool nothing_ready() { return errno == EAGAIN || errno == EWOULDBLOCK; }

}  // namespace

Clock::time_point after(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Connection::Connection(Descriptor socket, std::string received, int given_up)
    : socket_(std::move(socket)), received_(std::move(received)), given_up_(given_up) {}

void Connection::start_reading(const Pace& pace) {
  pace_ = pace;
  started_ = Clock::now();
  wire_bytes_ = received_.size() - taken_;
}

Connection::Wait Connection::wait(short events, Clock::time_point deadline) const {
  std::array<pollfd, 2> polled = {pollfd{socket_.number(), events, 0},
                                  pollfd{given_up_, POLLIN, 0}};
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Wait::TimedOut;
    const int ready =
        poll(polled.data(), polled.size(), static_cast<int>(std::min<long>(left, 1000)));
    if (ready < 0 && errno != EINTR) return Wait::GivenUp;
    if (ready > 0) return polled[1].revents != 0 ? Wait::GivenUp : Wait::Ready;
  }
}

bool Connection::fill() {
  taken_ = 0;
  while (true) {
    received_.resize(kReadBytes);
    const ssize_t got = recv(socket_.number(), received_.data(), received_.size(), MSG_DONTWAIT);
    received_.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    if (got == 0 || (got < 0 && !nothing_ready() && errno != EINTR)) {
      end_ = ReadEnd::ClientEnded;
      return false;
    }
    // A client that is too slow may always have a byte ready: the clock is asked each time.
    double seconds = pace_.seconds;
    if (pace_.bytes_per_second > 0.0) {
      const double earned = static_cast<double>(wire_bytes_) / pace_.bytes_per_second;
      seconds = std::min(seconds, pace_.grace_seconds + earned);
    }
    const Clock::time_point deadline = started_ + std::chrono::duration_cast<Clock::duration>(
                                                      std::chrono::duration<double>(seconds));
    if (got > 0) {
      wire_bytes_ += static_cast<std::size_t>(got);
      if (wire_bytes_ > pace_.most_bytes) end_ = ReadEnd::TooMuch;
      if (Clock::now() > deadline) end_ = ReadEnd::TooSlow;
      return end_ == ReadEnd::None;
    }
    const Wait waited = wait(POLLIN, deadline);
    if (waited == Wait::Ready) continue;
    end_ = waited == Wait::TimedOut ? ReadEnd::TooSlow : ReadEnd::GivenUp;
    return false;
  }
}

std::size_t Connection::read(char* to, std::size_t size) {
  if (end_ != ReadEnd::None) return 0;
  if (taken_ == received_.size() && !fill()) return 0;
  const std::size_t count = std::min(size, received_.size() - taken_);
  std::memcpy(to, received_.data() + taken_, count);
  taken_ += count;
  return count;
}

bool Connection::send(std::string_view bytes, double seconds) {
  const Clock::time_point deadline = after(seconds);
  while (!bytes.empty()) {
    const ssize_t sent =
        ::send(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (sent < 0 && errno != EINTR) {
      if (!nothing_ready() || wait(POLLOUT, deadline) != Wait::Ready) return false;
    }
  }
  return true;
}

bool Connection::client_gone() const {
  pollfd polled = {socket_.number(), POLLRDHUP, 0};
  return poll(&polled, 1, 0) > 0 && polled.revents != 0;
}

}  // namespace coapt
