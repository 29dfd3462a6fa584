#include "server/reader_processes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <new>
#include <optional>
#include <utility>

#include "search/parallel.h"
#include "server/sandbox.h"

namespace coapt {
namespace {

using End = ReaderProcesses::End;
using Order = ReaderProcesses::Order;

constexpr int kPause_ms = 20;
// The first byte of what comes back. Behind kAnswered: the answer's size in bytes, by which it is known to be whole, and the answer.
constexpr char kAnswered = 'a', kOutOfMemory = 'm', kOutOfTime = 't';
constexpr std::size_t kHead = 1 + sizeof(std::uint64_t);

/// The two ends that a process gets: of the question and its answer, and of the leash.
using Ends = std::array<int, 2>;

// ---- The process that answers, and the template that it is a copy of

int answer_to = -1;  // for those who can be told nothing: handlers

void end_out_of_memory() {
  static_cast<void>(!write(answer_to, &kOutOfMemory, 1));
  _exit(0);
}
extern "C" void end_out_of_time(int /*signal*/) {
  static_cast<void>(!write(answer_to, &kOutOfTime, 1));
  _exit(0);
}
extern "C" void wake(int /*signal*/) {}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Until whoever asks has said all: it shuts its half.
std::string read_all(int from) {
  std::string bytes;
  std::array<char, 1 << 16> part{};
  for (;;) {
    const ssize_t size = read(from, part.data(), part.size());
    if (size <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(size));
  }
}

/// Nobody holds its other end any more: the kernel's SIGKILL.
void end_with(int leash) {
  fcntl(leash, F_SETOWN, getpid());
  fcntl(leash, F_SETSIG, SIGKILL);
  fcntl(leash, F_SETFL, O_ASYNC);
  pollfd gone{leash, 0, 0};
  if (poll(&gone, 1, 0) > 0) _exit(0);  // it was let go before
}

/// In a new process OpenMP's library of clang++ opens files at the first loop; none can be opened later.
void prepare_openmp() {
  for_each_index(1, 1, [](int /*index*/) {});
}

/// Where memory is short this one goes before the server.
void be_first_to_go() {
  const int file = open("/proc/self/oom_score_adj", O_WRONLY);
  if (file < 0) return;
  write_all(file, "1000");
  close(file);
}

[[noreturn]] void answer(const Ends& ends, int control, const Order& order, std::size_t bytes,
                         const ReaderProcesses::Work& work) {
  answer_to = ends[0];
  end_with(ends[1]);
  be_first_to_go();
  for (const int open : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO, control}) close(open);
  static_cast<void>(!nice(order.nice));
  std::set_new_handler(end_out_of_memory);
  std::signal(SIGXCPU, end_out_of_time);
  const std::string question = read_all(answer_to);
  prepare_openmp();
  enter_sandbox({bytes, order.cpu_seconds});
  const std::string text = work(question);
  std::string head(kHead, kAnswered);
  const std::uint64_t size = text.size();
  std::memcpy(head.data() + 1, &size, sizeof size);
  if (write_all(answer_to, head)) write_all(answer_to, text);
  _exit(0);
}

/// Those that have ended; told is what should not have happened.
void reap() {
  int status = 0;
  while (waitpid(-1, &status, WNOHANG) > 0) {
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL)
      std::cerr << "coapt-server: a process that read a client's files ended by signal "
                << WTERMSIG(status) << '\n';
  }
}

/// None if a signal came first; -1 as descriptors once nobody can ask any more.
std::optional<Ends> next_ends(int control, Order& order) {
  iovec bytes{&order, sizeof order};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(Ends))> rights{};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = rights.data();
  message.msg_controllen = rights.size();
  const ssize_t size = recvmsg(control, &message, MSG_CMSG_CLOEXEC);
  if (size < 0 && errno == EINTR) return std::nullopt;
  Ends ends{-1, -1};
  const cmsghdr* const header = CMSG_FIRSTHDR(&message);
  if (size == sizeof order && header != nullptr && header->cmsg_type == SCM_RIGHTS)
    std::memcpy(ends.data(), CMSG_DATA(header), sizeof ends);
  return ends;
}

[[noreturn]] void serve_as_template(int control, std::size_t bytes,
                                    const ReaderProcesses::Work& work) {
  prctl(PR_SET_NAME, "coapt-reader");
  // The server ends it, not whoever ends the server: requests may still be answered.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  struct sigaction action {};
  action.sa_handler = wake;
  sigaction(SIGCHLD, &action, nullptr);
  for (;;) {
    reap();
    Order order;
    const std::optional<Ends> ends = next_ends(control, order);
    if (!ends) continue;
    if ((*ends)[0] < 0) _exit(0);
    if (fork() == 0) answer(*ends, control, order, bytes, work);
    for (const int end : *ends) close(end);
  }
}

