// Any bytes as a request to any endpoint, without sockets: the first byte chooses (endpoint_choice.h).
// Nothing may be thrown; no status is one of a failing server; every refusal lists problems.
//
// Closures are real, but of valves no larger than small_valve(). Jobs are not run.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "io/json/plan_json.h"
#include "io/json/plans_json.h"
#include "io/json/valve_json.h"
#include "io/store/kept_plans.h"
#include "io/store/stored_valves.h"
#include "server/farm_watch.h"
#include "server/routes.h"
#include "server/service.h"
#include "tests/fuzz/endpoint_choice.h"
#include "tests/scenes/small_valve.h"

namespace {

using namespace coapt;

/// Removed with all that is in it.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fuzz_endpoints-" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
};

template <class T>
T must(Expected<T> value) {
  if (!value) std::abort();
  return *std::move(value);
}
void must(const Errors& errors) {
  if (!errors.empty()) std::abort();
}

ServiceLimits small_limits() {
  ServiceLimits limits;
  limits.vertices = static_cast<int>(small_valve().rest_mm.rows());
  limits.evaluation_closures = 2;
  limits.wait_seconds = 0;
  limits.request_seconds = 600.0;  // sanitizers take theirs
  return limits;
}

/// coapt.plans/1 of one plan without steps.
std::string a_result() {
  SearchOptions options;
  options.threads = 1;
  options.evidence = false;
  options.region_points = 1;
  const SearchResult result = must(evaluate_plans(small_valve(), {{"", {}}}, options, {}));
  return to_json(result).dump();
}

struct Bench {
  Folder folder;
  ServiceLimits limits = small_limits();
  JobStore store = must(JobStore::open((folder.path / "jobs.sqlite").string()));
  JobBoard jobs{store, limits.queue};
  ValveCache known;
  Compute parsing, compute;
  SearchReports reports;
  FarmWatch farm{std::nullopt};
  Metrics metrics;
  Page page;
  PageTokens tokens;
  Service service{.limits = limits,
                  .store = store,
                  .jobs = jobs,
                  .known = known,
                  .parsing = parsing,
                  .compute = compute,
                  .imports = {limits},
                  .reports = reports,
                  .farm = farm,
                  .metrics = metrics,
                  .page = page,
                  .tokens = tokens,
                  .load = [] { return HttpLoad{}; }};
  Routes routes = routes_of(service);

  Bench() {
    const std::string valve = write_valve(small_valve());
    for (const char* id : {kEndedJob, kWaitingJob})
      must(store.submit({id, "plans", kStoredValve, "{}", ""}, valve, 1));
    must(store.start(kEndedJob, 0, 2));
    const JobFile report = {"report.html", "text/html; charset=utf-8", "<p>Report</p>"};
    must(store.finish(kEndedJob, {JobState::Succeeded, 1.0, "{}", "{}", a_result(), {report}}, 3));
    const std::string plan = to_json(RepairPlan{}).dump();
    if (!must(keep_plan(store, {kKeptPlan, "A plan", kStoredValve, plan}, 1))) std::abort();
    must(jobs.resume());
  }
};

Request request_of(std::uint8_t choice, std::string_view rest) {
  constexpr std::size_t kForms = kBodyPaths.size(), kChoices = kForms + 1 + kOtherMethods.size();
  const std::size_t index = (choice + 256u - 'a') % 256u % kChoices;
  Request request;
  if (index == kForms) {
    request.path = kFormPath;
    request.method = "POST";
    request.headers["content-type"] = "multipart/form-data; boundary=" + std::string(kFormBoundary);
    request.body = rest;
    return request;
  }
  if (index < kForms) {
    request.path = kBodyPaths[index];
    request.method = kBodyPaths[index] == kKeptPlanPath ? "PATCH" : "POST";
    request.body = rest;
    return request;
  }
  request.method = kOtherMethods[index - kForms - 1];
  const std::size_t mark = std::min(rest.find('?'), rest.size());
  request.path = rest.substr(0, mark);
  rest.remove_prefix(std::min(mark + 1, rest.size()));
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view pair = rest.substr(0, end);
    const std::size_t equals = std::min(pair.find('='), pair.size());
    request.query.emplace(pair.substr(0, equals), pair.substr(std::min(equals + 1, pair.size())));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return request;
}

void check(const Answer& answer) {
  if (answer.status < 200 || answer.status >= 500) std::abort();
  (void)content_type(answer);
  (void)content_bytes(answer);
  if (answer.status < 400) return;
  const auto* body = std::get_if<Json>(&answer.body);
  if (body == nullptr || body->at("status") != answer.status || body->at("problems").empty())
    std::abort();
}

/// What a request has put into the store is taken out again.
void undo(Bench& bench, const Answer& answer) {
  for (const auto& [name, value] : answer.headers) {
    if (name != "Location") continue;
    const std::string id = value.substr(value.rfind('/') + 1);
    if (value.starts_with("/v1/jobs/")) {
      const std::optional<Job> job = must(bench.store.job(id));
      if (!must(bench.jobs.cancel(id)) || !must(bench.store.remove(id))) std::abort();
      if (job->valve != kStoredValve) (void)remove_valve(bench.store, job->valve);
    } else if (value.starts_with("/v1/kept-plans/")) {
      if (!must(remove_kept_plan(bench.store, id))) std::abort();
    } else {
      (void)remove_valve(bench.store, id);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Bench bench;
  if (size == 0) return 0;
  const Request asked = request_of(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1});
  // They are there for all inputs.
  if (asked.method == "DELETE" &&
      (asked.path == std::string("/v1/jobs/") + kEndedJob || asked.path == kKeptPlanPath))
    return 0;

  const Found found = find_route(bench.routes, asked);
  if (found.route == nullptr) {
    check(found.refusal);
    return 0;
  }
  Request request = asked;
  request.parameters = found.parameters;
  const Answer answer = found.route->endpoint(request);
  check(answer);
  undo(bench, answer);
  return 0;
}
