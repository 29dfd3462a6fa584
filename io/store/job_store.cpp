#include "io/store/job_store.h"

#include <array>
#include <utility>

#include "io/store/job_row.h"

namespace coapt {
namespace {

// What may be large lies in tables of its own: a row is written anew with each change of a job.
constexpr StoreFormat kJobFormat = {.application = 0x636f6a62,  // "cojb"
                                    .schema = 1,
                                    .rows = "jobs",
                                    .tables = R"(
CREATE TABLE valves (
  number INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE,
  document BLOB NOT NULL
) STRICT;
CREATE TABLE jobs (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  idempotency_key TEXT UNIQUE,
  kind TEXT NOT NULL,
  valve TEXT NOT NULL REFERENCES valves (id),
  state TEXT NOT NULL DEFAULT 'QUEUED'
    CHECK (state IN ('QUEUED', 'RUNNING', 'SUCCEEDED', 'FAILED', 'CANCELLED')),
  cancel_requested INTEGER NOT NULL DEFAULT 0,
  created_ms INTEGER NOT NULL,
  started_ms INTEGER NOT NULL DEFAULT 0,   -- 0: not yet
  finished_ms INTEGER NOT NULL DEFAULT 0,  -- likewise
  seconds REAL NOT NULL DEFAULT 0,
  stalled INTEGER NOT NULL DEFAULT 0,
  kept INTEGER NOT NULL DEFAULT 0,
  progress TEXT NOT NULL DEFAULT '',
  summary TEXT NOT NULL DEFAULT ''
) STRICT;
CREATE INDEX jobs_by_valve ON jobs (valve);
CREATE INDEX jobs_by_state ON jobs (state, number);
CREATE TABLE bodies (
  job INTEGER PRIMARY KEY REFERENCES jobs ON DELETE CASCADE,
  request BLOB NOT NULL,
  result BLOB  -- NULL: none
) STRICT;
CREATE TABLE files (
  number INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
  name TEXT NOT NULL,
  type TEXT NOT NULL,
  content BLOB NOT NULL,
  UNIQUE (job, name)
) STRICT;
CREATE TABLE events (
  job INTEGER REFERENCES jobs ON DELETE CASCADE,
  number INTEGER,  -- from 1 in each job
  kind TEXT NOT NULL,
  content TEXT NOT NULL,
  PRIMARY KEY (job, number)
) STRICT, WITHOUT ROWID;
)",
                                    .settings =
                                        "PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;"
                                        "PRAGMA journal_size_limit = 67108864",  // bytes
                                    .tells_causes = true};

// Made in files of an earlier coapt, too; one that does not know them leaves them alone.
constexpr const char* kMaterials = R"(CREATE TABLE IF NOT EXISTS materials (
  job INTEGER PRIMARY KEY REFERENCES jobs ON DELETE CASCADE,
  content BLOB NOT NULL
) STRICT)";
constexpr const char* kInputs = R"(CREATE TABLE IF NOT EXISTS inputs (
  job INTEGER PRIMARY KEY REFERENCES jobs ON DELETE CASCADE,
  content BLOB NOT NULL,
  state BLOB  -- NULL: none yet
) STRICT)";
constexpr std::array kAddedTables = {
    // What lists say, so that they need not read the documents.
    R"(CREATE TABLE valve_summaries (
  valve INTEGER PRIMARY KEY REFERENCES valves ON DELETE CASCADE,
  name TEXT NOT NULL,
  vertices INTEGER NOT NULL,
  triangles INTEGER NOT NULL
) STRICT)",
    R"(CREATE TABLE kept_plans (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  valve TEXT NOT NULL,  -- id of a stored valve, or a preset's name
  plan TEXT NOT NULL
) STRICT)",
    "CREATE INDEX kept_plans_by_valve ON kept_plans (valve, number)"};

