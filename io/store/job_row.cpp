#include "io/store/job_row.h"

#include <sqlite3.h>

namespace coapt {
namespace {

/// Failed, which nobody runs again, if the name is of no state.
JobState state_named(const std::string& name) {
  for (const JobState state :
       {JobState::Queued, JobState::Running, JobState::Succeeded, JobState::Cancelled})
    if (name == to_string(state)) return state;
  return JobState::Failed;
}

}  // namespace

Job job_at(const Statement& row) {
  int column = 0;
  const auto text = [&] { return bytes_at(row, column++); };
  const auto integer = [&] { return std::int64_t{sqlite3_column_int64(row.get(), column++)}; };
  Job job;
  job.number = integer();
  job.id = text();
  job.kind = text();
  job.valve = text();
  job.state = state_named(text());
  job.cancel_requested = integer() != 0;
  job.created_ms = integer();
  job.started_ms = integer();
  job.finished_ms = integer();
  job.seconds = sqlite3_column_double(row.get(), column++);
  job.stalled = static_cast<int>(integer());
  job.kept = integer();
  job.progress = text();
  job.summary = text();
  return job;
}

std::optional<Job> find_job(Transaction& transaction, const std::string& column,
                            const std::string& value) {
  std::optional<Job> found;
  transaction.run(std::string("SELECT ") + kJobColumns +
                      ", request FROM jobs JOIN bodies ON job = number WHERE " + column + " = ?",
                  {value}, [&found](const Statement& row) {
                    found = job_at(row);
                    found->request = bytes_at(row, sqlite3_column_count(row.get()) - 1);
                  });
  return found;
}

void tell_state(Transaction& transaction, const std::string& id, JobState state) {
  const std::string content = std::string("{\"state\": \"") + to_string(state) + "\"}";
  transaction.run(std::string(kInsertEvent), {id, "state", content});
}

}  // namespace coapt
