// coapt-farm with a kind of work that costs nothing but the time it is told to take, and a worker that can be made to answer
// wrongly: what the farm must do then cannot be asked of the real kinds.
//
// Part 0: {"items", "task_items", "ms": of an item, "throws_at": item, "kills_at": item}; the others are mixed into the answers,
// eight bytes an item. Environment: TOY_REVISION; TOY_FLIP, a share of tasks in which a bit is flipped; TOY_SIZE, bytes that
// each item's answer has more; TOY_STOPS_AFTER, items after which the process stops (SIGSTOP), once.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

#include "farm/program/commands.h"
#include "io/command_line/program.h"
#include "io/json/json.h"

namespace {

using namespace coapt;

std::string setting(const char* name, const char* usual) {
  const char* const value = std::getenv(name);
  return value == nullptr ? usual : value;
}

/// Once in a process, in the middle of a task that it holds.
void stop_in_time() {
  static std::atomic<int> left = std::stoi(setting("TOY_STOPS_AFTER", "-1"));
  if (left >= 0 && left-- == 0) std::raise(SIGSTOP);
}

std::uint64_t mixed(std::uint64_t x) {  // splitmix64
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

Expected<Work> open_toy(const WorkRequest& request) {
  if (request.kind != "toy") return Error{ErrorCode::Unsupported, "", "kind is not toy"};
  const auto told = Json::parse(request.parts[0]);
  std::uint64_t seed = 0;
  for (const std::string& part : request.parts)
    for (const char letter : part) seed = mixed(seed ^ static_cast<unsigned char>(letter));
  const double flip = std::stod(setting("TOY_FLIP", "0"));
  const std::string more(std::stoul(setting("TOY_SIZE", "0")), 'x');
  Work work;
  work.items = told["items"];
  work.task_items = told["task_items"];
  work.compute = [told, seed, flip, more, stop = work.stop](std::int64_t first, int count, int) {
    std::string bytes;
    for (std::int64_t item = first; item < first + count; ++item) {
      if (item == told.value("throws_at", -1)) throw std::runtime_error("item that cannot be");
      if (item == told.value("kills_at", -1)) std::raise(SIGKILL);
      if (*stop) throw WorkStopped();
      stop_in_time();
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(told.value("ms", 0.0)));
      std::uint64_t answer = mixed(seed ^ static_cast<std::uint64_t>(item));
      for (int i = 0; i < 8; ++i, answer >>= 8) bytes += static_cast<char>(answer & 255u);
      bytes += more;
    }
    if (static_cast<double>(mixed(static_cast<std::uint64_t>(first)) >> 11) * 0x1p-53 < flip)
      bytes[0] = static_cast<char>(bytes[0] ^ 1);
    return bytes;
  };
  work.objection = [more](std::int64_t, int count, std::string_view bytes) {
    const std::size_t expected = static_cast<std::size_t>(count) * (8 + more.size());
    return bytes.size() == expected ? "" : std::to_string(bytes.size()) + " bytes";
  };
  work.doubt = [told](std::int64_t, int, std::string_view bytes) {
    return told.value("doubted", false) || bytes.starts_with(std::string_view("\0\0", 2));
  };
  return work;
}

void add_commands(Command app, int& status) {
  add_farm_commands(app, status, {open_toy, setting("TOY_REVISION", "toy")});
}

}  // namespace

int main(int argc, char** argv) {
  return run_program({"toy-farm", kFarmDescription, kFarmFooter, add_commands}, argc, argv);
}
