#include "clients/python/engine/local_service.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "clients/python/engine/problems.h"
#include "io/json/parse_json.h"
#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "operations/operations.h"
#include "operations/surface_file.h"
#include "server/jobs/import_job.h"
#include "server/jobs/operation_job.h"
#include "server/jobs/plan_job.h"
#include "server/jobs/study_job.h"
#include "server/json_body.h"
#include "server/routes.h"

namespace coapt {
namespace {

constexpr std::chrono::hours kPatience(24 * 365);
constexpr double kMost_s = 1e6;  // that a search may take (search/plans/search_options.h)

int cores(int threads) {
  return threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

ServiceLimits local_limits(int threads) {
  constexpr int kAny = std::numeric_limits<int>::max();
  ServiceLimits limits;
  limits.vertices = 100'000;
  limits.chordae = 10'000;
  limits.evaluations = 1'000'000;
  limits.vertex_steps = std::numeric_limits<double>::infinity();
  limits.request_seconds = limits.seconds = kMost_s;
  limits.retention.jobs = limits.retention.valves = limits.retention.closures = kAny;
  limits.kept_plans = limits.queue = limits.evaluation_closures = kAny;
  limits.threads = limits.request_threads = cores(threads);
  limits.running_jobs = 1;
  return limits;
}

LocalService::LocalService(const std::string& database, int threads)
    : database_(database),
      limits_(local_limits(threads)),
      store_(taken(JobStore::open(database))),
      board_(store_, limits_.queue, limits_.retention),
      retention_{store_, limits_.retention, database + "-plans", database + "-studies"},
      parsing_(cores(threads), kPatience, kPatience),
      compute_(cores(threads), kPatience, kPatience),
      reports_(cores(threads), kPatience),
      service_{limits_,
               store_,
               board_,
               known_,
               parsing_,
               compute_,
               {limits_},
               reports_,
               farm_,
               metrics_,
               page_,
               tokens_,
               [] { return HttpLoad{}; }},
      routes_(routes_of(service_)) {
  taken(PlanStore::open(retention_.plans));
  taken(ClosureStore::open(retention_.studies));
  if (const Errors errors = board_.resume(); !errors.empty()) throw Problems(errors);
  constexpr int kAsNice = 0;
  runner_ = std::make_unique<JobRunner>(
      board_,
      with_operations({{"plans", PlanJob{board_, store_, limits_, retention_.plans}},
                       {"study", StudyJob{board_, store_, limits_, retention_.studies}},
                       {"import", ImportJob{board_, store_, {limits_}}}},
                      board_, store_, {limits_}),
      limits_.running_jobs, [](const Job&) {}, kAsNice);
}

Answer LocalService::answer(Request request) const {
  const Found found = find_route(routes_, request);
  if (!found.route) return found.refusal;
  request.parameters = found.parameters;
  return found.route->endpoint(request);
}

std::string LocalService::compute(const std::string& operation, const std::string& request,
                                  Context& context) {
  const std::vector<Operation> all = operations();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Operation& one) { return operation == one.name; });
  context.limits.threads = limits_.threads;
  context.surface_of = read_surface_file;
  context.valve_named = [this](const std::string& name) {
    return named_valve({store_, limits_, known_, parsing_}, name);
  };
  const OperationTask task = taken(found->read(taken(parse_json(request)), context));
  context.start();
  return std::get<Json>(taken(task.run(context))).dump();
}

LocalValve LocalService::named(const std::string& name) {
  taken(named_valve({store_, limits_, known_, parsing_}, name), "/valve");
  return {known_.find(name)};
}

}  // namespace coapt
