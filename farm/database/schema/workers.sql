-- Who works, and what tasks are out. Only the database's clock counts.

-- A run without a team is for everyone; that of a team for members of the role coapt_team_NAME alone.
CREATE OR REPLACE FUNCTION coapt_farm.may_use(p_team text, p_login text) RETURNS boolean
LANGUAGE sql STABLE AS $$
  SELECT p_team = '' OR EXISTS (SELECT FROM pg_roles WHERE rolname = 'coapt_team_' || p_team
                                AND pg_has_role(p_login, oid, 'MEMBER'));
$$;

-- A worker that has not been heard of for the time of a lease counts as dead.
CREATE OR REPLACE FUNCTION coapt_farm.is_alive(w coapt_farm.worker) RETURNS boolean
LANGUAGE sql VOLATILE AS $$
  SELECT NOT w.gone AND NOT w.barred AND w.seen > clock_timestamp() - w.lease;
$$;

-- Whether the worker may answer the run at all.
CREATE OR REPLACE FUNCTION coapt_farm.may_answer(r coapt_farm.run, w coapt_farm.worker) RETURNS boolean
LANGUAGE sql STABLE SET search_path = coapt_farm, pg_temp AS $$
  SELECT w.revision = r.revision AND may_use(r.team, w.login)
    AND NOT EXISTS (SELECT FROM distrust d WHERE d.run = r.id AND d.login = w.login AND d.name = w.name);
$$;

-- The row of whoever calls. A login cannot act for another's worker.
CREATE OR REPLACE FUNCTION coapt_farm.this_worker(p_worker bigint) RETURNS coapt_farm.worker
LANGUAGE plpgsql VOLATILE SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker;
BEGIN
  SELECT * INTO me FROM worker WHERE id = p_worker AND login = session_user;
  IF NOT FOUND THEN
    RAISE EXCEPTION 'worker % is not known here', p_worker USING ERRCODE = 'CF001';
  END IF;
  IF me.barred THEN
    RAISE EXCEPTION 'worker % is barred: other workers gave other answers to its tasks', me.name USING ERRCODE = 'CF002';
  END IF;
  RETURN me;
END $$;

CREATE OR REPLACE FUNCTION coapt_farm.join_farm(p_name text, p_host text, p_pid int, p_revision text, p_lease_s float8)
RETURNS bigint
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE new_id bigint;
BEGIN
  IF p_lease_s IS NULL OR NOT p_lease_s BETWEEN 0.5 AND 3600 THEN
    RAISE EXCEPTION 'a lease of % s, must be 0.5 to 3600', p_lease_s USING ERRCODE = 'CF004';
  END IF;
  IF length(p_name) > 200 OR length(p_host) > 300 OR length(p_revision) > 500 THEN
    RAISE EXCEPTION 'names of workers have at most 200 letters, machines 300, revisions 500' USING ERRCODE = 'CF004';
  END IF;
  -- Names are each login's own: nobody can have another's barred.
  IF EXISTS (SELECT FROM worker WHERE name = p_name AND login = session_user AND barred) THEN
    RAISE EXCEPTION 'worker % is barred: other workers gave other answers to its tasks', p_name USING ERRCODE = 'CF002';
  END IF;
  INSERT INTO worker (name, login, host, pid, revision, lease)
    VALUES (p_name, session_user, p_host, p_pid, p_revision, make_interval(secs => p_lease_s))
    RETURNING id INTO new_id;
  RETURN new_id;
END $$;

-- Whether another worker is alive that may answer this run and has no opinion on the task yet; with p_login one of another login.
CREATE OR REPLACE FUNCTION coapt_farm.others_alive(me coapt_farm.worker, p_run bigint, p_first bigint, p_login boolean)
RETURNS boolean
LANGUAGE sql VOLATILE SET search_path = coapt_farm, pg_temp AS $$
  SELECT EXISTS (
    SELECT FROM worker w JOIN run r ON r.id = p_run
    WHERE w.id <> me.id AND NOT (p_login AND w.login = me.login) AND w.revision = r.revision
      AND w.seen > clock_timestamp() - interval '1 day' AND is_alive(w) AND may_answer(r, w)
      AND NOT EXISTS (SELECT FROM opinion o WHERE o.run = p_run AND o.first = p_first AND o.worker = w.id));
$$;

