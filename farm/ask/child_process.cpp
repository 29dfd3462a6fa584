#include "farm/ask/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>

extern char** environ;

namespace coapt {
namespace {

using ChildClock = std::chrono::steady_clock;
constexpr int kLook_ms = 100;  // for `stop`
constexpr std::chrono::seconds kUntilKilled(5);

/// A file descriptor, closed at the end.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }
  int get() const { return fd_; }
  bool open() const { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

struct ChildPipes {
  Descriptor input, output, errors;                    // ours
  Descriptor child_input, child_output, child_errors;  // the child's
};

/// All are closed in other children that are started meanwhile. The input is a socket, because writing to one can do without
/// SIGPIPE.
std::optional<ChildPipes> make_pipes() {
  ChildPipes pipes;
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) return std::nullopt;
  pipes.input = Descriptor(pair[0]);
  pipes.child_input = Descriptor(pair[1]);
  if (pipe2(pair.data(), O_CLOEXEC) != 0) return std::nullopt;
  pipes.output = Descriptor(pair[0]);
  pipes.child_output = Descriptor(pair[1]);
  if (pipe2(pair.data(), O_CLOEXEC) != 0) return std::nullopt;
  pipes.errors = Descriptor(pair[0]);
  pipes.child_errors = Descriptor(pair[1]);
  return pipes;
}

std::vector<std::string> environment_of(const ChildCall& call) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view known = *entry;
    bool replaced = false;
    for (const auto& [name, value] : call.environment) replaced |= known.starts_with(name + '=');
    if (!replaced) all.emplace_back(known);
  }
  for (const auto& [name, value] : call.environment) all.push_back(name + '=' + value);
  return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns an error's number.
int spawn(const ChildCall& call, const ChildPipes& pipes, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipes.child_input.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.child_output.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.child_errors.get(), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, own;
  sigemptyset(&none);
  sigemptyset(&own);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) sigaddset(&own, signal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &own);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::vector<std::string> arguments = {call.program};
  arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
  std::vector<std::string> environment = environment_of(call);
  const int failed = posix_spawnp(&child, call.program.c_str(), &actions, &attributes,
                                  pointers_to(arguments).data(), pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

/// Takes what is there; closes at the end.
void read_some(Descriptor& from, std::string& into) {
  std::array<char, 65536> block{};
  const ssize_t got = read(from.get(), block.data(), block.size());
  if (got > 0)
    into.append(block.data(), static_cast<std::size_t>(got));
  else if (got == 0 || errno != EINTR)
    from.close();
}

/// Closes when all is written, or the child does not want it.
void write_some(Descriptor& to, std::string_view& rest) {
  const ssize_t gone = send(to.get(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (gone >= 0)
    rest.remove_prefix(static_cast<std::size_t>(gone));
  else if (errno != EINTR && errno != EAGAIN)
    rest = {};
  if (rest.empty()) to.close();
}

/// The lines that are complete, taken away; at the end the last one, too.
void tell_lines(std::string& text, bool ended, const ChildCall& call) {
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    if (call.error_line) call.error_line(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  text.erase(0, begin);
  if (ended && !text.empty() && call.error_line) call.error_line(text);
}

/// Ends a child that is to stop: first by SIGTERM, then by SIGKILL.
class ChildStopper {
 public:
  ChildStopper(pid_t child, const std::atomic<bool>* stop) : child_(child), stop_(stop) {}
  void look() {
    if (stop_ == nullptr || !*stop_) return;
    if (!asked_) {
      kill(child_, SIGTERM);
      asked_ = true;
      asked_at_ = ChildClock::now();
    } else if (ChildClock::now() - asked_at_ > kUntilKilled) {
      kill(child_, SIGKILL);
    }
  }

 private:
  pid_t child_;
  const std::atomic<bool>* stop_;
  bool asked_ = false;
  ChildClock::time_point asked_at_{};
};

int wait_for(pid_t child, ChildStopper& stopper) {
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    stopper.look();
    poll(nullptr, 0, kLook_ms / 10);
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

Expected<ChildEnd> run_child(const ChildCall& call) {
  std::optional<ChildPipes> pipes = make_pipes();
  pid_t child = 0;
  const int failed = pipes ? spawn(call, *pipes, child) : errno;
  if (failed != 0)
    return Error{ErrorCode::InputOutput, "",
                 call.program + " cannot be started: " + std::strerror(failed)};
  for (Descriptor* end : {&pipes->child_input, &pipes->child_output, &pipes->child_errors})
    end->close();
  ChildStopper stopper(child, call.stop);
  std::string_view rest = call.input;
  if (rest.empty()) pipes->input.close();
  std::string output, lines;
  while (pipes->output.open() || pipes->errors.open()) {
    // A negative descriptor is passed over.
    std::array<pollfd, 3> ready = {{{pipes->output.get(), POLLIN, 0},
                                    {pipes->errors.get(), POLLIN, 0},
                                    {pipes->input.get(), POLLOUT, 0}}};
    poll(ready.data(), ready.size(), kLook_ms);
    stopper.look();
    if (ready[0].revents != 0) read_some(pipes->output, output);
    if (ready[1].revents != 0) {
      read_some(pipes->errors, lines);
      tell_lines(lines, !pipes->errors.open(), call);
    }
    if (ready[2].revents != 0) write_some(pipes->input, rest);
  }
  pipes->input.close();
  return ChildEnd{wait_for(child, stopper), std::move(output)};
}

}  // namespace coapt
