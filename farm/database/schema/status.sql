-- What is told of runs and workers. Counts are of what is left to do, by its indexes; rates of the last minute.

-- Items that are not settled yet, by what they wait for.
CREATE OR REPLACE FUNCTION coapt_farm.left_of(p_run bigint, OUT items_left bigint, OUT tasks_open bigint,
  OUT tasks_claimed bigint, OUT tasks_poison bigint, OUT tasks_disputed bigint, OUT items_poison bigint)
LANGUAGE sql STABLE SET search_path = coapt_farm, pg_temp AS $$
  SELECT coalesce(sum(n), 0)::bigint, count(*) FILTER (WHERE state = 'open'), count(*) FILTER (WHERE state = 'claimed'),
         count(*) FILTER (WHERE state = 'poison'), count(*) FILTER (WHERE answers >= 2),
         coalesce(sum(n) FILTER (WHERE state = 'poison'), 0)::bigint
  FROM (SELECT n, state, answers FROM task WHERE run = p_run AND state = 'open'
        UNION ALL SELECT n, state, answers FROM task WHERE run = p_run AND state = 'claimed'
        UNION ALL SELECT n, state, answers FROM task WHERE run = p_run AND state = 'poison') AS unsettled;
$$;

-- Items a second by run and worker in the last minute, or since the first answer in it.
CREATE OR REPLACE FUNCTION coapt_farm.rates() RETURNS TABLE (run bigint, worker bigint, per_s float8)
LANGUAGE sql STABLE SET search_path = coapt_farm, pg_temp AS $$
  WITH recent AS (SELECT r.run, r.worker, r.n, r.at FROM result r WHERE r.at > clock_timestamp() - interval '60 s'),
  span AS (SELECT greatest(1.0, extract(epoch FROM clock_timestamp() - min(at)))::float8 AS s FROM recent)
  SELECT recent.run, recent.worker, sum(n) / max(span.s) FROM recent, span GROUP BY recent.run, recent.worker;
$$;

-- Workers that may answer a run and are alive.
CREATE OR REPLACE FUNCTION coapt_farm.workers_of(r coapt_farm.run) RETURNS bigint
LANGUAGE sql VOLATILE SET search_path = coapt_farm, pg_temp AS $$
  SELECT count(*) FROM worker w WHERE w.revision = r.revision AND w.seen > clock_timestamp() - interval '1 day'
    AND is_alive(w) AND may_answer(r, w);
$$;

CREATE OR REPLACE FUNCTION coapt_farm.poisoned(p_run bigint) RETURNS json
LANGUAGE sql STABLE SET search_path = coapt_farm, pg_temp AS $$
  SELECT coalesce(json_agg(json_build_object('first', p.first, 'items', p.n, 'error', p.last_error)), '[]')
  FROM (SELECT first, n, last_error FROM task WHERE run = p_run AND state = 'poison' ORDER BY first LIMIT 20) AS p;
$$;

-- One run, for those that wait for it; ends it if nothing is left.
CREATE OR REPLACE FUNCTION coapt_farm.progress(p_run bigint) RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE r run := this_run(p_run); rest record; rate float8;
BEGIN
  IF r.state = 'open' THEN
    PERFORM expire(r.id);
    PERFORM end_run(r.id);
    r := this_run(p_run);
  END IF;
  SELECT * INTO rest FROM left_of(r.id);
  SELECT coalesce(sum(per_s), 0) INTO rate FROM rates() WHERE run = r.id;
  RETURN json_build_object('run', r.id, 'state', r.state, 'done', r.items - rest.items_left, 'items', r.items,
    'workers', workers_of(r), 'rate_per_s', rate,
    'eta_s', CASE WHEN rate > 0 THEN rest.items_left / rate END,
    'tasks_disputed', rest.tasks_disputed, 'tasks_poison', rest.tasks_poison,
    'poison', CASE WHEN rest.tasks_poison > 0 THEN poisoned(r.id) ELSE '[]' END,
    'faults', (SELECT count(*) FROM fault f WHERE f.run = r.id AND f.what = 'differs'));
END $$;

-- coapt.farm/1: runs, newest first (open ones, and 50 others), workers of the last day, and what went wrong last.
CREATE OR REPLACE FUNCTION coapt_farm.status() RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE r run; rest record; rate float8; runs json[] := '{}'; alive bigint;
BEGIN
  FOR r IN SELECT * FROM run WHERE may_use(team, session_user) AND (state = 'open' OR id > (SELECT coalesce(max(id), 0) - 50 FROM run))
           ORDER BY id DESC LOOP
    IF r.state = 'open' THEN
      PERFORM end_run(r.id);
      r := this_run(r.id);
    END IF;
    SELECT * INTO rest FROM left_of(r.id);
    SELECT coalesce(sum(per_s), 0) INTO rate FROM rates() WHERE run = r.id;
    alive := workers_of(r);
    runs := runs || json_build_object('run', r.id, 'label', r.label, 'kind', r.kind, 'team', r.team, 'state', r.state,
      'created', r.created, 'finished', r.finished, 'revision', r.revision, 'work_id', r.work_id,
      'done', r.items - rest.items_left, 'items', r.items, 'task_items', r.task_items,
      'tasks_open', rest.tasks_open, 'tasks_claimed', rest.tasks_claimed,
      'tasks_poison', rest.tasks_poison, 'tasks_disputed', rest.tasks_disputed, 'poison', poisoned(r.id),
      'workers', alive, 'waits_for_workers', r.state = 'open' AND alive = 0, 'rate_per_s', rate,
      'eta_s', CASE WHEN rate > 0 AND r.state = 'open' THEN rest.items_left / rate END);
  END LOOP;
  RETURN json_build_object('schema', 'coapt.farm/1', 'runs', to_json(runs),
    'workers', (SELECT coalesce(json_agg(json_build_object('name', w.name, 'host', w.host, 'pid', w.pid, 'login', w.login,
        'revision', w.revision, 'alive', is_alive(w), 'barred', w.barred, 'started', w.started,
        'seen_s', extract(epoch FROM clock_timestamp() - w.seen), 'tasks', w.tasks, 'items', w.items, 'seconds', w.seconds,
        'rate_per_s', (SELECT coalesce(sum(per_s), 0) FROM rates() x WHERE x.worker = w.id)) ORDER BY w.id), '[]')
      FROM worker w WHERE w.barred OR w.seen > clock_timestamp() - interval '1 day'),
    'faults', (SELECT coalesce(json_agg(json_build_object('run', f.run, 'first', f.first, 'worker', f.name, 'what', f.what,
        'detail', f.detail, 'at', f.at)), '[]')
      FROM (SELECT fault.*, w.name FROM fault LEFT JOIN worker w ON w.id = fault.worker JOIN run ON run.id = fault.run
            WHERE may_use(run.team, session_user) ORDER BY fault.id DESC LIMIT 50) AS f),
    'faults_total', (SELECT json_object_agg(what, n) FROM (SELECT what, count(*) AS n FROM fault GROUP BY what) AS counts),
    'database_bytes', pg_database_size(current_database()));
END $$;
