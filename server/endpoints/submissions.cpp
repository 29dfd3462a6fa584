#include "server/endpoints/submissions.h"

#include <algorithm>
#include <charconv>

#include "io/json/search_options_json.h"
#include "io/json/valve_json.h"
#include "search/plans/plan_search.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/jobs/job_json.h"
#include "server/jobs/study_request.h"
#include "server/turns.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestKey = 255;

/// The N of "wait=N" in a Prefer header (RFC 7240), 0 if there is none.
int preferred_wait(const std::string& prefer) {
  const std::size_t at = prefer.find("wait=");
  if (at == std::string::npos) return 0;
  int seconds = 0;
  std::from_chars(prefer.data() + at + 5, prefer.data() + prefer.size(), seconds);
  return std::max(0, seconds);
}

bool is_key(const std::string& key) {
  return key.size() <= kLongestKey &&
         std::all_of(key.begin(), key.end(), [](char c) { return c > ' ' && c < 127; });
}

Answer job_answer(int status, const JobView& view) {
  Answer answer = json_answer(status, to_json(view, true));
  answer.headers.emplace_back("Location", "/v1/jobs/" + view.job.id);
  return answer;
}

/// The job as it is when it ends or the wait is over.
Answer answer_after_waiting(const Submitting& to, const Request& request, const Job& job) {
  const int asked = preferred_wait(header(request, "prefer"));
  const int wait = std::min(asked, to.valves.limits.wait_seconds);
  const auto start = std::chrono::steady_clock::now();
  if (wait > 0) to.jobs.wait_until_ended(job.id, std::chrono::seconds(wait));
  const bool has_waited =
      wait > 0 && std::chrono::steady_clock::now() - start >= std::chrono::seconds(wait);
  const Expected<std::optional<JobView>> view = to.jobs.find(job.id);
  if (!view) return store_problem(view.errors());
  if (!*view) return not_found("job");
  const bool is_done = wait > 0 && has_ended((*view)->job.state);
  Answer answer = job_answer(is_done ? 200 : 202, **view);
  if (is_done || has_waited)
    answer.headers.emplace_back("Preference-Applied", "wait=" + std::to_string(wait));
  return answer;
}

/// What is said against a search, more than search_options_from_json() does.
Errors check(const Valve& valve, const SearchOptions& options, const ServiceLimits& limits) {
  ProblemList problems;
  check_range(problems, "/search/evaluations", options.evaluations,
              {1.0, static_cast<double>(limits.evaluations)});
  add_below(problems, "/search", check_search(valve, options));
  return std::move(problems).take();
}

}  // namespace

Answer submit(const Submitting& to, const Request& request, const SubmittedWork& work) {
  const std::string key = header(request, "idempotency-key");
  if (!is_key(key))
    return problem(422, ErrorCode::OutOfRange,
                   "Idempotency-Key must have at most 255 visible ASCII characters");
  const std::string document = write_valve(work.valve);
  const NewJob job = {random_id(),       work.kind, content_id(document),
                      work.asked.dump(), key,       work.input};
  const Expected<JobBoard::Submission> submitted = to.jobs.submit(job, document);
  if (!submitted) return store_problem(submitted.errors());
  switch (submitted->taken) {
    case JobBoard::Taken::OtherRequest:
      return problem(422, ErrorCode::OutOfRange,
                     "this Idempotency-Key was already used for another request");
    case JobBoard::Taken::QueueFull:
      return retry_later(429, "too many jobs are waiting");
    case JobBoard::Taken::Stopping:
      return retry_later(503, "the server is shutting down");
    case JobBoard::Taken::New:
    case JobBoard::Taken::Known:
      break;
  }
  return answer_after_waiting(to, request, submitted->job);
}

Answer PostPlans::operator()(const Request& request) const {
  Valve valve;
  SearchOptions options;
  if (auto refused = read_body(submitting.valves, request,
                               {{"valve", valve_field(submitting.valves, valve)},
                                {"search", document(options, search_options_from_json), false}}))
    return *std::move(refused);
  if (const Errors errors = check(valve, options, submitting.valves.limits); !errors.empty())
    return problem(422, errors);
  return submit(submitting, request, {"plans", valve, to_json(options)});
}

Answer PostStudies::operator()(const Request& request) const {
  Valve valve;
  StudyRequest study;
  if (auto refused = read_body(
          submitting.valves, request,
          {{"valve", valve_field(submitting.valves, valve)}, {"study", into(study, read_study)}}))
    return *std::move(refused);
  return submit(submitting, request, {"study", valve, to_json(study)});
}

Answer SubmitOperation::operator()(const Request& request) const {
  const ValveSource& valves = submitting.valves;
  Context context{.limits = operation_limits(valves.limits),
                  .valve_named = [&](const std::string& name) { return named_valve(valves, name); },
                  .abandoned = request.abandoned};
  context.surface_of = [&](const NamedFile& file, const ShapeFileOptions& options) {
    return read_surface(imports, file, options, context.budget());
  };
  Valve valve;
  Json kept;
  OperationTask task;
  const auto read = [&](const Json& body) {
    Expected<OperationTask> asked = operation.read(body, context);
    if (!asked) return asked.errors();
    task = *std::move(asked);
    ProblemList problems;
    valve_field(valves, valve)({body["valve"], problems});
    kept = body;
    return std::move(problems).take();
  };
  if (auto refused = read_body(valves, request, read)) return *std::move(refused);
  if (auto refused = read_files_in_turn(task, compute, context, request))
    return *std::move(refused);
  kept["valve"] = "valve";  // the job's own, by whatever name
  const std::string input = kept.dump();
  return submit(submitting, request,
                {operation.name, valve, {{"request", content_id(input)}}, input});
}

}  // namespace coapt
