#include "server/jobs/job_json.h"

#include <cstdio>
#include <ctime>

#include "server/jobs/import_job.h"

namespace coapt {
namespace {

Json links_json(const Job& job) {
  const std::string self = "/v1/jobs/" + job.id;
  Json links = {{"self", self}, {"events", self + "/events"}, {"cancel", self + ":cancel"}};
  if (job.state == JobState::Failed || job.summary.empty()) return links;  // no results
  links["result"] = self + "/result";
  if (job.kind == "import") {
    links["picture"] = self + "/files/" + kImportPicture;
    links["files"] = self + "/files";
    return links;
  }
  if (job.kind != "plans" && job.kind != "study") return links;
  if (job.kind == "plans") {
    links["plans"] = self + "/plans";
    links["evaluations"] = self + "/evaluations.csv";
  }
  links["report"] = self + "/report";
  links["files"] = self + "/files";
  return links;
}

}  // namespace

Json time_json(std::int64_t ms) {
  if (ms == 0) return nullptr;
  const std::time_t seconds = static_cast<std::time_t>(ms / 1000);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char day[32], text[48];
  std::strftime(day, sizeof day, "%Y-%m-%dT%H:%M:%S", &utc);
  std::snprintf(text, sizeof text, "%s.%03dZ", day, static_cast<int>(ms % 1000));
  return text;
}

Json to_json(const JobView& view, bool results) {
  const Job& job = view.job;
  Json json = {
      {"id", job.id},
      {"kind", job.kind},
      {"state", to_string(job.state)},
      {"created", time_json(job.created_ms)},
      {"started", time_json(job.started_ms)},
      {"finished", time_json(job.finished_ms)},
      {"valve", job.valve},
      {"cancel_requested", job.cancel_requested},
      {"waiting_for", nullptr},
      {"queue_position", nullptr},
      {"progress", view.progress.is_null() ? to_json(JobProgress{}, job.seconds) : view.progress},
      {"problems", Json::array()}};
  if (!view.waiting_for.empty()) json["waiting_for"] = view.waiting_for;
  if (view.queue_position) json["queue_position"] = *view.queue_position;
  if (results && job.kind == "plans") json["plans"] = nullptr;
  if (!job.summary.empty() && (results || job.state == JobState::Failed))
    json.update(Json::parse(job.summary));
  json["links"] = links_json(job);
  return json;
}

}  // namespace coapt
