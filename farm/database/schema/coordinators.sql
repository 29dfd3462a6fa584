-- Runs: asked for, waited for, fetched, given up.

CREATE OR REPLACE FUNCTION coapt_farm.hello() RETURNS bigint
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
  SELECT number::bigint FROM schema_version;
$$;

-- The run, if the login may know of it.
CREATE OR REPLACE FUNCTION coapt_farm.this_run(p_run bigint) RETURNS coapt_farm.run
LANGUAGE plpgsql VOLATILE SET search_path = coapt_farm, pg_temp AS $$
DECLARE found_run run;
BEGIN
  SELECT * INTO found_run FROM run WHERE id = p_run AND may_use(team, session_user);
  IF NOT FOUND THEN
    RAISE EXCEPTION 'there is no run %', p_run USING ERRCODE = 'CF001';
  END IF;
  RETURN found_run;
END $$;

-- Stores a part and names it. In one transaction with add_run(): what no run names may be forgotten.
CREATE OR REPLACE FUNCTION coapt_farm.add_part(p_bytes bytea) RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE name text := encode(sha256(p_bytes), 'hex');
BEGIN
  PERFORM pg_advisory_xact_lock_shared(hashtextextended('coapt_farm.blob', 0));
  INSERT INTO blob (sha256, bytes) VALUES (name, p_bytes) ON CONFLICT DO NOTHING;
  RETURN name;
END $$;

-- What a request is called: the SHA-256 of its kind and of its parts' names, which are SHA-256 of their bytes (farm/work/work.cpp
-- work_id). Made here, so that nobody can ask for one thing by another's name.
CREATE OR REPLACE FUNCTION coapt_farm.work_id_of(p_kind text, p_parts text[]) RETURNS text
LANGUAGE sql STABLE AS $$
  SELECT encode(sha256(convert_to(p_kind || E'\n' || array_to_string(p_parts, E'\n'), 'UTF8')), 'hex');
$$;

-- True for a share of the calls, by random numbers that nobody can know (those of gen_random_uuid() are the system's).
CREATE OR REPLACE FUNCTION coapt_farm.is_drawn(p_share float8) RETURNS boolean
LANGUAGE sql VOLATILE AS $$
  SELECT ('x' || left(gen_random_uuid()::text, 8))::bit(32)::bigint < p_share * 4294967296;
$$;

-- The run of this work, and the work's name. One that was there before goes on: cancelled, it is open again, what failed is tried
-- again, and if more is to be checked than was asked for before, what of it was answered by one login alone is open, too.
CREATE OR REPLACE FUNCTION coapt_farm.add_run(p_revision text, p_kind text, p_parts text[], p_label text, p_team text,
  p_items bigint, p_task_items bigint, p_check_share float8, OUT the_run bigint, OUT the_work text)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE before run;
BEGIN
  IF NOT may_use(p_team, session_user) THEN
    RAISE EXCEPTION '% is no member of coapt_team_%', session_user, p_team USING ERRCODE = 'CF003';
  END IF;
  IF p_kind !~ '^[a-z_]{1,40}$' OR length(p_label) > 1000 OR length(p_revision) > 500
     OR NOT p_items BETWEEN 0 AND 1000000000000 OR NOT p_task_items BETWEEN 1 AND 1000000
     OR p_items / p_task_items > 10000000 OR NOT p_check_share BETWEEN 0 AND 1
     OR EXISTS (SELECT FROM unnest(p_parts) AS part WHERE NOT EXISTS (SELECT FROM blob b WHERE b.sha256 = part)) THEN
    RAISE EXCEPTION 'this is no request for a run' USING ERRCODE = 'CF004';
  END IF;
  the_work := work_id_of(p_kind, p_parts);
  INSERT INTO run (work_id, revision, kind, parts, label, team, items, task_items, check_share)
    VALUES (the_work, p_revision, p_kind, p_parts, p_label, p_team, p_items, p_task_items, p_check_share)
    ON CONFLICT (work_id, revision, team, items, task_items) DO NOTHING RETURNING id INTO the_run;
  IF FOUND THEN
    INSERT INTO task (run, first, n, wants_check)
      SELECT the_run, f, least(p_task_items, p_items - f), is_drawn(p_check_share)
      FROM generate_series(0, p_items - 1, p_task_items) AS f;
    RETURN;
  END IF;
  SELECT * INTO before FROM run WHERE work_id = the_work AND revision = p_revision AND team = p_team AND items = p_items
    AND task_items = p_task_items FOR UPDATE;
  the_run := before.id;
  IF p_check_share > before.check_share THEN
    UPDATE run SET check_share = p_check_share WHERE id = the_run;
    UPDATE task t SET wants_check = true,
        state = CASE WHEN t.state = 'done' AND EXISTS (SELECT FROM result r WHERE r.run = the_run AND r.first = t.first
                                                       AND NOT r.checked) THEN 'open' ELSE t.state END
      WHERE t.run = the_run AND NOT t.wants_check
        AND is_drawn((p_check_share - before.check_share) / (1 - before.check_share));
    UPDATE run SET state = 'open', finished = NULL
      WHERE id = the_run AND state = 'done' AND EXISTS (SELECT FROM task t WHERE t.run = the_run AND t.state = 'open');
  END IF;
  IF before.state IN ('cancelled', 'holes') THEN
    UPDATE task SET state = 'open', tries = 0, losses = 0, unlucky = NULL WHERE task.run = the_run AND state = 'poison';
    UPDATE run SET state = 'open', finished = NULL WHERE id = the_run;
  END IF;
END $$;

-- What a run asks for: its work, kind, revision, and the names of its parts.
CREATE OR REPLACE FUNCTION coapt_farm.request_of(p_run bigint, OUT work_id text, OUT revision text, OUT kind text, OUT parts text)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run);
BEGIN
  work_id := of_run.work_id;
  revision := of_run.revision;
  kind := of_run.kind;
  parts := array_to_string(of_run.parts, ',');
