// What a reader may do to the service: nothing.
#include "server/reader_processes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace coapt {
namespace {

using End = ReaderProcesses::End;

constexpr std::size_t kBytes = std::size_t{1} << 29;

volatile int* nowhere = nullptr;
const pid_t server = getpid();

/// What a reader that was taken over may try, a word each; those that it could do.
std::string could() {
  std::string done;
  const auto tried = [&done](const char* what, bool did) {
    if (did) done += std::string(what) + ' ';
  };
  tried("read files", open("/etc/passwd", O_RDONLY) >= 0);
  tried("write files", open("/tmp/coapt-reader", O_WRONLY | O_CREAT, 0600) >= 0);
  tried("connect", socket(AF_INET, SOCK_STREAM, 0) >= 0);
  tried("ask the system's services", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
  tried("fork", fork() >= 0);
  tried("signal the server", kill(server, 0) == 0);
  tried("trace the server", ptrace(PTRACE_ATTACH, server, nullptr, nullptr) == 0);
  tried("be another program", execl("/bin/true", "true", nullptr) == 0);
  tried("write code", mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                           MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
  tried("write where others read", write(STDERR_FILENO, "", 1) >= 0);
  return done;
}

/// One that a process has forked; 0: there is none.
pid_t child_of(pid_t process) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    if (!std::getline(stat, line)) continue;
    std::istringstream rest(line.substr(line.rfind(')') + 1));  // state, parent, ...
    std::string state;
    pid_t parent = 0;
    rest >> state >> parent;
    if (parent == process && state != "Z") return std::stoi(entry.path().filename());
  }
  return 0;
}

/// The first byte says what to do.
std::string work(std::string_view question) {
  switch (question.empty() ? 'e' : question.front()) {
    case 'f':
      *nowhere = 1;
      return "";
    case 'x':
      throw std::runtime_error("of a reader");
    case 'm':
      for (std::vector<std::string> all;;) all.emplace_back(std::size_t{1} << 20, 'm');
    case 't':
      for (volatile int i = 0;;) i = i + 1;
    case 'l':
      return std::string(std::size_t{1} << 28, 'l');
    case 's':
      return could();
    case 'p':
      return std::to_string(getpid());
    default:
      return "heard " + std::string(question);
  }
}

class ReaderProcessesTest : public testing::Test {
 protected:
  ReaderProcesses::Result ask(std::string_view question,
                              const std::function<bool()>& cancelled = {}) {
    return readers_.ask(question, {.cpu_seconds = 1}, cancelled);
  }
  ReaderProcesses readers_{work, kBytes};
};

TEST_F(ReaderProcessesTest, AnswersComeWhole) {
  EXPECT_EQ(ask("").answer, "heard ");
  const std::string large(std::size_t{9} << 20, 'h');
  const ReaderProcesses::Result result = ask(large);
  EXPECT_EQ(result.end, End::Answered);
  EXPECT_EQ(result.answer, "heard " + large);
}

TEST_F(ReaderProcessesTest, AnAnswerIsBounded) {
  // With room for it: what other tests have mapped counts, too.
  const ReaderProcesses readers{work, std::size_t{8} << 30};
  EXPECT_EQ(readers.ask("l", {.cpu_seconds = 5}, {}).end, End::Died);
}

TEST_F(ReaderProcessesTest, AFaultIsOneQuestionsAlone) {
  for (const char* fault : {"f", "x"}) {
    EXPECT_EQ(ask(fault).end, End::Died) << fault;
    EXPECT_EQ(ask("h").answer, "heard h") << fault;
  }
}

TEST_F(ReaderProcessesTest, TimeIsBounded) { EXPECT_EQ(ask("t").end, End::OutOfTime); }

TEST_F(ReaderProcessesTest, MemoryIsBounded) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer's shadow takes all addresses";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  GTEST_SKIP() << "the sanitizer's shadow takes all addresses";
#endif
#endif
  EXPECT_EQ(ask("m").end, End::OutOfMemory);
}

TEST_F(ReaderProcessesTest, AReaderThatWasTakenOverCanDoNothingElse) {
  EXPECT_EQ(ask("s").answer, "");
}

TEST_F(ReaderProcessesTest, NobodyIsReadForThatHasGone) {
  int times = 0;
  EXPECT_EQ(ask("t", [&] { return ++times > 3; }).end, End::Cancelled);
  EXPECT_EQ(times, 4);
}

TEST_F(ReaderProcessesTest, ManyAskAtOnce) {
  std::vector<std::thread> clients;
  for (int i = 0; i < 8; ++i)
    clients.emplace_back([this, i] {
      for (int k = 0; k < 20; ++k) {
        const std::string question = 'h' + std::to_string(100 * i + k);
        EXPECT_EQ(ask(question).answer, "heard " + question);
      }
    });
  for (std::thread& client : clients) client.join();
}

TEST_F(ReaderProcessesTest, ATemplateThatTheSystemEndsIsForkedAgain) {
  EXPECT_EQ(ask("h").answer, "heard h");
  const pid_t keeper = child_of(getpid()), first = child_of(keeper);
  ASSERT_GT(first, 0);
  kill(first, SIGKILL);
  pid_t second = first;
  for (int i = 0; i < 500 && (second == first || second == 0); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    second = child_of(keeper);
  }
  EXPECT_NE(second, first);
  EXPECT_EQ(ask("h").answer, "heard h");
}

TEST_F(ReaderProcessesTest, WithoutItsKeeperAQuestionDies) {
  // An answer all the same.
  ReaderProcesses own(work, kBytes, [] { _exit(0); });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(own.ask("h", {}, {}).end, End::Died);
}

TEST_F(ReaderProcessesTest, NothingIsLeftOfIt) {
  const pid_t reader = std::stoi(ask("p").answer);
  for (int i = 0; i < 200 && kill(reader, 0) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_NE(kill(reader, 0), 0);
}

}  // namespace
}  // namespace coapt
