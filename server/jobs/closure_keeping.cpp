#include "server/jobs/closure_keeping.h"

#include <stdexcept>

#include "io/json/valve_json.h"
#include "io/store/stored_valves.h"

namespace coapt {
namespace {

// Attempts in a row that a job may kill. A machine that is started again five times within the minutes that a fit takes to keep
// something is no fault of the fit.
constexpr int kMostStalled = 10;

}  // namespace

Expected<Valve> valve_of(const JobStore& store, const Job& job) {
  const Expected<std::optional<std::string>> document = stored_valve(store, job.valve);
  if (!document) return document.errors();
  if (!*document) return Error{ErrorCode::BadReference, "/valve", "is no longer stored"};
  return read_valve(**document);
}

std::optional<JobEnd> begin(JobBoard& board, RunningJob& job, std::int64_t known) {
  int stalled = 0;
  if (!board.start(job, known, stalled)) throw std::runtime_error(kJobStops);
  if (stalled < kMostStalled) return std::nullopt;
  return failed(
      job, {Error{ErrorCode::Unsupported, "",
                  "the server was ended " + std::to_string(stalled) +
                      " times in a row while running this job, before a new closure was stored"}});
}

void keep_closure(JobBoard& board, RunningJob& job, const std::function<Errors()>& keep) {
  if (!board.persist(job, keep)) throw std::runtime_error(kJobStops);
  if (job.job.cancel_requested) {
    job.cancel_asked = true;
    job.cancelled = true;
  }
}

}  // namespace coapt
