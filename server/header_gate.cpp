#include "server/header_gate.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <thread>

#include "server/answer.h"
#include "server/header_block.h"

namespace coapt {
namespace {

constexpr std::uint64_t kListening = 0, kWake = 1, kFirst = 2;
constexpr int kTickMilliseconds = 50;  // how late a deadline may be noticed
constexpr int kAcceptedAtOnce = 64;

int checked(int descriptor) {
  if (descriptor < 0) throw std::system_error(errno, std::generic_category());
  return descriptor;
}

void signal(const Descriptor& event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(event.number(), &one, sizeof(one));
}

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

HeaderGate::HeaderGate(const GateLimits& limits, std::function<void(Arrival)> admit,
                       std::function<void(int)> refused)
    : limits_(limits),
      admit_(std::move(admit)),
      refused_(std::move(refused)),
      epoll_(checked(epoll_create1(EPOLL_CLOEXEC))),
      wake_(checked(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))),
      given_up_(checked(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))),
      last_(kFirst) {
  epoll_event event = {EPOLLIN, {}};
  event.data.u64 = kWake;
  checked(epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, wake_.number(), &event));
}

void HeaderGate::stop() {
  stopping_ = true;
  signal(wake_);
}

void HeaderGate::give_back(Descriptor socket, std::string answer) {
  const std::lock_guard lock(mutex_);
  given_back_.emplace_back(std::move(socket), std::move(answer));
  signal(wake_);
}

bool HeaderGate::run(Descriptor listening) {
  listening_ = std::move(listening);
  fcntl(listening_.number(), F_SETFL, O_NONBLOCK);
  epoll_event listen_event = {EPOLLIN, {}};
  listen_event.data.u64 = kListening;
  bool accepting =
      epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, listening_.number(), &listen_event) == 0;
  bool failed = !accepting;
  Clock::time_point next_tick = Clock::now();
  std::array<epoll_event, 64> events;
  while (true) {
    if ((stopping_ || failed) && accepting) {
      begin_stop();
      accepting = false;
    }
    if (!accepting && held_.empty() && admitted_ == 0) return !failed;
    const bool idle = held_.empty() && give_up_at_ == Clock::time_point::max();
    const int count = epoll_wait(epoll_.number(), events.data(), static_cast<int>(events.size()),
                                 idle ? -1 : kTickMilliseconds);
    for (int i = 0; i < count; ++i) {
      const std::uint64_t id = events[static_cast<std::size_t>(i)].data.u64;
      if (id == kWake) {
        take_back();
      } else if (id == kListening) {
        if (accepting && !accept_some()) failed = true;
      } else if (const Place place = held_.find(id); place != held_.end()) {
        // Not there any more if an event before this one has made room.
        if (place->second.state == State::Header) {
          receive(place);
        } else if (place->second.state == State::Answer) {
          send(place);
        } else {
          linger(place);
        }
      }
    }
    if (Clock::now() >= next_tick) {
      expire();
      next_tick = Clock::now() + std::chrono::milliseconds(kTickMilliseconds);
    }
    connections_ = static_cast<int>(held_.size()) + admitted_;
  }
}

void HeaderGate::begin_stop() {
  listening_ = Descriptor();
  stopping_ = true;
  close_all(State::Header);
  give_up_at_ = after(limits_.stop_seconds);
}

