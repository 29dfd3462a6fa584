-- Answers, and what becomes of those that differ.
--
-- An answer stands once it is in result. Two workers that give the same task different bytes are both doubted: their answers
-- move to opinion, and the task is computed by others until workers of two logins agree. Who said otherwise is barred. A login
-- may run any number of workers: among themselves they settle only what nobody else has answered or could.

-- Nothing that was said to a task that is in dispute counts any more: it is computed anew.
CREATE OR REPLACE FUNCTION coapt_farm.withdraw(p_run bigint, p_first bigint) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
BEGIN
  UPDATE task SET answers = 0 WHERE run = p_run AND first = p_first AND answers >= 2;
  IF FOUND THEN
    DELETE FROM opinion WHERE run = p_run AND first = p_first;
  END IF;
END $$;

-- For a run, workers of this login and name are no more: what they alone answered is open again.
CREATE OR REPLACE FUNCTION coapt_farm.shut_out(p_run bigint, p_worker bigint) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
DECLARE author worker;
BEGIN
  SELECT * INTO author FROM worker WHERE id = p_worker;
  INSERT INTO distrust (run, login, name) SELECT p_run, author.login, author.name WHERE author.id IS NOT NULL
    ON CONFLICT DO NOTHING;
  WITH doubted AS (
    DELETE FROM result r USING worker w
      WHERE r.run = p_run AND NOT r.checked AND w.id = r.worker AND w.login = author.login AND w.name = author.name
      RETURNING r.run, r.first)
  UPDATE task t SET state = 'open', answers = 0, owner = NULL, lease_until = NULL
    FROM doubted d WHERE t.run = d.run AND t.first = d.first;
  UPDATE task t SET state = 'open', owner = NULL, lease_until = NULL FROM worker w
    WHERE t.run = p_run AND t.state = 'claimed' AND w.id = t.owner AND w.login = author.login AND w.name = author.name;
  PERFORM withdraw(o.run, o.first) FROM opinion o JOIN worker w ON w.id = o.worker
    WHERE o.run = p_run AND w.login = author.login AND w.name = author.name;
END $$;

-- The worker gets no more tasks, and what it alone answered in runs that have not ended is open again.
CREATE OR REPLACE FUNCTION coapt_farm.bar(p_worker bigint, p_run bigint, p_first bigint, p_why text) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
DECLARE reopened bigint;
BEGIN
  UPDATE worker SET barred = true WHERE id = p_worker AND NOT barred;
  IF NOT FOUND THEN
    RETURN;
  END IF;
  PERFORM FROM run WHERE state = 'open' ORDER BY id FOR UPDATE;  -- lest one of them ends meanwhile (end_run)
  WITH doubted AS (
    DELETE FROM result r USING run WHERE run.id = r.run AND run.state = 'open' AND r.worker = p_worker AND NOT r.checked
    RETURNING r.run, r.first)
  UPDATE task t SET state = 'open', answers = 0, owner = NULL, lease_until = NULL
    FROM doubted d WHERE t.run = d.run AND t.first = d.first;
  GET DIAGNOSTICS reopened = ROW_COUNT;
  UPDATE task SET state = 'open', owner = NULL, lease_until = NULL WHERE state = 'claimed' AND owner = p_worker;
  PERFORM withdraw(o.run, o.first) FROM opinion o WHERE o.worker = p_worker;
  INSERT INTO fault (run, first, worker, what, detail)
    VALUES (p_run, p_first, p_worker, 'barred', p_why || '; tasks opened again: ' || reopened);
END $$;

