#include "server/farm_watch.h"

#include <array>

#include "farm/ask/child_process.h"

namespace coapt {
namespace {

constexpr std::chrono::seconds kFresh(1);
constexpr const char* kPatience_s = "5";  // until a database that does not answer is given up
constexpr std::array kOfRun = {
    "run",           "label",      "kind",  "state",   "created",           "items",
    "done",          "rate_per_s", "eta_s", "workers", "waits_for_workers", "tasks_poison",
    "tasks_disputed"};
constexpr std::array kOfWorker = {"name", "alive", "barred", "items", "rate_per_s", "seen_s"};

template <std::size_t N>
Json picked(const Json& rows, const std::array<const char*, N>& names) {
  Json all = Json::array();
  for (const Json& row : rows) {
    Json& one = all.emplace_back(Json::object());
    for (const char* name : names) one[name] = row.value(name, Json());
  }
  return all;
}

Expected<Json> ask_status(const Farm& farm) {
  ChildCall call;
  call.program = farm.program;
  call.arguments = {"status", "--json"};
  call.environment = {{"COAPT_FARM", farm.url}, {"PGCONNECT_TIMEOUT", kPatience_s}};
  const Expected<ChildEnd> end = run_child(call);
  if (!end) return end.errors();
  // What it complains of may name machines and accounts: not for users of the service.
  const Errors none = {{ErrorCode::Busy, "", "the farm's database does not answer"}};
  if (end->status != 0) return none;
  const Json whole = Json::parse(end->output, nullptr, false);
  if (!whole.is_object()) return none;
  return Json{{"runs", picked(whole.value("runs", Json()), kOfRun)},
              {"workers", picked(whole.value("workers", Json()), kOfWorker)}};
}

}  // namespace

Expected<Json> FarmWatch::status() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (!last_ || now - asked_ > kFresh) {
    last_ = ask_status(*farm_);
    asked_ = std::chrono::steady_clock::now();
  }
  return *last_;
}

}  // namespace coapt