bool HeaderGate::accept_some() {
  for (int i = 0; i < kAcceptedAtOnce; ++i) {
    Descriptor socket(accept4(listening_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.number() < 0) {
      if (errno == EBADF || errno == EINVAL || errno == ENOTSOCK) return false;
      if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        make_room();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return true;
    }
    const int yes = 1;
    setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
    const bool room =
        static_cast<int>(held_.size()) + admitted_ < limits_.connections || make_room();
    const Place place =
        held_
            .emplace(++last_, Held{std::move(socket), State::Header, after(limits_.header_seconds)})
            .first;
    listen_to(place, EPOLLIN, EPOLL_CTL_ADD);
    if (!room) refuse(place, 503, "too many connections");
  }
  return true;
}

// Those that linger have their answer: they go first. What is refused lingers, and goes with the next.
bool HeaderGate::make_room() {
  const auto first = [&](State state) {
    return std::find_if(held_.begin(), held_.end(),
                        [&](const auto& held) { return held.second.state == state; });
  };
  if (const Place place = first(State::Linger); place != held_.end()) {
    close(place);
    return true;
  }
  const Place place = first(State::Header);
  if (place == held_.end()) return false;
  refuse(place, 503, "too many connections, and the header has not arrived");
  return true;
}

void HeaderGate::receive(Place place) {
  Held& held = place->second;
  const std::size_t size = held.bytes.size();
  held.bytes.resize(limits_.header_bytes);
  const ssize_t got =
      recv(held.socket.number(), held.bytes.data() + size, held.bytes.size() - size, MSG_DONTWAIT);
  held.bytes.resize(size + (got > 0 ? static_cast<std::size_t>(got) : 0));
  if (got < 0 && would_block()) return;
  if (got < 0 || (got == 0 && held.bytes.empty())) return close(place);
  if (got == 0) return refuse(place, 400, "the header ends too early");
  const auto header_bytes = header_length(held.bytes, held.done);
  held.done = held.bytes.size();
  if (header_bytes) {
    Arrival arrival{std::move(held.socket), std::move(held.bytes), *header_bytes, Clock::now()};
    epoll_ctl(epoll_.number(), EPOLL_CTL_DEL, arrival.socket.number(), nullptr);
    held_.erase(place);
    ++admitted_;
    admit_(std::move(arrival));
  } else if (held.bytes.size() == limits_.header_bytes) {
    refuse(place, 431, "the header is too large");
  }
}

void HeaderGate::refuse(Place place, int status, const char* why) {
  refused_(status);
  answer(place, as_http(problem(status, ErrorCode::OutOfRange, why)));
}

void HeaderGate::answer(Place place, std::string bytes) {
  Held& held = place->second;
  held.state = State::Answer;
  held.deadline = after(limits_.answer_seconds);
  held.bytes = std::move(bytes);
  held.done = 0;
  listen_to(place, EPOLLOUT, EPOLL_CTL_MOD);
  send(place);
}

void HeaderGate::send(Place place) {
  Held& held = place->second;
  while (held.done < held.bytes.size()) {
    const ssize_t sent = ::send(held.socket.number(), held.bytes.data() + held.done,
                                held.bytes.size() - held.done, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && would_block()) return;
    if (sent < 0) return close(place);
    held.done += static_cast<std::size_t>(sent);
  }
  shutdown(held.socket.number(), SHUT_WR);
  held.state = State::Linger;
  held.deadline = after(limits_.linger_seconds);
  held.bytes = std::string();
  held.done = 0;
  listen_to(place, EPOLLIN, EPOLL_CTL_MOD);
}

// Reads a part each time, so that a client that sends much does not hold up the others.
void HeaderGate::linger(Place place) {
  Held& held = place->second;
  std::array<char, 64 << 10> dropped;
  const ssize_t got = recv(held.socket.number(), dropped.data(), dropped.size(), MSG_DONTWAIT);
  if (got < 0 && would_block()) return;
  if (got > 0) held.done += static_cast<std::size_t>(got);
  if (got <= 0 || held.done > limits_.linger_bytes) close(place);
}

void HeaderGate::close(Place place) { held_.erase(place); }

void HeaderGate::close_all(State state) {
  std::erase_if(held_, [&](const auto& held) { return held.second.state == state; });
}

void HeaderGate::limit_answers() {
  std::size_t bytes = 0;
  for (const auto& [id, held] : held_) bytes += held.state == State::Answer ? held.bytes.size() : 0;
  for (auto place = held_.begin(); place != held_.end() && bytes > limits_.answer_bytes;) {
    const auto next = std::next(place);
    if (place->second.state == State::Answer) {
      bytes -= place->second.bytes.size();
      close(place);
    }
    place = next;
  }
}

void HeaderGate::expire() {
  const Clock::time_point now = Clock::now();
  if (now >= give_up_at_) {
    signal(given_up_);
    held_.clear();
  }
  for (auto place = held_.begin(); place != held_.end();) {
    const auto next = std::next(place);
    if (now >= place->second.deadline) {
      if (place->second.state == State::Header) {
        refuse(place, 408, "the header did not arrive in time");
      } else {
        close(place);
      }
    }
    place = next;
  }
}

void HeaderGate::take_back() {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t got = read(wake_.number(), &count, sizeof(count));
  std::vector<std::pair<Descriptor, std::string>> given_back;
  {
    const std::lock_guard lock(mutex_);
    given_back.swap(given_back_);
  }
  for (auto& [socket, bytes] : given_back) {
    --admitted_;
    const Place place = held_.emplace(++last_, Held{std::move(socket), State::Answer, {}}).first;
    listen_to(place, EPOLLOUT, EPOLL_CTL_ADD);
    answer(place, std::move(bytes));
  }
  limit_answers();
}

void HeaderGate::listen_to(Place place, std::uint32_t events, int operation) {
  epoll_event event = {events, {}};
  event.data.u64 = place->first;
  epoll_ctl(epoll_.number(), operation, place->second.socket.number(), &event);
}

}  // namespace coapt