-- Takes one more answer of a task whose answers differ.
CREATE OR REPLACE FUNCTION coapt_farm.settle(t coapt_farm.task, p_worker bigint, p_seconds float8, p_bytes bytea) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
DECLARE agrees record; odd bigint; me worker; alone boolean;
BEGIN
  PERFORM FROM run WHERE id = t.run FOR UPDATE;
  SELECT * INTO me FROM worker WHERE id = p_worker;
  alone := NOT others_alive(me, t.run, t.first, true)
    AND NOT EXISTS (SELECT FROM opinion o JOIN worker w ON w.id = o.worker
                    WHERE o.run = t.run AND o.first = t.first AND w.login <> me.login);
  SELECT o.*, w.login <> me.login AS of_another INTO agrees FROM opinion o JOIN worker w ON w.id = o.worker
    WHERE o.run = t.run AND o.first = t.first AND o.worker <> p_worker AND o.bytes = p_bytes
    ORDER BY w.login = me.login, o.worker LIMIT 1;
  IF FOUND AND (agrees.of_another OR alone) THEN
    INSERT INTO result (run, first, n, checked, worker, seconds, bytes)
      VALUES (t.run, t.first, t.n, agrees.of_another, agrees.worker, agrees.seconds, p_bytes);
    UPDATE task SET state = 'done', owner = NULL, lease_until = NULL, answers = 1 WHERE run = t.run AND first = t.first;
    UPDATE run SET state = 'open', finished = NULL WHERE id = t.run AND state = 'holes';
    FOR odd IN SELECT o.worker FROM opinion o WHERE o.run = t.run AND o.first = t.first AND o.bytes <> p_bytes LOOP
      PERFORM bar(odd, t.run, t.first, 'two workers agreed on another answer');
    END LOOP;
    DELETE FROM opinion o WHERE o.run = t.run AND o.first = t.first;
    RETURN;
  END IF;
  IF EXISTS (SELECT FROM opinion o WHERE o.run = t.run AND o.first = t.first AND o.worker = p_worker AND o.bytes <> p_bytes) THEN
    UPDATE task SET state = 'open', owner = NULL, lease_until = NULL WHERE run = t.run AND first = t.first;
    PERFORM bar(p_worker, t.run, t.first, 'it answered the same task in two ways');
    RETURN;
  END IF;
  INSERT INTO opinion (run, first, worker, seconds, bytes) VALUES (t.run, t.first, p_worker, p_seconds, p_bytes)
    ON CONFLICT (run, first, worker) DO UPDATE SET given = opinion.given + 1;
  UPDATE task SET owner = NULL, lease_until = NULL, answers = 2 + (t.answers >= 2)::int,
      state = CASE WHEN (SELECT CASE WHEN alone THEN count(*) ELSE count(DISTINCT w.login) END
                         FROM opinion o JOIN worker w ON w.id = o.worker WHERE o.run = t.run AND o.first = t.first) >= 5
              THEN 'poison' ELSE 'open' END,
      last_error = 'workers give different answers'
    WHERE run = t.run AND first = t.first;
END $$;

-- An answer that differs from the one in result.
CREATE OR REPLACE FUNCTION coapt_farm.dispute(t coapt_farm.task, p_worker bigint, p_seconds float8, p_bytes bytea) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
DECLARE kept result; run_state text;
BEGIN
  SELECT state INTO run_state FROM run WHERE id = t.run FOR UPDATE;
  SELECT * INTO kept FROM result r WHERE r.run = t.run AND r.first = t.first;
  INSERT INTO fault (run, first, worker, what, detail)
    VALUES (t.run, t.first, p_worker, 'differs', 'from the answer of worker ' || kept.worker || ': SHA-256 '
            || encode(sha256(p_bytes), 'hex') || ', not ' || encode(sha256(kept.bytes), 'hex'));
  IF kept.checked THEN
    PERFORM bar(p_worker, t.run, t.first, 'two workers agreed on another answer');
  ELSIF kept.worker = p_worker THEN
    PERFORM bar(p_worker, t.run, t.first, 'it answered the same task in two ways');
  ELSIF run_state = 'open' THEN
    DELETE FROM result r WHERE r.run = t.run AND r.first = t.first;
    INSERT INTO opinion (run, first, worker, seconds, bytes)
      VALUES (t.run, t.first, kept.worker, kept.seconds, kept.bytes)
      ON CONFLICT DO NOTHING;
    PERFORM settle(t, p_worker, p_seconds, p_bytes);
    RETURN;
  END IF;
  UPDATE task SET state = 'open', owner = NULL, lease_until = NULL
    WHERE run = t.run AND first = t.first AND state = 'claimed' AND owner = p_worker;
END $$;

-- One transaction, which waits for the disk: what it has taken is never lost. 'kept', 'same' as an answer before, 'differs',
-- 'unclaimed' from a worker that neither holds the task nor lost its lease, or 'unknown': there is no such task of this work, as
-- when the run was forgotten meanwhile, or the farm restored from a backup.
CREATE OR REPLACE FUNCTION coapt_farm.finish(p_worker bigint, p_run bigint, p_first bigint, p_work_id text, p_seconds float8,
  p_bytes bytea)
RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE
  me worker := this_worker(p_worker);
  t task;
  kept result;
  of_run run;
