#include "server/endpoints/health.h"

#include <chrono>

#include "core/valve/parametric.h"
#include "io/json/plans_json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/evaluator.h"
#include "server/answers.h"
#include "server/openapi.h"

namespace coapt {
namespace {

constexpr int kTriangles = 150;  // of the valve that is closed as a test: some milliseconds

Valve small_valve() {
  ParametricValve dimensions;
  dimensions.triangles = kTriangles;
  return *make_parametric_valve(dimensions);
}

}  // namespace

Answer GetLive::operator()(const Request& /*request*/) const {
  return json_answer(200, {{"status", "live"}});
}

Answer GetReady::operator()(const Request& /*request*/) const {
  if (jobs.stopping()) return retry_later(503, "the server is shutting down");
  if (const Errors errors = store.check_writable(); !errors.empty())
    return retry_later(503, without_folders(errors.front().message));
  static const Valve kValve = small_valve();
  const auto start = std::chrono::steady_clock::now();
  const ClosureResult closure = close_valve(kValve);
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  if (!trusted(closure)) return retry_later(503, "the test closure of a small valve failed");
  const JobLoad load = jobs.load();
  return json_answer(200, {{"status", "ready"},
                           {"closure_ms", ms.count()},
                           {"jobs_queued", load.queued},
                           {"jobs_running", load.running}});
}

Answer GetMetrics::operator()(const Request& /*request*/) const {
  const JobLoad work = jobs.load();
  const HttpLoad http = load();
  return {200, Content{"text/plain; version=0.0.4; charset=utf-8",
                       metrics.text({{"coapt_jobs{state=\"queued\"}", work.queued},
                                     {"coapt_jobs{state=\"running\"}", work.running},
                                     {"coapt_http_connections", http.connections},
                                     {"coapt_http_requests_in_progress", http.requests},
                                     {"coapt_http_streams", http.streams},
                                     {"process_resident_memory_bytes", resident_bytes()}})}};
}

Answer GetFarm::operator()(const Request& /*request*/) const {
  if (!farm.has_farm())
    return problem(404, ErrorCode::BadReference, "this service has no farm: see --farm");
  const Expected<Json> status = farm.status();
  if (!status) return retry_later(503, without_folders(status.errors().front().message));
  return json_answer(200, *status);
}

Answer GetVersion::operator()(const Request& /*request*/) const {
  return json_answer(200, {{"name", "coapt-server"},
                           {"version", version()},
                           {"revision", revision_json()},
                           {"api", "v1"},
                           {"farm", farm.has_farm()},
                           {"not_modelled", not_modelled()}});
}

Answer GetOpenApi::operator()(const Request& /*request*/) const {
  return {200, Content{"application/json", std::string(openapi_text())}};
}

}  // namespace coapt
