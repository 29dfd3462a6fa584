#include "io/store/job_store.h"

#include <sqlite3.h>

#include <cassert>
#include <utility>

#include "io/store/job_row.h"
#include "io/store/job_schema.h"
#include "io/store/list_page.h"
#include "io/store/stored_valves.h"

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

const char* to_string(JobState state) {
  switch (state) {
    case JobState::Queued:
      return "QUEUED";
    case JobState::Running:
      return "RUNNING";
    case JobState::Succeeded:
      return "SUCCEEDED";
    case JobState::Failed:
      return "FAILED";
    case JobState::Cancelled:
      return "CANCELLED";
  }
  return "";
}

bool has_ended(JobState state) { return state != JobState::Queued && state != JobState::Running; }

JobStore::JobStore(FileLock lock, StoreDatabase writer, StoreDatabase reader)
    : lock_(std::move(lock)),
      writer_(std::make_unique<StoreConnection>(std::move(writer))),
      reader_(std::make_unique<StoreConnection>(std::move(reader))) {}

Transaction JobStore::writing(const char* problem) const {
  return Transaction(*writer_, Transaction::Kind::Write, problem);
}

Transaction JobStore::reading() const {
  return Transaction(*reader_, Transaction::Kind::Read, "cannot be read");
}

Expected<JobStore> JobStore::open(const std::string& path, int lock_timeout_ms) {
  // The lock comes second: beside what is not a store nothing is made.
  Expected<StoreDatabase> writer = StoreDatabase::open(path, job_format(), lock_timeout_ms);
  if (!writer) return writer.errors();
  Expected<FileLock> lock = FileLock::take(writer->file() + "-lock");
  if (!lock) {
    Errors errors = lock.errors();
    if (errors[0].code == ErrorCode::Busy)
      errors[0].message = path + ": is used by another coapt-server";
    return errors;
  }
  StoreFormat read_only = job_format();
  read_only.settings = "PRAGMA query_only = ON";
  Expected<StoreDatabase> reader = StoreDatabase::open(path, read_only, lock_timeout_ms);
  if (!reader) return reader.errors();
  JobStore store(*std::move(lock), *std::move(writer), *std::move(reader));
  {
    Transaction change = store.writing("cannot be opened");
    add_tables(change);
    if (Errors errors = change.end(); !errors.empty()) return errors;
  }
  Transaction tables(*store.reader_, Transaction::Kind::Read, "cannot be opened");
  look_for_tables(tables);
  if (Errors errors = tables.end(); !errors.empty()) return errors;
  return store;
}

Errors JobStore::check_writable() {
  Transaction change = writing("cannot be written");
  change.run("PRAGMA user_version = " + std::to_string(job_format().schema));
  return change.end();
}

Expected<JobStore::Submitted> JobStore::submit(const NewJob& job, const std::string& valve_document,
                                               std::int64_t now_ms) {
  Transaction change = writing("a job cannot be kept");
  const bool has_key = !job.idempotency_key.empty();
  if (has_key) {
    if (std::optional<Job> known = find_job(change, "idempotency_key", job.idempotency_key))
      return change.end_with(Submitted{*std::move(known), false});
  }
  insert_valve(change, job.valve, valve_document);
  change.run(
      "INSERT INTO jobs (id, idempotency_key, kind, valve, created_ms) VALUES (?, ?, ?, ?, ?)",
      {job.id, has_key ? SqlValue(job.idempotency_key) : SqlValue(nullptr), job.kind, job.valve,
       now_ms});
  change.run("INSERT INTO bodies (job, request) SELECT number, ? FROM jobs WHERE id = ?",
             {Blob{job.request}, job.id});
  if (!job.input.empty())
    change.run("INSERT INTO inputs (job, content) SELECT number, ? FROM jobs WHERE id = ?",
               {Blob{job.input}, job.id});
  tell_state(change, job.id, JobState::Queued);
  std::optional<Job> added = find_job(change, "id", job.id);
  return change.end_with(Submitted{added ? *std::move(added) : Job{}, true});
}

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

Expected<std::optional<Job>> JobStore::job(const std::string& id) const {
  Transaction reads = reading();
  std::optional<Job> found = find_job(reads, "id", id);
  return reads.end_with(std::move(found));
}

