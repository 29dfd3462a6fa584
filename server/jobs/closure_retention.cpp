#include "server/jobs/closure_retention.h"

#include <exception>
#include <set>
#include <stdexcept>

#include "io/json/parse_json.h"
#include "io/json/search_options_json.h"
#include "io/json/subject.h"
#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "search/studies/orifice_table.h"
#include "server/jobs/closure_keeping.h"

namespace coapt {
namespace {

/// By which the job names its closures. Errors if its valve or its request cannot be read.
Expected<std::string> subject_of_job(const JobStore& store, const Job& job) {
  const Expected<Valve> valve = valve_of(store, job);
  if (!valve) return valve.errors();
  if (job.kind == "study") return subject_of(*valve, ClosureOptions{});
  const Expected<Json> request = parse_json(job.request);
  if (!request) return request.errors();
  const Expected<SearchOptions> options = search_options_from_json(*request);
  if (!options) return options.errors();
  return plan_subject_of(*valve, options->closure);
}

/// Of all jobs that have not ended.
Expected<std::set<std::string>> subjects_in_use(const JobStore& store) {
  const Expected<std::vector<Job>> unfinished = store.unfinished();
  if (!unfinished) return unfinished.errors();
  std::set<std::string> subjects;
  for (const Job& listed : *unfinished) {
    if (listed.kind == "import") continue;                          // keeps none
    const Expected<std::optional<Job>> job = store.job(listed.id);  // with its request
    if (!job) return job.errors();
    if (!*job) continue;
    const Expected<std::string> subject = subject_of_job(store, **job);
    if (!subject) return subject.errors();
    subjects.insert(*subject);
  }
  return subjects;
}

template <class Store>
Errors retain(const ClosureRetention& retention, const std::string& path, const std::string& used,
              std::int64_t now_ms) {
  Expected<Store> opened = Store::open(path);
  if (!opened) return opened.errors();
  if (!used.empty())
    if (Errors errors = opened->note_use(used, now_ms); !errors.empty()) return errors;
  return opened->retain(
      {retention.limits.closures, retention.limits.days},
      [&retention] { return subjects_in_use(retention.store); }, now_ms);
}

/// @param used in the store of its kind.
Errors retain_both(const ClosureRetention& retention, const std::string& kind,
                   const std::string& used, std::int64_t now_ms) {
  Errors errors =
      retain<PlanStore>(retention, retention.plans, kind == "plans" ? used : "", now_ms);
  const Errors more =
      retain<ClosureStore>(retention, retention.studies, kind == "study" ? used : "", now_ms);
  errors.insert(errors.end(), more.begin(), more.end());
  return errors;
}

}  // namespace

Errors ClosureRetention::operator()(std::int64_t now_ms) const noexcept {
  try {
    return retain_both(*this, "", "", now_ms);
  } catch (const std::exception&) {  // no memory
    return {};
  }
}

Errors ClosureRetention::operator()(const Job& ended, std::int64_t now_ms) const noexcept {
  try {
    const Expected<std::string> subject = subject_of_job(store, ended);
    return retain_both(*this, ended.kind, subject ? *subject : "", now_ms);
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace coapt