-- Whether the worker may take a task that failed in its hands, or that its login has answered: only if no other can. An answer
-- is checked by another login, else by another process of the same, else by itself.
CREATE OR REPLACE FUNCTION coapt_farm.may_take(t coapt_farm.task, me coapt_farm.worker) RETURNS boolean
LANGUAGE plpgsql VOLATILE SET search_path = coapt_farm, pg_temp AS $$
DECLARE mine int; my_logins boolean; my_own boolean;
BEGIN
  SELECT given INTO mine FROM opinion o WHERE o.run = t.run AND o.first = t.first AND o.worker = me.id;
  IF mine >= 2 THEN
    RETURN false;  -- it would say the same for ever
  END IF;
  my_own := mine IS NOT NULL OR t.unlucky IS NOT DISTINCT FROM me.id
    OR EXISTS (SELECT FROM result r WHERE r.run = t.run AND r.first = t.first AND r.worker = me.id);
  my_logins := EXISTS (SELECT FROM result r JOIN worker w ON w.id = r.worker
                       WHERE r.run = t.run AND r.first = t.first AND w.login = me.login)
    OR EXISTS (SELECT FROM opinion o JOIN worker w ON w.id = o.worker
               WHERE o.run = t.run AND o.first = t.first AND w.login = me.login);
  RETURN NOT (my_logins AND others_alive(me, t.run, t.first, true)) AND NOT (my_own AND others_alive(me, t.run, t.first, false));
END $$;

-- Tasks whose lease ran out are open again. A worker that is killed tells nothing, and a machine that is taken back by its
-- owner does so daily: only after ten losses is the task held to be what kills.
CREATE OR REPLACE FUNCTION coapt_farm.expire(p_run bigint) RETURNS void
LANGUAGE sql SET search_path = coapt_farm, pg_temp AS $$
  WITH late AS (
    SELECT t.run, t.first, t.owner FROM task t
    WHERE t.run = p_run AND t.state = 'claimed' AND t.lease_until < clock_timestamp()
    FOR UPDATE SKIP LOCKED),
  opened AS (
    UPDATE task t SET state = CASE WHEN t.losses >= 9 THEN 'poison' ELSE 'open' END, losses = t.losses + 1,
      owner = NULL, lease_until = NULL, unlucky = late.owner, last_error = 'the worker was lost'
    FROM late WHERE t.run = late.run AND t.first = late.first
    RETURNING t.run, t.first, late.owner, t.losses)
  INSERT INTO fault (run, first, worker, what, detail)
    SELECT o.run, o.first, o.owner, 'lost', 'lease ran out, ' || o.losses || ' of 10' FROM opened o;
$$;

-- A run ends when nothing of it is open or out. Looked at by those that find nothing to do, and by those that wait.
CREATE OR REPLACE FUNCTION coapt_farm.end_run(p_run bigint) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
BEGIN
  IF EXISTS (SELECT FROM task WHERE task.run = p_run AND state = 'open')
     OR EXISTS (SELECT FROM task WHERE task.run = p_run AND state = 'claimed') THEN
    RETURN;
  END IF;
  -- Whoever opens tasks that were done holds the run's row: look again once it is ours.
  PERFORM FROM run WHERE id = p_run AND state = 'open' FOR UPDATE;
  IF FOUND THEN
    UPDATE run SET finished = clock_timestamp(),
      state = CASE WHEN EXISTS (SELECT FROM task WHERE task.run = p_run AND task.state = 'poison') THEN 'holes' ELSE 'done' END
    WHERE id = p_run
      AND NOT EXISTS (SELECT FROM task WHERE task.run = p_run AND task.state = 'open')
      AND NOT EXISTS (SELECT FROM task WHERE task.run = p_run AND task.state = 'claimed');
  END IF;
END $$;

-- Up to p_most tasks, the oldest run first; a worker holds 16 at most. A claim that a crash of the database forgets is only an open task, so it need not
-- wait for the disk. The planner, which may never have seen the table filled, is told to follow the index of open tasks.
CREATE OR REPLACE FUNCTION coapt_farm.claim(p_worker bigint, p_most bigint)
RETURNS TABLE (run bigint, first bigint, n bigint, kind text, parts text)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp
SET enable_seqscan = off SET enable_bitmapscan = off SET enable_sort = off AS $$
#variable_conflict use_column
DECLARE
  me worker := this_worker(p_worker);
  r run;
  wanted bigint := p_most;  -- at most what is left of 16
  got bigint;
