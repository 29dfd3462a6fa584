-- The database of a farm: what is asked for, what is left to do, what was answered. Run as a whole, by `coapt-farm init`; it may
-- be run again.
--
-- No foreign keys and no counters in rows that many touch: the rows of run would be locked by every answer.

SELECT pg_advisory_xact_lock(hashtextextended('coapt_farm.init', 0));

CREATE SCHEMA IF NOT EXISTS coapt_farm;

CREATE TABLE IF NOT EXISTS coapt_farm.schema_version (number int NOT NULL);
INSERT INTO coapt_farm.schema_version
  SELECT @COAPT_FARM_SCHEMA_VERSION@ WHERE NOT EXISTS (SELECT FROM coapt_farm.schema_version);
UPDATE coapt_farm.schema_version SET number = @COAPT_FARM_SCHEMA_VERSION@;

-- Parts of requests, each once. The name is their SHA-256 in hexadecimal digits.
CREATE TABLE IF NOT EXISTS coapt_farm.blob (
  sha256 text PRIMARY KEY,
  bytes bytea NOT NULL
);

CREATE TABLE IF NOT EXISTS coapt_farm.run (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  work_id text NOT NULL,    -- of the request, made here (work_id_of)
  revision text NOT NULL,   -- of the program that asked: no other may answer
  kind text NOT NULL,
  parts text[] NOT NULL,    -- names of blobs
  label text NOT NULL,
  team text NOT NULL,       -- '': any worker may answer
  items bigint NOT NULL,
  task_items int NOT NULL,
  check_share float8 NOT NULL,
  state text NOT NULL DEFAULT 'open' CHECK (state IN ('open', 'done', 'holes', 'cancelled')),
  created timestamptz NOT NULL DEFAULT clock_timestamp(),
  finished timestamptz,
  UNIQUE (work_id, revision, team, items, task_items)
);
CREATE INDEX IF NOT EXISTS run_open ON coapt_farm.run (id) WHERE state = 'open';

-- Items [first, first + n) of a run. Open tasks and those that are out have an index each, so that both stay as small as what
-- is left to do.
CREATE TABLE IF NOT EXISTS coapt_farm.task (
  run bigint NOT NULL,
  first bigint NOT NULL,
  n int NOT NULL,
  tries smallint NOT NULL DEFAULT 0,    -- that ended in a failure that the worker told
  losses smallint NOT NULL DEFAULT 0,   -- leases that ran out
  answers smallint NOT NULL DEFAULT 0,  -- 1: in result; 2 and more: they differ and are in opinion
  wants_check boolean NOT NULL,         -- computed twice, by workers of two logins; drawn here, told to nobody
  state text NOT NULL DEFAULT 'open' CHECK (state IN ('open', 'claimed', 'done', 'poison')),
  owner bigint,
  lease_until timestamptz,
  unlucky bigint,                       -- the worker that failed or lost it last
  last_error text,
  PRIMARY KEY (run, first)
) WITH (autovacuum_vacuum_scale_factor = 0.02, autovacuum_vacuum_cost_delay = 0);
CREATE INDEX IF NOT EXISTS task_open ON coapt_farm.task (run, first) WHERE state = 'open';
CREATE INDEX IF NOT EXISTS task_claimed ON coapt_farm.task (run, lease_until) WHERE state = 'claimed';
CREATE INDEX IF NOT EXISTS task_owner ON coapt_farm.task (owner) WHERE state = 'claimed';
CREATE INDEX IF NOT EXISTS task_poison ON coapt_farm.task (run, first) WHERE state = 'poison';

-- An answer that stands.
CREATE TABLE IF NOT EXISTS coapt_farm.result (
  run bigint NOT NULL,
  first bigint NOT NULL,
  n int NOT NULL,
  checked boolean NOT NULL DEFAULT false,  -- workers of two logins gave it
  worker bigint NOT NULL,
  seconds float4 NOT NULL,
  at timestamptz NOT NULL DEFAULT clock_timestamp(),
  bytes bytea NOT NULL,
  PRIMARY KEY (run, first)
);
-- Rows come in the order of time: a few bytes for a thousand of them.
CREATE INDEX IF NOT EXISTS result_at ON coapt_farm.result USING brin (at) WITH (pages_per_range = 32, autosummarize = on);

-- Answers of a task that differ, until two logins agree.
CREATE TABLE IF NOT EXISTS coapt_farm.opinion (
  run bigint NOT NULL,
  first bigint NOT NULL,
  worker bigint NOT NULL,
  given int NOT NULL DEFAULT 1,  -- how often by this worker
  seconds float4 NOT NULL,
  bytes bytea NOT NULL,
  PRIMARY KEY (run, first, worker)
);

CREATE TABLE IF NOT EXISTS coapt_farm.worker (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  name text NOT NULL,
  login text NOT NULL,
  host text NOT NULL,
  pid int NOT NULL,
  revision text NOT NULL,
  lease interval NOT NULL,
  started timestamptz NOT NULL DEFAULT clock_timestamp(),
  seen timestamptz NOT NULL DEFAULT clock_timestamp(),
  gone boolean NOT NULL DEFAULT false,  -- it said good-bye
  tasks bigint NOT NULL DEFAULT 0,
  items bigint NOT NULL DEFAULT 0,
  seconds float8 NOT NULL DEFAULT 0,    -- in computing
  barred boolean NOT NULL DEFAULT false
) WITH (fillfactor = 50);
CREATE INDEX IF NOT EXISTS worker_name ON coapt_farm.worker (name);

CREATE TABLE IF NOT EXISTS coapt_farm.fault (
  id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  run bigint,
  first bigint,
  worker bigint,
  what text NOT NULL CHECK (what IN ('failed', 'lost', 'differs', 'barred')),
  detail text NOT NULL,
  at timestamptz NOT NULL DEFAULT clock_timestamp()
);
CREATE INDEX IF NOT EXISTS fault_run ON coapt_farm.fault (run);

-- Who answers a run no more: whoever asked found an answer of theirs to be wrong.
CREATE TABLE IF NOT EXISTS coapt_farm.distrust (
  run bigint NOT NULL,
  login text NOT NULL,
  name text NOT NULL,
  PRIMARY KEY (run, login, name)
);

-- From version 1, where callers told what their work is called, and two lists of items could be one run.
ALTER TABLE coapt_farm.run DROP CONSTRAINT IF EXISTS run_work_id_revision_team_key;
DROP FUNCTION IF EXISTS coapt_farm.add_run(text, text, text, text[], text, text, bigint, bigint, float8),
  coapt_farm.finish(bigint, bigint, bigint, float8, bytea), coapt_farm.is_checked(text, bigint, float8),
  coapt_farm.result_chunk(bigint, bigint, bigint), coapt_farm.others_alive(bigint, bigint, bigint),
  coapt_farm.may_take(coapt_farm.task, bigint), coapt_farm.workers_of(text, text);
DO $$ BEGIN
  IF NOT EXISTS (SELECT FROM pg_constraint WHERE conname = 'run_work_id_revision_team_items_task_items_key') THEN
    ALTER TABLE coapt_farm.run ADD UNIQUE (work_id, revision, team, items, task_items);
  END IF;
END $$;