/// Of all valves that have no summary yet. What is no valve has an empty one.
void summarise_valves(Transaction& change) {
  change.run(R"(INSERT INTO valve_summaries
SELECT number, coalesce(json_extract(document, '$.name'), ''),
  coalesce(json_array_length(document, '$.vertices_mm'), 0), coalesce(json_array_length(document, '$.faces'), 0)
FROM (SELECT number, iif(json_valid(CAST(document AS TEXT)), CAST(document AS TEXT), '{}') AS document FROM valves
  WHERE NOT EXISTS (SELECT 1 FROM valve_summaries WHERE valve = number)))");
}

// Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's.
constexpr const char* kInsertValve =
    "INSERT INTO valves (id, document) VALUES (?, ?) ON CONFLICT DO NOTHING";

}  // namespace

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
  Expected<StoreDatabase> writer = StoreDatabase::open(path, kJobFormat, lock_timeout_ms);
  if (!writer) return writer.errors();
  Expected<FileLock> lock = FileLock::take(writer->file() + "-lock");
  if (!lock) {
    Errors errors = lock.errors();
    if (errors[0].code == ErrorCode::Busy)
      errors[0].message = path + ": is used by another coapt-server";
    return errors;
  }
  StoreFormat read_only = kJobFormat;
  read_only.settings = "PRAGMA query_only = ON";
  Expected<StoreDatabase> reader = StoreDatabase::open(path, read_only, lock_timeout_ms);
  if (!reader) return reader.errors();
  JobStore store(*std::move(lock), *std::move(writer), *std::move(reader));
  if (Errors errors = store.add_tables(); !errors.empty()) return errors;
  Transaction tables(*store.reader_, Transaction::Kind::Read, "cannot be opened");
  tables.run(
      "SELECT 1 FROM valves, jobs, bodies, files, events, valve_summaries, kept_plans, "
      "materials, inputs LIMIT 0");
  if (Errors errors = tables.end(); !errors.empty()) return errors;
  return store;
}

Errors JobStore::add_tables() {
  Transaction change = writing("cannot be opened");
  change.run(kMaterials);
  change.run(kInputs);
  bool are_there = false;
  change.run("SELECT 1 FROM sqlite_schema WHERE name = 'kept_plans'", {},
             [&are_there](const Statement&) { are_there = true; });
  if (are_there) return change.end();
  for (const char* table : kAddedTables) change.run(table);
  summarise_valves(change);
  return change.end();
}

Expected<bool> JobStore::add_valve(const std::string& id, const std::string& document) {
  Transaction change = writing("a valve cannot be kept");
  change.run(kInsertValve, {id, Blob{document}});
  const bool is_new = change.changed() == 1;
  if (is_new) summarise_valves(change);
  return change.end_with(is_new);
}

Expected<bool> JobStore::remove_valve(const std::string& id) {
  Transaction change = writing("a valve cannot be removed");
  change.run("SELECT 1 FROM jobs WHERE valve = ? LIMIT 1", {id}, [&change](const Statement&) {
    change.refuse(ErrorCode::BadReference, "jobs refer to the valve: remove them first");
  });
  change.run("SELECT 1 FROM kept_plans WHERE valve = ? LIMIT 1", {id}, [&change](const Statement&) {
    change.refuse(ErrorCode::BadReference, "kept plans refer to the valve: remove them first");
  });
  change.run("DELETE FROM valves WHERE id = ?", {id});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

Expected<JobStore::Submitted> JobStore::submit(const NewJob& job, const std::string& valve_document,
                                               std::int64_t now_ms) {
  Transaction change = writing("a job cannot be kept");
  const bool has_key = !job.idempotency_key.empty();
  if (has_key) {
    if (std::optional<Job> known = find_job(change, "idempotency_key", job.idempotency_key))
      return change.end_with(Submitted{*std::move(known), false});
  }
  change.run(kInsertValve, {job.valve, Blob{valve_document}});
  if (change.changed() == 1) summarise_valves(change);
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

Errors JobStore::check_writable() {
  Transaction change = writing("cannot be written");
  change.run("PRAGMA user_version = " + std::to_string(kJobFormat.schema));
  return change.end();
}

}  // namespace coapt
