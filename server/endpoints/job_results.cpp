#include "server/endpoints/job_results.h"

#include <algorithm>

#include "core/repair/apply_plan.h"
#include "io/exchange/formats.h"
#include "io/json/plan_json.h"
#include "io/picture/picture.h"
#include "operations/export.h"
#include "server/answers.h"
#include "server/endpoints/operations.h"
#include "server/jobs/closure_keeping.h"
#include "server/jobs/plan_job.h"
#include "server/query.h"
#include "server/turns.h"

namespace coapt {
namespace {

/// A job with what it has come to, or why there is nothing.
struct Ended {
  Job job;
  std::string result;  ///< JSON; empty: it was cancelled before it had anything
  std::optional<Answer> refusal = {};
};

/// @param with_result else it is left empty.
Ended ended_job(const JobStore& store, const Request& request, bool with_result) {
  const Expected<std::optional<Job>> job = store.job(request.parameters.at(0));
  if (!job) return {{}, "", store_problem(job.errors())};
  if (!*job) return {{}, "", not_found("job")};
  const JobState state = (*job)->state;
  if (state != JobState::Succeeded && state != JobState::Cancelled)
    return {{},
            "",
            problem(409, ErrorCode::BadReference,
                    std::string("the job is ") + to_string(state) +
                        "; results are available once it is SUCCEEDED or CANCELLED")};
  if (!with_result) return {**job, ""};
  const Expected<std::optional<std::string>> result = store.result((*job)->id);
  if (!result) return {{}, "", store_problem(result.errors())};
  return {**job, result->value_or("")};
}

Json plans_of(const Ended& ended) {
  if (ended.result.empty() || ended.job.kind != "plans") return Json::array();
  return Json::parse(ended.result)["plans"];
}

/// The plan of the rank that the path says; null if there is none.
Json ranked(const Ended& ended, const Request& request) {
  for (Json& plan : plans_of(ended))
    if (request.parameters.at(1) == std::to_string(plan["rank"].get<int>())) return plan;
  return nullptr;
}

Answer file_answer(const JobStore& store, const std::string& id, const std::string& name) {
  const Expected<std::optional<JobFile>> file = store.file(id, name);
  if (!file) return store_problem(file.errors());
  if (!*file) return not_found("file");
  return {200, Content{(*file)->type, (*file)->content}};
}

/// A file that the job left, or a report that is drawn now.
Answer file_answer(const JobStore& store, SearchReports& reports, const Job& job,
                   const std::string& name, const Request& request) {
  if (auto report = reports.report(store, job, name, request.client)) return *std::move(report);
  return file_answer(store, job.id, name);
}

/// The valve of a job, and as the plan leaves it.
struct Repair {
  Valve before, after;
  RepairPlan plan;
  std::optional<Answer> refusal = {};
};

Repair repair_of(const JobStore& store, const Request& request) {
  const Ended ended = ended_job(store, request, true);
  if (ended.refusal) return {{}, {}, {}, ended.refusal};
  const Json ranked_plan = ranked(ended, request);
  if (ranked_plan.is_null()) return {{}, {}, {}, not_found("plan")};
  const Expected<Valve> valve = valve_of(store, ended.job);
  if (!valve) return {{}, {}, {}, store_problem(valve.errors())};
  const Expected<RepairPlan> plan = plan_from_json(ranked_plan["plan"]);
  if (!plan) return {{}, {}, {}, problem(500, plan.errors())};
  const Expected<Valve> repaired = apply_plan(*valve, *plan);
  if (!repaired) return {{}, {}, {}, problem(500, repaired.errors())};
  return {*valve, *repaired, *plan};
}

}  // namespace

Answer GetResult::operator()(const Request& request) const {
  Ended ended = ended_job(store, request, true);
  if (ended.refusal) return *ended.refusal;
  if (ended.result.empty()) return not_found("result: the job was cancelled before it had one");
  return {200, Content{"application/json", std::move(ended.result)}};
}

Answer GetPlans::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"page_size", "page_token"}, problems);
  const std::int64_t size = integer_in(request, "page_size", {1.0, 100.0}, 20, problems);
  const std::int64_t first = std::max<std::int64_t>(1, page_token_in(request, tokens, problems));
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Ended ended = ended_job(store, request, true);
  if (ended.refusal) return *ended.refusal;
  Json page = Json::array();
  std::int64_t next = 0;
  for (Json& plan : plans_of(ended)) {
    const std::int64_t rank = plan["rank"].get<std::int64_t>();
    if (rank >= first + size) next = first + size;
    if (rank >= first && rank < first + size) page.push_back(std::move(plan));
  }
  return json_answer(200, {{"plans", std::move(page)},
                           {"next_page_token", next_page_token(request, tokens, next)}});
}