BEGIN
  -- Where the answer may be disputed, its run is locked before its task: in the order of whoever judges, doubts or bars.
  PERFORM FROM run WHERE id = p_run
    AND (state = 'holes' OR EXISTS (SELECT FROM task WHERE run = p_run AND first = p_first AND answers >= 2)
         OR EXISTS (SELECT FROM result r WHERE r.run = p_run AND r.first = p_first AND r.bytes <> p_bytes)) FOR UPDATE;
  SELECT * INTO t FROM task WHERE run = p_run AND first = p_first FOR UPDATE;
  SELECT * INTO of_run FROM run WHERE id = p_run;
  IF t.run IS NULL OR of_run.id IS NULL THEN
    RETURN 'unknown';
  END IF;
  IF of_run.revision <> me.revision OR NOT may_use(of_run.team, me.login) THEN
    RAISE EXCEPTION 'run % is not for this worker', p_run USING ERRCODE = 'CF003';
  END IF;
  IF of_run.work_id <> p_work_id THEN
    RETURN 'unknown';
  END IF;
  SELECT * INTO kept FROM result r WHERE r.run = p_run AND r.first = p_first;
  IF NOT may_answer(of_run, me)
     OR NOT ((t.state = 'claimed' AND t.owner = me.id)
             OR EXISTS (SELECT FROM fault f WHERE f.run = p_run AND f.first = p_first AND f.worker = me.id AND f.what = 'lost')) THEN
    -- Its answer may be here already: a worker asks again if the connection broke.
    RETURN CASE WHEN kept.worker = me.id AND kept.bytes = p_bytes THEN 'same' ELSE 'unclaimed' END;
  END IF;
  UPDATE worker SET tasks = tasks + 1, items = items + t.n, seconds = seconds + p_seconds, seen = clock_timestamp()
    WHERE id = me.id;
  IF t.answers >= 2 THEN
    PERFORM settle(t, me.id, p_seconds, p_bytes);
    RETURN 'differs';
  END IF;
  INSERT INTO result (run, first, n, worker, seconds, bytes) VALUES (p_run, p_first, t.n, me.id, p_seconds, p_bytes)
    ON CONFLICT (run, first) DO NOTHING;
  IF FOUND THEN
    UPDATE task SET answers = 1, owner = NULL, lease_until = NULL, state = CASE WHEN t.wants_check THEN 'open' ELSE 'done' END
      WHERE run = p_run AND first = p_first;
    IF of_run.state = 'holes' THEN
      UPDATE run SET state = 'open', finished = NULL WHERE id = p_run AND state = 'holes';
    END IF;
    RETURN 'kept';
  END IF;
  SELECT * INTO kept FROM result r WHERE r.run = p_run AND r.first = p_first;
  IF kept.bytes <> p_bytes THEN
    PERFORM dispute(t, me.id, p_seconds, p_bytes);
    RETURN 'differs';
  END IF;
  IF NOT kept.checked AND me.login <> (SELECT w.login FROM worker w WHERE w.id = kept.worker) THEN
    UPDATE result r SET checked = true WHERE r.run = p_run AND r.first = p_first;
    kept.checked := true;
  END IF;
  IF t.state IN ('open', 'claimed') THEN
    UPDATE task SET owner = NULL, lease_until = NULL,
        -- A worker that is alone checks itself: that finds a bit that flipped, not a machine that is always wrong.
        state = CASE WHEN t.wants_check AND NOT kept.checked AND others_alive(me, p_run, p_first, true) THEN 'open' ELSE 'done' END
      WHERE run = p_run AND first = p_first;
  END IF;
  RETURN 'same';
END $$;

-- For whoever asked, who computed some tasks again: the answer to this one is not right. What its worker alone answered in the run
-- is open again, and for others. Whose answer it was; none if it is gone.
CREATE OR REPLACE FUNCTION coapt_farm.doubt(p_run bigint, p_first bigint, p_why text) RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run); wrong result; author worker;
BEGIN
  PERFORM FROM run WHERE id = p_run FOR UPDATE;
  SELECT * INTO wrong FROM result r WHERE r.run = p_run AND r.first = p_first;
  IF NOT FOUND THEN
    RETURN '';
  END IF;
  SELECT * INTO author FROM worker WHERE id = wrong.worker;
  DELETE FROM result WHERE run = p_run AND first = p_first;
  UPDATE task SET state = 'open', answers = 0, owner = NULL, lease_until = NULL WHERE run = p_run AND first = p_first;
  PERFORM shut_out(p_run, wrong.worker);
  UPDATE run SET state = 'open', finished = NULL WHERE id = p_run AND state IN ('done', 'holes');
  INSERT INTO fault (run, first, worker, what, detail)
    VALUES (p_run, p_first, wrong.worker, 'differs', 'from what ' || session_user || ' asks for: ' || left(p_why, 500));
  RETURN coalesce(author.name || ', login ' || author.login, 'worker ' || wrong.worker);
