#include "io/store/job_schema.h"

#include <array>

#include "io/store/stored_valves.h"

namespace coapt {
namespace {

// What may be large lies in tables of its own: a row is written anew with each change of a job.
constexpr StoreFormat kFormat = {.application = 0x636f6a62,  // "cojb"
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

}  // namespace

StoreFormat job_format() { return kFormat; }

void add_tables(Transaction& change) {
  change.run(kMaterials);
  change.run(kInputs);
  bool are_there = false;
  change.run("SELECT 1 FROM sqlite_schema WHERE name = 'kept_plans'", {},
             [&are_there](const Statement&) { are_there = true; });
  if (are_there) return;
  for (const char* table : kAddedTables) change.run(table);
  summarise_valves(change);
}

void look_for_tables(Transaction& reads) {
  reads.run(
      "SELECT 1 FROM valves, jobs, bodies, files, events, valve_summaries, kept_plans, "
      "materials, inputs LIMIT 0");
}

}  // namespace coapt