/// Until nobody can ask any more, which ends the template by itself.
[[noreturn]] void keep_a_template(int control, std::size_t bytes,
                                  const ReaderProcesses::Work& work) {
  prctl(PR_SET_NAME, "coapt-keeper");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  for (;;) {
    const pid_t child = fork();
    if (child == 0) serve_as_template(control, bytes, work);
    int status = 0;
    if (child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status)) _exit(0);
    if (child > 0)
      std::cerr << "coapt-server: the process that forks readers of clients' files ended by signal "
                << WTERMSIG(status) << "; it is started again\n";
    usleep(1000 * kPause_ms);
  }
}

// ---- Whoever asks

/// Two ends that are joined; none where there are no more descriptors.
struct Joined {
  Descriptor mine, its;
};
std::optional<Joined> make_socket() {
  Ends ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return std::nullopt;
  return Joined{Descriptor(ends[0]), Descriptor(ends[1])};
}
std::optional<Joined> make_leash() {
  Ends ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Joined{Descriptor(ends[1]), Descriptor(ends[0])};
}

bool send_ends(int control, const Ends& ends, Order order) {
  iovec bytes{&order, sizeof order};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(Ends))> rights{};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = rights.data();
  message.msg_controllen = rights.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof ends);
  std::memcpy(CMSG_DATA(header), ends.data(), sizeof ends);
  return sendmsg(control, &message, MSG_NOSIGNAL) == sizeof order;
}

/// Of all that came. The last byte is a handler's, if one was called in the middle of an answer.
End end_of(std::string_view text) {
  if (text.size() >= kHead && text.front() == kAnswered) {
    std::uint64_t size = 0;
    std::memcpy(&size, text.data() + 1, sizeof size);
    if (text.size() - kHead == size) return End::Answered;
  }
  if (text.empty()) return End::Died;
  return text.back() == kOutOfMemory ? End::OutOfMemory
         : text.back() == kOutOfTime ? End::OutOfTime
                                     : End::Died;
}

}  // namespace

ReaderProcesses::ReaderProcesses(Work work, std::size_t bytes,
                                 const std::function<void()>& prepare) {
  Ends ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  control_ = Descriptor(ends[0]);
  keeper_ = fork();
  if (keeper_ == 0) {
    close(ends[0]);
    if (prepare) prepare();
    keep_a_template(ends[1], bytes, work);
  }
  close(ends[1]);
}

ReaderProcesses::~ReaderProcesses() {
  control_ = Descriptor();
  if (keeper_ > 0) waitpid(keeper_, nullptr, 0);
}

ReaderProcesses::Result ReaderProcesses::ask(std::string_view question, const Order& order,
                                             const std::function<bool()>& cancelled) const {
  std::optional<Joined> socket = make_socket(), leash = make_leash();
  if (!socket || !leash ||
      !send_ends(control_.number(), {socket->its.number(), leash->its.number()}, order))
    return {};
  socket->its = Descriptor();
  leash->its = Descriptor();
  const int mine = socket->mine.number();
  std::string text;
  std::array<char, 1 << 16> part{};
  bool is_asked = false;
  while (text.size() <= kHead + kMostAnswered) {
    // Whole: that the process ends, which takes its memory apart first, is not waited for.
    if (end_of(text) == End::Answered) return {End::Answered, text.substr(kHead)};
    if (cancelled && cancelled()) return {End::Cancelled, ""};
    if (!is_asked && question.empty()) is_asked = shutdown(mine, SHUT_WR) == 0;
    pollfd ready{mine, static_cast<short>(is_asked ? POLLIN : POLLIN | POLLOUT), 0};
    if (poll(&ready, 1, kPause_ms) <= 0) continue;
    if ((ready.revents & POLLOUT) != 0) {
      const ssize_t sent =
          send(mine, question.data(), question.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent > 0) question.remove_prefix(static_cast<std::size_t>(sent));
    }
    if ((ready.revents & (POLLIN | POLLHUP | POLLERR)) == 0) continue;
    const ssize_t size = recv(mine, part.data(), part.size(), MSG_DONTWAIT);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (size <= 0) return {end_of(text), ""};
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  return {};
}

}  // namespace coapt
