#include "server/jobs/farm_plan.h"

#include "farm/work/plan_work.h"
#include "io/json/search_options_json.h"
#include "server/answer.h"
#include "server/jobs/closure_keeping.h"
#include "server/jobs/plan_job.h"
#include "server/jobs/search_reports.h"

namespace coapt {
namespace {

constexpr const char* kOnTheFarm = "searched by the farm";

Error out_of_time(double seconds) {
  return {ErrorCode::OutOfRange, "/search",
          "took longer than " + shown(seconds) +
              " s, the limit of this service; the farm continues, so repeat the request later"};
}

}  // namespace

std::optional<JobEnd> FarmPlan::operator()(RunningJob& job, const Valve& valve,
                                           const SearchOptions& asked) const {
  const Expected<WorkRequest> request = plan_request({valve}, asked);
  if (!request) return failed(job, request.errors());
  if (const std::optional<JobEnd> end = begin(board, job, 0)) return end;
  job.note({.stage = kOnTheFarm});
  const auto look = [&](const AskProgress&) {
    if (job.seconds() > limits.seconds) job.cancelled = true;
  };
  const Expected<std::string> bytes = farm(*request, {"coapt-server plans", look, &job.cancelled});
  if (!bytes && job.cancel_asked) return ended(job, JobState::Cancelled);
  if (!bytes && board.stopping()) return std::nullopt;
  if (!bytes && job.seconds() > limits.seconds) return failed(job, {out_of_time(limits.seconds)});
  if (!bytes) return failed(job, bytes.errors());
  Expected<std::vector<PlanAnswer>> answers = plan_answers(*bytes);
  if (!answers || answers->size() != 1)
    return failed(job, {Error{ErrorCode::Unsupported, "", "the farm returned an invalid answer"}});
  PlanAnswer& answer = answers->front();
  Json plans = Json::parse(answer.plans);
  plans["seconds"] = job.seconds();
  plans["reproduce"]["search"] = to_json(asked);
  JobEnd end = ended(job, JobState::Succeeded);
  end.summary = search_summary(plans);
  end.result = plans.dump();
  end.material = packed_material(answer.material);
  end.files.push_back({kTriedPlansFile, kCsvType, std::move(answer.tried)});
  return end;
}

}  // namespace coapt