Expected<std::optional<Job>> JobStore::job_of_key(const std::string& idempotency_key) const {
  Transaction reads = reading();
  std::optional<Job> found = find_job(reads, "idempotency_key", idempotency_key);
  return reads.end_with(std::move(found));
}

Expected<JobPage> JobStore::page(int size, std::int64_t before,
                                 std::optional<JobState> state) const {
  std::string sql = std::string("SELECT ") + kJobColumns + " FROM jobs WHERE number < ?";
  std::vector<SqlValue> values = {upper_end(before)};
  if (state) {
    sql += " AND state = ?";
    values.emplace_back(to_string(*state));
  }
  JobPage page;
  Transaction reads = reading();
  page.next_before = read_page(reads, sql, std::move(values), size,
                               [&page](const Statement& row) { page.jobs.push_back(job_at(row)); });
  return reads.end_with(std::move(page));
}

Expected<std::vector<Job>> JobStore::unfinished() const {
  std::vector<Job> jobs;
  Transaction reads = reading();
  reads.run(std::string("SELECT ") + kJobColumns +
                " FROM jobs WHERE state IN ('QUEUED', 'RUNNING') ORDER BY number",
            {}, [&jobs](const Statement& row) { jobs.push_back(job_at(row)); });
  return reads.end_with(std::move(jobs));
}

Expected<std::int64_t> JobStore::count(JobState state) const {
  std::int64_t jobs = 0;
  Transaction reads = reading();
  reads.run("SELECT count(*) FROM jobs WHERE state = ?", {to_string(state)},
            [&jobs](const Statement& row) { jobs = sqlite3_column_int64(row.get(), 0); });
  return reads.end_with(jobs);
}

Expected<std::vector<JobEvent>> JobStore::events(const std::string& id, std::int64_t after,
                                                 int most) const {
  std::vector<JobEvent> events;
  Transaction reads = reading();
  reads.run(
      "SELECT number, kind, content FROM events WHERE job = (SELECT number FROM jobs WHERE id = ?) "
      "AND number > ? ORDER BY number LIMIT ?",
      {id, after, most}, [&events](const Statement& row) {
        events.push_back({sqlite3_column_int64(row.get(), 0), bytes_at(row, 1), bytes_at(row, 2)});
      });
  return reads.end_with(std::move(events));
}

Expected<std::optional<std::string>> JobStore::result(const std::string& id) const {
  return bytes_of(reading(),
                  "SELECT result FROM bodies WHERE job = (SELECT number FROM jobs WHERE id = ?) "
                  "AND result IS NOT NULL",
                  {id});
}

Expected<std::vector<JobFileName>> JobStore::files(const std::string& id) const {
  std::vector<JobFileName> files;
  Transaction reads = reading();
  reads.run(
      "SELECT name, type, length(content) FROM files "
      "WHERE job = (SELECT number FROM jobs WHERE id = ?) ORDER BY number",
      {id}, [&files](const Statement& row) {
        files.push_back({bytes_at(row, 0), bytes_at(row, 1), sqlite3_column_int64(row.get(), 2)});
      });
  return reads.end_with(std::move(files));
}

Expected<std::optional<JobFile>> JobStore::file(const std::string& id,
                                                const std::string& name) const {
  std::optional<JobFile> file;
  Transaction reads = reading();
  reads.run(
      "SELECT name, type, content FROM files "
      "WHERE job = (SELECT number FROM jobs WHERE id = ?) AND name = ?",
      {id, name}, [&file](const Statement& row) {
        file = JobFile{bytes_at(row, 0), bytes_at(row, 1), bytes_at(row, 2)};
      });
  return reads.end_with(std::move(file));
}

Expected<std::optional<std::string>> JobStore::input(const std::string& id) const {
  return bytes_of(reading(),
                  "SELECT content FROM inputs WHERE job = (SELECT number FROM jobs WHERE id = ?)",
                  {id});
}

Expected<std::optional<std::string>> JobStore::state(const std::string& id) const {
  return bytes_of(reading(),
                  "SELECT state FROM inputs WHERE state IS NOT NULL AND job = (SELECT number FROM "
                  "jobs WHERE id = ?)",
                  {id});
}

Expected<std::optional<std::string>> JobStore::material(const std::string& id) const {
  return bytes_of(
      reading(), "SELECT content FROM materials WHERE job = (SELECT number FROM jobs WHERE id = ?)",
      {id});
}

}  // namespace coapt
