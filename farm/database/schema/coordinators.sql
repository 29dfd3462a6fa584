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

-- Whether a task is among the share that is computed twice: by its number and what is asked, the same every time.
CREATE OR REPLACE FUNCTION coapt_farm.is_checked(p_work_id text, p_first bigint, p_share float8) RETURNS boolean
LANGUAGE sql IMMUTABLE AS $$
  SELECT ('x' || left(encode(sha256(convert_to(p_work_id || ':' || p_first, 'UTF8')), 'hex'), 8))::bit(32)::bigint
         < p_share * 4294967296;
$$;

-- The run of this work. One that was there before goes on: cancelled, it is open again, and what failed is tried again.
CREATE OR REPLACE FUNCTION coapt_farm.add_run(p_work_id text, p_revision text, p_kind text, p_parts text[], p_label text,
  p_team text, p_items bigint, p_task_items bigint, p_check_share float8) RETURNS bigint
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE the_run bigint; was text;
BEGIN
  IF NOT may_use(p_team, session_user) THEN
    RAISE EXCEPTION '% is no member of coapt_team_%', session_user, p_team USING ERRCODE = 'CF003';
  END IF;
  INSERT INTO run (work_id, revision, kind, parts, label, team, items, task_items, check_share)
    VALUES (p_work_id, p_revision, p_kind, p_parts, p_label, p_team, p_items, p_task_items, p_check_share)
    ON CONFLICT (work_id, revision, team) DO NOTHING RETURNING id INTO the_run;
  IF FOUND THEN
    INSERT INTO task (run, first, n, wants_check)
      SELECT the_run, f, least(p_task_items, p_items - f), is_checked(p_work_id, f, p_check_share)
      FROM generate_series(0, p_items - 1, p_task_items) AS f;
    RETURN the_run;
  END IF;
  SELECT id, state INTO the_run, was FROM run
    WHERE work_id = p_work_id AND revision = p_revision AND team = p_team FOR UPDATE;
  IF was IN ('cancelled', 'holes') THEN
    UPDATE task SET state = 'open', tries = 0, losses = 0, unlucky = NULL WHERE run = the_run AND state = 'poison';
    UPDATE run SET state = 'open', finished = NULL WHERE id = the_run;
  END IF;
  RETURN the_run;
END $$;

-- Rows of result from `p_after` on, in order, of 4 MB or the first that is larger; none: that was all.
CREATE OR REPLACE FUNCTION coapt_farm.result_chunk(p_run bigint, p_from bigint, p_with_holes bigint)
RETURNS TABLE (first bigint, n bigint, bytes bytea)
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
  DELETE FROM run WHERE id = p_run;
  DELETE FROM blob b WHERE b.sha256 = ANY (of_run.parts) AND NOT EXISTS (SELECT FROM run r WHERE b.sha256 = ANY (r.parts));
  DELETE FROM worker w WHERE w.seen < clock_timestamp() - interval '30 days' AND NOT w.barred
    AND NOT EXISTS (SELECT FROM run WHERE state = 'open');
END $$;