END $$;

-- A task that workers of two logins or more have answered in different ways, and that no other login could settle now.
CREATE OR REPLACE FUNCTION coapt_farm.disputed(p_run bigint) RETURNS TABLE (first bigint, n bigint)
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
#variable_conflict use_column
DECLARE of_run run := this_run(p_run);
BEGIN
  RETURN QUERY SELECT t.first, t.n::bigint FROM task t
    WHERE t.run = p_run AND t.state = 'open' AND t.answers >= 2
      AND (SELECT count(DISTINCT w.login) FROM opinion o JOIN worker w ON w.id = o.worker
           WHERE o.run = p_run AND o.first = t.first) >= 2
      AND NOT EXISTS (
        SELECT FROM worker w WHERE w.revision = of_run.revision AND w.seen > clock_timestamp() - interval '1 day'
          AND is_alive(w) AND may_answer(of_run, w)
          AND w.login NOT IN (SELECT x.login FROM opinion o JOIN worker x ON x.id = o.worker
                              WHERE o.run = p_run AND o.first = t.first))
    ORDER BY t.first LIMIT 1;
END $$;

-- Such a task's answer, as whoever asked computes it: with a worker that says the same, two logins agree. The others answer the run
-- no more.
CREATE OR REPLACE FUNCTION coapt_farm.judge(p_run bigint, p_first bigint, p_bytes bytea) RETURNS void
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE of_run run := this_run(p_run); t task; agrees opinion; odd bigint; odds bigint[];
BEGIN
  PERFORM FROM run WHERE id = p_run FOR UPDATE;
  SELECT * INTO t FROM task WHERE run = p_run AND first = p_first AND answers >= 2 FOR UPDATE;
  IF NOT FOUND THEN
    RETURN;
  END IF;
  SELECT o.* INTO agrees FROM opinion o JOIN worker w ON w.id = o.worker
    WHERE o.run = p_run AND o.first = p_first AND o.bytes = p_bytes AND w.login <> session_user ORDER BY o.worker LIMIT 1;
  odds := ARRAY(SELECT o.worker FROM opinion o WHERE o.run = p_run AND o.first = p_first AND o.bytes <> p_bytes);
  DELETE FROM opinion WHERE run = p_run AND first = p_first;
  IF agrees.worker IS NOT NULL THEN
    INSERT INTO result (run, first, n, checked, worker, seconds, bytes)
      VALUES (p_run, p_first, t.n, true, agrees.worker, agrees.seconds, p_bytes);
  END IF;
  UPDATE task SET owner = NULL, lease_until = NULL, answers = (agrees.worker IS NOT NULL)::int,
      state = CASE WHEN agrees.worker IS NULL THEN 'open' ELSE 'done' END
    WHERE run = p_run AND first = p_first;
  FOREACH odd IN ARRAY odds LOOP
    INSERT INTO fault (run, first, worker, what, detail)
      VALUES (p_run, p_first, odd, 'differs', 'from what ' || session_user || ', who asks, has computed');
    PERFORM shut_out(p_run, odd);
  END LOOP;
END $$;

-- A task that could not be computed; after three failures no one tries it again.
CREATE OR REPLACE FUNCTION coapt_farm.fail(p_worker bigint, p_run bigint, p_first bigint, p_error text) RETURNS void
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE me worker := this_worker(p_worker);
BEGIN
  UPDATE task SET tries = tries + 1, unlucky = me.id, last_error = left(p_error, 2000), owner = NULL, lease_until = NULL,
      state = CASE WHEN tries >= 2 THEN 'poison' ELSE 'open' END
    WHERE run = p_run AND first = p_first AND state = 'claimed' AND owner = me.id;
  IF FOUND THEN
    INSERT INTO fault (run, first, worker, what, detail) VALUES (p_run, p_first, me.id, 'failed', left(p_error, 2000));
  END IF;
END $$;
