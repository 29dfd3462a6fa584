// A job as its row in the table of jobs has it.
#pragma once

#include "io/store/job_store.h"

namespace coapt {

/// What job_at() reads, in order.
inline constexpr const char* kJobColumns =
    "number, id, kind, valve, state, cancel_requested, created_ms, started_ms, finished_ms, "
    "seconds, stalled, kept, progress, summary";

/// Appends an event. ?1 id of the job, ?2 kind, ?3 content. A row: the event's number.
inline constexpr const char* kInsertEvent =
    "INSERT INTO events SELECT jobs.number, coalesce((SELECT max(events.number) FROM events "
    "WHERE job = jobs.number), 0) + 1, ?2, ?3 FROM jobs WHERE id = ?1 RETURNING number";

/// With the request; none if no job has `value` in `column`, whose values are unique.
std::optional<Job> find_job(Transaction& transaction, const std::string& column,
                            const std::string& value);

/// Appends the event of a change of state.
void tell_state(Transaction& transaction, const std::string& id, JobState state);

/// Without the request.
Job job_at(const Statement& row);

}  // namespace coapt
