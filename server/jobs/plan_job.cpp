#include "server/jobs/plan_job.h"

#include <algorithm>
#include <thread>

#include "farm/ask/farm.h"
#include "io/json/parse_json.h"
#include "io/json/plans_json.h"
#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "io/json/valve_json.h"
#include "io/picture/search_csv.h"
#include "io/store/plan_store.h"
#include "server/answer.h"
#include "server/jobs/closure_keeping.h"
#include "server/jobs/farm_plan.h"
#include "server/jobs/search_reports.h"

namespace coapt {
namespace {

constexpr double kLeastSeconds = 5.0;  // of a job that goes on: to take its closures in and to rank

/// As asked, within what the service gives; less what earlier attempts took.
SearchOptions granted(SearchOptions options, const ServiceLimits& limits, double spent_s) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = limits.threads > 0 ? limits.threads : cores;
  options.threads = options.threads > 0 ? std::min(options.threads, threads) : threads;
  const double most =
      options.seconds > 0.0 ? std::min(options.seconds, limits.seconds) : limits.seconds;
  options.seconds =
      spent_s > kLeastSeconds ? std::max(most - spent_s, std::min(most, kLeastSeconds)) : most;
  return options;
}

/// What is told of a plan in the job itself.
Json summary_of(const Json& plan) {
  Json summary;
  for (const char* key : {"rank", "description", "plan", "leak_mm2", "ranked_cost", "cost",
                          "status", "crossing", "margin_to_leak", "tie_with_next", "warnings"})
    summary[key] = plan[key];
  return summary;
}

/// That the search has ended with.
void note_best(RunningJob& job, const RankedPlan& best) {
  JobProgress last = job.progress();
  last.leading = std::make_shared<const LeadingPlan>(LeadingPlan{
      best.plan, best.description, best.cost, best.region.closures, best.region.leak_mm2.nominal});
  job.note(last);
}

}  // namespace

std::string search_summary(const Json& plans) {
  Json list = Json::array();
  for (const Json& plan : plans["plans"]) list.push_back(summary_of(plan));
  return Json{{"stop", plans["stop"]},
              {"any_competent", plans["any_competent"]},
              {"plans", std::move(list)}}
      .dump();
}

std::optional<JobEnd> PlanJob::operator()(RunningJob& job) const {
  const Valve valve = retried<Valve>(board, job, [&] { return valve_of(store, job.job); });
  const Expected<Json> request = parse_json(job.job.request);
  if (!request) return failed(job, request.errors());
  const Expected<SearchOptions> asked = search_options_from_json(*request);
  if (!asked) return failed(job, asked.errors());
  if (!farm.empty() && asked->seconds == 0.0)
    return FarmPlan{board, limits, ask_farm(farm_at(farm))}(job, valve, *asked);
  SearchOptions options = granted(*asked, limits, job.seconds());
  options.closure.budget.cancelled = [this] { return board.stopping(); };

  auto kept = retried<PlanStore>(board, job, [&] { return PlanStore::open(closures); });
  const std::string subject = plan_subject_of(valve, options.closure);
  auto known = retried<KnownPlans>(board, job, [&] { return kept.read(subject); });
  std::int64_t count = 0;
  for (const auto& [key, of_plan] : known) count += std::ssize(of_plan);
  if (const std::optional<JobEnd> end = begin(board, job, count)) return end;

  SearchContext context{.cancelled = &job.cancelled};
  context.known = std::move(known);
  context.keep = [&](const std::string& key, int disturbance, const PlanClosure& closure) {
    if (board.stopping()) throw std::runtime_error(kJobStops);  // the closure may be unfinished
    keep_closure(board, job, [&] { return kept.keep(subject, key, disturbance, closure); });
  };
  context.progress = [&](const SearchProgress& now) {
    job.note({now.stage, now.closures, now.closures_planned, now.best_leak_mm2, now.best_cost,
              now.random_cost, now.leading});
  };
  const double waited = job.waited_s();
  const Expected<SearchResult> result = search_plans(valve, options, context);
  if (!result) return failed(job, result.errors());
  if (result->stop == SearchStop::Cancelled && !job.cancel_asked) return std::nullopt;
  // The search's clock went on while the disk was full: what it has closed is known now.
  if (result->stop == SearchStop::TimeLimit && job.waited_s() > waited) return (*this)(job);

  const SearchRequest reproduce{*asked, subject_of(valve, asked->closure), ""};
  const Json json = to_json(*result, reproduce);
  if (!result->plans.empty()) note_best(job, result->plans.front());
  JobEnd end =
      ended(job, result->stop == SearchStop::Cancelled ? JobState::Cancelled : JobState::Succeeded);
  end.summary = search_summary(json);
  end.result = json.dump();
  end.material = search_material(*result, reproduce);
  end.files.push_back({kTriedPlansFile, kCsvType, tried_plans_csv(valve, *result)});
  return end;
}

}  // namespace coapt
