#include "server/jobs/study_job.h"

#include <stdexcept>

#include "farm/ask/farm.h"
#include "farm/ask/farm_closures.h"
#include "io/json/findings_json.h"
#include "io/json/parse_json.h"
#include "io/json/subject.h"
#include "io/store/closure_store.h"
#include "server/answer.h"
#include "server/jobs/closure_keeping.h"
#include "server/jobs/study_request.h"

namespace coapt {
namespace {

/// Ends a study from within: it has no other way to be stopped.
struct StudyStopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string type_of(const std::string& name) {
  if (name.ends_with(".svg")) return "image/svg+xml";
  if (name.ends_with(".csv")) return kCsvType;
  if (name.ends_with(".html")) return kHtmlType;
  return "application/json";
}

JobEnd end_of(const RunningJob& job, StudyKind kind, StudyReport report, OrificeTable& table) {
  Json result = complete(report, kind, table, job.seconds());
  JobEnd end = ended(job, JobState::Succeeded);
  end.summary = Json{{"findings", report.findings.size()}, {"agree", result["agree"]}}.dump();
  result["findings"] = to_json(report.findings);
  end.result = result.dump();
  for (auto& [name, content] : report.files)
    end.files.push_back({name, type_of(name), std::move(content)});
  return end;
}

}  // namespace

std::optional<JobEnd> StudyJob::operator()(RunningJob& job) const {
  const Valve valve = retried<Valve>(board, job, [&] { return valve_of(store, job.job); });
  const Expected<Json> json = parse_json(job.job.request);
  if (!json) return failed(job, json.errors());
  ProblemList problems;
  StudyRequest request = read_study({*json, problems});
  if (!problems.empty()) return failed(job, std::move(problems).take());

  OrificeTableOptions options;
  options.closure.budget.cancelled = [this] { return board.stopping(); };
  options.threads = limits.threads;
  auto kept = retried<ClosureStore>(board, job, [&] { return ClosureStore::open(closures); });
  const std::string subject = subject_of(valve, options.closure);
  auto known = retried<KnownOrifices>(board, job, [&] { return kept.read(subject); });
  if (std::optional<JobEnd> end = begin(board, job, std::ssize(known))) return end;

  options.known = std::move(known);
  const auto go_on = [&] {
    if (job.cancelled) throw StudyStopped("cancelled");
    if (job.seconds() > limits.seconds) throw StudyStopped("out of time");
  };
  options.keep = [&](const ConfigurationKey& key, const OrificeSample& sample) {
    if (board.stopping())
      throw StudyStopped("the server is shutting down");  // the closure may be unfinished
    keep_closure(board, job, [&] { return kept.keep(subject, key, sample); });
    go_on();
  };
  JobProgress progress{.stage = to_string(request.kind)};
  options.progress = [&](int done, int planned) {
    progress.closures = done;
    progress.closures_planned = planned;
    job.note(progress);
    if (job.seconds() > limits.seconds) job.cancelled = true;  // ends what a farm is asked
  };
  request.options.stage = [&](const std::string& stage) {
    progress = {stage, 0, 0};
    job.note(progress);
    go_on();
  };
  if (!farm.empty())
    options.close_elsewhere =
        closures_asked_of(ask_farm(farm_at(farm)), valve, options.closure,
                          {.label = "coapt-server study", .cancelled = &job.cancelled});
  try {
    OrificeTable table(valve, std::move(options));
    return end_of(job, request.kind, run_study(request.kind, table, request.options), table);
  } catch (const std::runtime_error&) {  // StudyStopped, or what a farm says when it is told to end
    if (job.cancel_asked) return ended(job, JobState::Cancelled);
    if (board.stopping()) return std::nullopt;
    if (job.seconds() <= limits.seconds) throw;
    return failed(job, {Error{ErrorCode::OutOfRange, "/study",
                              "took longer than " + shown(limits.seconds) +
                                  " s, the limit of this service; its closures are stored, so "
                                  "repeat the request to continue"}});
  }
}

}  // namespace coapt
