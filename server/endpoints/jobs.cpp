#include "server/endpoints/jobs.h"

#include <array>

#include "server/answers.h"
#include "server/jobs/job_json.h"
#include "server/query.h"

namespace coapt {
namespace {

constexpr std::array kStates = {JobState::Queued, JobState::Running, JobState::Succeeded,
                                JobState::Failed, JobState::Cancelled};

std::optional<JobState> state_in(const Request& request, ProblemList& problems) {
  const auto found = request.query.find("state");
  if (found == request.query.end()) return std::nullopt;
  for (const JobState state : kStates)
    if (found->second == to_string(state)) return state;
  problems.add(ErrorCode::BadReference, "?state",
               "must be QUEUED, RUNNING, SUCCEEDED, FAILED or CANCELLED");
  return std::nullopt;
}

Answer job_answer(const Expected<std::optional<JobView>>& view) {
  if (!view) return store_problem(view.errors());
  if (!*view) return not_found("job");
  return json_answer(200, to_json(**view, true));
}

}  // namespace

Answer GetJob::operator()(const Request& request) const {
  return job_answer(jobs.find(request.parameters.at(0)));
}

Answer GetJobs::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"page_size", "page_token", "state"}, problems);
  const std::int64_t size = integer_in(request, "page_size", {1.0, 100.0}, 20, problems);
  const std::int64_t before = page_token_in(request, tokens, problems);
  const std::optional<JobState> state = state_in(request, problems);
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Expected<JobPage> page = store.page(static_cast<int>(size), before, state);
  if (!page) return store_problem(page.errors());
  Json list = Json::array();
  for (const Job& job : page->jobs) list.push_back(to_json(jobs.view(job), false));
  return json_answer(200,
                     {{"jobs", std::move(list)},
                      {"next_page_token", next_page_token(request, tokens, page->next_before)}});
}

Answer CancelJob::operator()(const Request& request) const {
  const Expected<bool> cancelled = jobs.cancel(request.parameters.at(0));
  if (!cancelled) return store_problem(cancelled.errors());
  if (!*cancelled) return not_found("job");
  return job_answer(jobs.find(request.parameters.at(0)));
}

Answer DeleteJob::operator()(const Request& request) const {
  const Expected<bool> removed = store.remove(request.parameters.at(0));
  if (removed) return *removed ? Answer{204} : not_found("job");
  const bool is_unfinished = removed.errors().front().code == ErrorCode::BadReference;
  return is_unfinished ? problem(409, removed.errors()) : store_problem(removed.errors());
}

}  // namespace coapt