BEGIN
  PERFORM set_config('synchronous_commit', 'off', true);
  UPDATE worker SET seen = clock_timestamp() WHERE id = me.id AND seen < clock_timestamp() - interval '1 s';
  wanted := least(wanted, 16 - (SELECT count(*) FROM task t WHERE t.owner = me.id AND t.state = 'claimed'));
  IF wanted <= 0 THEN
    RETURN;
  END IF;
  FOR r IN SELECT * FROM run WHERE state = 'open' AND revision = me.revision ORDER BY id LOOP
    CONTINUE WHEN NOT may_answer(r, me);
    IF EXISTS (SELECT FROM task t WHERE t.run = r.id AND t.state = 'claimed' AND t.lease_until < clock_timestamp()) THEN
      PERFORM expire(r.id);
    END IF;
    RETURN QUERY
      WITH free AS (
        SELECT t.run, t.first FROM task t
        WHERE t.run = r.id AND t.state = 'open'
          AND ((t.answers = 0 AND t.unlucky IS NULL) OR may_take(t, me))
        ORDER BY t.run, t.first LIMIT wanted FOR UPDATE SKIP LOCKED)
      UPDATE task t SET state = 'claimed', owner = me.id, lease_until = clock_timestamp() + me.lease
      FROM free WHERE t.run = free.run AND t.first = free.first
      RETURNING t.run, t.first, t.n::bigint, r.kind, array_to_string(r.parts, ',');
    GET DIAGNOSTICS got = ROW_COUNT;
    wanted := wanted - got;
    EXIT WHEN wanted <= 0;
    IF got = 0 THEN
      PERFORM end_run(r.id);
    END IF;
  END LOOP;
END $$;

-- The leases of these tasks, where they are still the worker's; how many are. As claims are, it is not waited for.
CREATE OR REPLACE FUNCTION coapt_farm.renew(p_worker bigint, p_runs bigint[], p_firsts bigint[]) RETURNS bigint
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker := this_worker(p_worker); kept bigint;
BEGIN
  PERFORM set_config('synchronous_commit', 'off', true);
  UPDATE worker SET seen = clock_timestamp() WHERE id = me.id;
  UPDATE task t SET lease_until = clock_timestamp() + me.lease
    FROM unnest(p_runs, p_firsts) AS held (run, first)
    WHERE t.run = held.run AND t.first = held.first AND t.owner = me.id AND t.state = 'claimed';
  GET DIAGNOSTICS kept = ROW_COUNT;
  RETURN kept;
END $$;

-- Open again, at no one's fault.
CREATE OR REPLACE FUNCTION coapt_farm.give_back(p_worker bigint, p_runs bigint[], p_firsts bigint[]) RETURNS void
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker := this_worker(p_worker);
BEGIN
  UPDATE task t SET state = 'open', owner = NULL, lease_until = NULL
    FROM unnest(p_runs, p_firsts) AS held (run, first)
    WHERE t.run = held.run AND t.first = held.first AND t.owner = me.id AND t.state = 'claimed';
END $$;

CREATE OR REPLACE FUNCTION coapt_farm.leave_farm(p_worker bigint) RETURNS void
LANGUAGE sql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
  UPDATE worker SET gone = true, seen = clock_timestamp() WHERE id = p_worker AND login = session_user;
$$;

-- A part of a run's request, for a worker that holds a task of the run.
CREATE OR REPLACE FUNCTION coapt_farm.read_part(p_worker bigint, p_run bigint, p_sha256 text) RETURNS bytea
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker := this_worker(p_worker); found_bytes bytea;
BEGIN
  SELECT b.bytes INTO found_bytes FROM blob b JOIN run r ON r.id = p_run AND p_sha256 = ANY (r.parts)
    WHERE b.sha256 = p_sha256 AND may_answer(r, me)
      AND EXISTS (SELECT FROM task t WHERE t.run = p_run AND t.state = 'claimed' AND t.owner = me.id
                  AND t.lease_until > clock_timestamp());
  IF NOT FOUND THEN
    RAISE EXCEPTION 'a part of run % is read only while a task of it is claimed', p_run USING ERRCODE = 'CF003';
  END IF;
  RETURN found_bytes;
END $$;

-- {"mine": open runs that the worker may answer, "others": [{"revision", "runs"}]}: what a worker that finds no task waits for.
CREATE OR REPLACE FUNCTION coapt_farm.waiting(p_worker bigint) RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker := this_worker(p_worker);
BEGIN
  RETURN json_build_object(
    'mine', (SELECT count(*) FROM run WHERE state = 'open' AND revision = me.revision AND may_answer(run, me)),
    'others', (SELECT coalesce(json_agg(o), '[]') FROM (
      SELECT revision, count(*) AS runs FROM run
      WHERE state = 'open' AND revision <> me.revision AND may_use(team, me.login) GROUP BY revision ORDER BY revision) AS o));
END $$;
