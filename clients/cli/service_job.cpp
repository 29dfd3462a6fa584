#include "clients/cli/service_job.h"

#include <chrono>
#include <random>
#include <sstream>
#include <thread>

#include "clients/cli/print.h"
#include "clients/cli/search_progress.h"
#include "io/json/result_json.h"

namespace coapt {
namespace {

constexpr std::chrono::milliseconds kLook(100);  // for Ctrl-C

/// 128 random bits.
std::string new_key() {
  std::random_device random;
  std::ostringstream key;
  key << std::hex;
  for (int i = 0; i < 4; ++i) key << random() << '-';
  return key.str();
}

SearchProgress progress_of(const Json& json) {
  SearchProgress progress;
  progress.closures = json.at("closures");
  progress.closures_planned = json.at("closures_planned");
  progress.best_leak_mm2 = number_of(json.at("best_leak_mm2"));
  progress.stage = json.at("stage");
  return progress;
}

}  // namespace

Expected<ServiceJob> run_job(const Service& service, const std::string& path, const Json& request,
                             const std::atomic<bool>& interrupted) {
  const Expected<Json> submitted = post_json(service, path, request, new_key());
  if (!submitted) return submitted.errors();
  ServiceJob job{"/v1/jobs/" + submitted->at("id").get<std::string>(), ""};

  // Cancels beside the stream, which may be silent.
  const std::jthread watcher([&](const std::stop_token& over) {
    while (!over.stop_requested() && !interrupted) std::this_thread::sleep_for(kLook);
    if (interrupted) static_cast<void>(post_json(service, job.path + ":cancel", Json::object()));
  });
  {
    const ProgressBar bar;
    const Errors errors = follow_job(service, job.path, [&](const ServiceEvent& event) {
      if (!event.progress.is_null()) show(bar, progress_of(event.progress));
    });
    if (!errors.empty()) return errors;
  }
  const Expected<Json> ended = get_json(service, job.path);
  if (!ended) return ended.errors();
  job.state = ended->at("state");
  if (job.state == "FAILED") return errors_from_json(ended->at("problems"));
  return job;
}

}  // namespace coapt
