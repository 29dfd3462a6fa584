// What happens to a job: from its start to its end, and its removal.
#include <sqlite3.h>

#include <cassert>

#include "io/store/job_row.h"

namespace coapt {
namespace {

constexpr const char* kUnended = " AND state IN ('QUEUED', 'RUNNING')";

enum class Presence { Missing, Unended, Ended };

Presence presence_of(Transaction& transaction, const std::string& id) {
  Presence presence = Presence::Missing;
  transaction.run(std::string("SELECT id = ?1") + kUnended + " FROM jobs WHERE id = ?1", {id},
                  [&presence](const Statement& row) {
                    presence =
                        sqlite3_column_int(row.get(), 0) != 0 ? Presence::Unended : Presence::Ended;
                  });
  return presence;
}

/// As presence_of(), with a failure if there is none.
Presence find(Transaction& transaction, const std::string& id) {
  const Presence presence = presence_of(transaction, id);
  if (presence == Presence::Missing)
    transaction.refuse(ErrorCode::BadReference, "there is no such job");
  return presence;
}

}  // namespace

Expected<int> JobStore::start(const std::string& id, std::int64_t kept, std::int64_t now_ms) {
  int stalled = 0;
  Transaction change = writing("a job cannot be started");
  if (find(change, id) == Presence::Ended)
    change.refuse(ErrorCode::BadReference, "the job has ended");
  // RUNNING here: its last attempt neither ended nor was suspended, it was killed.
  change.run(
      "UPDATE jobs SET stalled = CASE WHEN state = 'RUNNING' AND kept = ?2 THEN stalled + 1 "
      "ELSE 0 END, kept = ?2, state = 'RUNNING', "
      "started_ms = CASE started_ms WHEN 0 THEN ?3 ELSE started_ms END WHERE id = ?1 RETURNING "
      "stalled",
      {id, kept, now_ms},
      [&stalled](const Statement& row) { stalled = sqlite3_column_int(row.get(), 0); });
  tell_state(change, id, JobState::Running);
  return change.end_with(stalled);
}

Errors JobStore::suspend(const std::string& id, double seconds, const std::string& progress) {
  Transaction change = writing("a job cannot be suspended");
  find(change, id);
  change.run(
      "UPDATE jobs SET state = 'QUEUED', stalled = 0, seconds = ?2, "
      "progress = CASE ?3 WHEN '' THEN progress ELSE ?3 END WHERE id = ?1 AND state = 'RUNNING'",
      {id, seconds, progress});
  if (change.changed() > 0) tell_state(change, id, JobState::Queued);
  return change.end();
}

Errors JobStore::request_cancel(const std::string& id) {
  Transaction change = writing("a job cannot be cancelled");
  find(change, id);
  change.run(std::string("UPDATE jobs SET cancel_requested = 1 WHERE id = ?") + kUnended, {id});
  return change.end();
}

Errors JobStore::keep_state(const std::string& id, const std::string& state) {
  Transaction change = writing("where a job is cannot be kept");
  change.run("UPDATE inputs SET state = ?2 WHERE job = (SELECT number FROM jobs WHERE id = ?1)",
             {id, Blob{state}});
  return change.end();
}

Errors JobStore::finish(const std::string& id, const JobEnd& end, std::int64_t now_ms) {
  assert(has_ended(end.state));
  Transaction change = writing("the end of a job cannot be kept");
  if (find(change, id) != Presence::Unended) return change.end();
  change.run(
      "UPDATE jobs SET state = ?2, finished_ms = ?3, seconds = ?4, summary = ?5, "
      "progress = CASE ?6 WHEN '' THEN progress ELSE ?6 END WHERE id = ?1",
      {id, to_string(end.state), now_ms, end.seconds, end.summary, end.progress});
  if (!end.result.empty())
    change.run("UPDATE bodies SET result = ?2 WHERE job = (SELECT number FROM jobs WHERE id = ?1)",
               {id, Blob{end.result}});
  if (!end.material.empty())
    change.run("INSERT INTO materials (job, content) SELECT number, ?2 FROM jobs WHERE id = ?1",
               {id, Blob{end.material}});
  change.run("DELETE FROM inputs WHERE job = (SELECT number FROM jobs WHERE id = ?1)", {id});
  for (const JobFile& file : end.files)
    change.run(
        "INSERT INTO files (job, name, type, content) SELECT number, ?2, ?3, ?4 FROM jobs "
        "WHERE id = ?1",
        {id, file.name, file.type, Blob{file.content}});
  tell_state(change, id, end.state);
  return change.end();
}

Expected<bool> JobStore::remove(const std::string& id) {
  Transaction change = writing("a job cannot be removed");
  const Presence presence = presence_of(change, id);
  if (presence == Presence::Unended)
    change.refuse(ErrorCode::BadReference, "the job has not ended: cancel it first");
  change.run("DELETE FROM jobs WHERE id = ?", {id});
  return change.end_with(presence == Presence::Ended);
}

Errors JobStore::retain(const Retention& retention, std::int64_t now_ms) {
  constexpr double kDay_ms = 24.0 * 3600.0 * 1000.0;
  const std::int64_t oldest_ms =
      retention.days > 0.0 ? now_ms - static_cast<std::int64_t>(retention.days * kDay_ms) : 0;
  Transaction change = writing("old jobs and valves cannot be removed");
  change.run(
      "DELETE FROM jobs WHERE finished_ms > 0 AND (finished_ms < ?2 OR number <= "
      "(SELECT number FROM jobs WHERE finished_ms > 0 ORDER BY number DESC LIMIT 1 OFFSET ?1))",
      {std::int64_t{retention.jobs}, oldest_ms});
  change.run(
      "DELETE FROM valves WHERE (SELECT count(*) FROM valves) > ?1 AND number <= "
      "(SELECT number FROM valves ORDER BY number DESC LIMIT 1 OFFSET ?1) "
      "AND id NOT IN (SELECT valve FROM jobs) AND id NOT IN (SELECT valve FROM kept_plans)",
      {std::int64_t{retention.valves}});
  return change.end();
}

Expected<std::int64_t> JobStore::add_event(const std::string& id, const std::string& kind,
                                           const std::string& content, double seconds) {
  std::int64_t number = 0;
  Transaction change = writing("an event cannot be kept");
  find(change, id);
  change.run(kInsertEvent, {id, kind, content},
             [&number](const Statement& row) { number = sqlite3_column_int64(row.get(), 0); });
  if (kind == "progress")
    change.run(std::string("UPDATE jobs SET progress = ?2, seconds = ?3 WHERE id = ?1") + kUnended,
               {id, content, seconds});
  return change.end_with(number);
}

}  // namespace coapt
