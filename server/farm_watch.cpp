#include "server/farm_watch.h"

#include <array>

#include "farm/ask/child_process.h"

namespace coapt {
namespace {

using nlohmann::ordered_json;

constexpr std::chrono::seconds kFresh(1);
constexpr const char* kPatience_s = "5";  // until a database that does not answer is given up
constexpr std::array kOfRun = {
    "run",           "label",      "kind",  "state",   "created",           "items",
    "done",          "rate_per_s", "eta_s", "workers", "waits_for_workers", "tasks_poison",
    "tasks_disputed"};
constexpr std::array kOfWorker = {"name", "alive", "barred", "items", "rate_per_s", "seen_s"};

template <std::size_t N>
ordered_json picked(const ordered_json& rows, const std::array<const char*, N>& names) {
  ordered_json all = ordered_json::array();
  for (const ordered_json& row : rows) {
    ordered_json& one = all.emplace_back(ordered_json::object());
    for (const char* name : names) one[name] = row.value(name, ordered_json());
  }
  return all;
}

Expected<ordered_json> ask_status(const Farm& farm) {
  ChildCall call;
  call.program = farm.program;
  call.arguments = {"status", "--json"};
  call.environment = {{"COAPT_FARM", farm.url}, {"PGCONNECT_TIMEOUT", kPatience_s}};
  const Expected<ChildEnd> end = run_child(call);
  if (!end) return end.errors();
  // What it complains of may name machines and accounts: not for users of the service.
  const Errors none = {{ErrorCode::Busy, "", "the farm's database does not answer"}};
  if (end->status != 0) return none;
  const ordered_json whole = ordered_json::parse(end->output, nullptr, false);
  if (!whole.is_object()) return none;
  return ordered_json{{"runs", picked(whole.value("runs", ordered_json()), kOfRun)},
                      {"workers", picked(whole.value("workers", ordered_json()), kOfWorker)}};
}

}  // namespace

Expected<ordered_json> FarmWatch::status() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (!last_ || now - asked_ > kFresh) {
    last_ = ask_status(*farm_);
    asked_ = std::chrono::steady_clock::now();
  }
  return *last_;
}

}  // namespace coapt