END $$;

CREATE OR REPLACE FUNCTION coapt_farm.part_of(p_run bigint, p_sha256 text) RETURNS bytea
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run);
BEGIN
  RETURN (SELECT b.bytes FROM blob b WHERE b.sha256 = p_sha256 AND p_sha256 = ANY (of_run.parts));
END $$;

-- Rows of result from `p_from` on, in order, each with the name of the work that it answers, of 4 MB or the first that is larger; none: that was all.
CREATE OR REPLACE FUNCTION coapt_farm.result_chunk(p_run bigint, p_from bigint, p_with_holes bigint)
RETURNS TABLE (first bigint, n bigint, work_id text, bytes bytea)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
#variable_conflict use_column
DECLARE
  of_run run := this_run(p_run);
  row_ record;
  total bigint := 0;
BEGIN
  IF of_run.state <> 'done' AND NOT (of_run.state = 'holes' AND p_with_holes <> 0) THEN
    RAISE EXCEPTION 'run % is %', p_run, CASE of_run.state WHEN 'open' THEN 'not done yet' WHEN 'holes' THEN 'done but for holes'
      ELSE of_run.state END USING ERRCODE = 'CF004';
  END IF;
  FOR row_ IN SELECT r.first, r.n, r.bytes FROM result r WHERE r.run = p_run AND r.first >= p_from ORDER BY r.run, r.first LOOP
    first := row_.first;
    n := row_.n;
    work_id := of_run.work_id;
    bytes := row_.bytes;
    RETURN NEXT;
    total := total + length(row_.bytes);
    EXIT WHEN total >= 4000000;
  END LOOP;
END $$;

CREATE OR REPLACE FUNCTION coapt_farm.cancel(p_run bigint) RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run);
BEGIN
  UPDATE run SET state = 'cancelled', finished = clock_timestamp() WHERE id = p_run AND state = 'open';
  UPDATE task SET state = 'open', owner = NULL, lease_until = NULL WHERE run = p_run AND state = 'claimed' AND FOUND;
  RETURN (SELECT state FROM run WHERE id = p_run);
END $$;

-- The run with its answers, parts that no other run names, and workers that went a month ago.
CREATE OR REPLACE FUNCTION coapt_farm.forget(p_run bigint) RETURNS void
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run);
BEGIN
  PERFORM pg_advisory_xact_lock(hashtextextended('coapt_farm.blob', 0));
  PERFORM FROM run WHERE id = p_run AND state = 'open' FOR UPDATE;
  IF FOUND THEN
    RAISE EXCEPTION 'run % is not done yet: cancel it first', p_run USING ERRCODE = 'CF004';
  END IF;
  DELETE FROM task WHERE run = p_run;
  DELETE FROM result WHERE run = p_run;
  DELETE FROM opinion WHERE run = p_run;
  DELETE FROM fault WHERE run = p_run;
  DELETE FROM distrust WHERE run = p_run;
  DELETE FROM run WHERE id = p_run;
  DELETE FROM blob b WHERE b.sha256 = ANY (of_run.parts) AND NOT EXISTS (SELECT FROM run r WHERE b.sha256 = ANY (r.parts));
  DELETE FROM worker w WHERE w.seen < clock_timestamp() - interval '30 days' AND NOT w.barred
    AND NOT EXISTS (SELECT FROM run WHERE state = 'open');
END $$;