Answer GetPlan::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, true);
  if (ended.refusal) return *ended.refusal;
  Json plan = ranked(ended, request);
  return plan.is_null() ? not_found("plan") : json_answer(200, std::move(plan));
}

Answer GetPlanMesh::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"format"}, problems);
  const auto asked = request.query.find("format");
  const FileFormat* const format =
      format_named(asked == request.query.end() ? "ply" : asked->second);
  if (format == nullptr)
    problems.add(ErrorCode::Unsupported, "?format", "must be one of " + format_names());
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Repair repair = repair_of(store, request);
  if (repair.refusal) return *repair.refusal;
  const double seconds =
      closing_seconds(repair.after.rest_mm.rows()) + writing_seconds(*format, repair.after.rest_mm);
  return answer_in_turn(compute, limits, request, seconds, [&](Context& context) {
    const Expected<ClosedValve> closed = context.close(repair.after, {.motion = true});
    if (!closed) return refusal(closed.errors());
    const ExportOptions options{.cancelled = [&] { return context.cancelled(); }};
    Expected<AnswerFile> file =
        exported_file(with_repair(*closed, repair.before, repair.plan), *format, options);
    if (!file && context.cancelled()) return refusal({context.refusal()});
    return file ? file_answer(*std::move(file)) : refusal(file.errors());
  });
}

Answer GetPlanPicture::operator()(const Request& request) const {
  const Repair repair = repair_of(store, request);
  if (repair.refusal) return *repair.refusal;
  return answer_in_turn(
      compute, limits, request, closing_seconds(repair.after.rest_mm.rows()),
      [&](Context& context) {
        const Expected<ClosedValve> before = context.close(repair.before);
        if (!before) return refusal(before.errors());
        const Expected<ClosedValve> after = context.close(repair.after);
        if (!after) return refusal(after.errors());
        return Answer{200, Content{"image/png",
                                   comparison_picture_png(
                                       *before, with_repair(*after, repair.before, repair.plan))}};
      });
}

Answer GetPlanReport::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, false);
  if (ended.refusal) return *ended.refusal;
  return file_answer(store, reports, ended.job, "plan-" + request.parameters.at(1) + ".html",
                     request);
}

Answer GetTriedPlans::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, false);
  if (ended.refusal) return *ended.refusal;
  return file_answer(store, ended.job.id, kTriedPlansFile);
}

Answer GetReport::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, false);
  if (ended.refusal) return *ended.refusal;
  return file_answer(store, reports, ended.job,
                     ended.job.kind == "plans" ? "report.html" : "index.html", request);
}

Answer GetFiles::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, false);
  if (ended.refusal) return *ended.refusal;
  const Expected<std::vector<JobFileName>> left = store.files(ended.job.id);
  if (!left) return store_problem(left.errors());
  const auto made = reports.list(store, ended.job, limits, request);
  if (const Answer* const refusal = std::get_if<Answer>(&made)) return *refusal;
  std::vector<JobFileName> files = std::get<std::vector<JobFileName>>(made);
  files.insert(files.end(), left->begin(), left->end());
  Json list = Json::array();
  for (const JobFileName& file : files)
    list.push_back({{"name", file.name},
                    {"type", file.type},
                    {"bytes", file.bytes},
                    {"path", "/v1/jobs/" + ended.job.id + "/files/" + file.name}});
  return json_answer(200, {{"files", std::move(list)}});
}

Answer GetFile::operator()(const Request& request) const {
  const Ended ended = ended_job(store, request, false);
  if (ended.refusal) return *ended.refusal;
  return file_answer(store, reports, ended.job, request.parameters.at(1), request);
}

}  // namespace coapt
