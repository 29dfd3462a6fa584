-- Answers, and what becomes of those that differ.
--
-- An answer stands once it is in result. Two workers that give the same task different bytes are both doubted: their answers
-- move to opinion, and the task is computed by others until two workers agree. Who said otherwise is barred.

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
  WITH withdrawn AS (DELETE FROM opinion o WHERE o.worker = p_worker RETURNING o.run, o.first)
  UPDATE task t SET answers = 0 FROM withdrawn d
    WHERE t.run = d.run AND t.first = d.first AND t.answers >= 2
      AND NOT EXISTS (SELECT FROM opinion o WHERE o.run = t.run AND o.first = t.first AND o.worker <> p_worker);
  INSERT INTO fault (run, first, worker, what, detail)
    VALUES (p_run, p_first, p_worker, 'barred', p_why || '; tasks opened again: ' || reopened);
END $$;

-- Takes one more answer of a task whose answers differ.
CREATE OR REPLACE FUNCTION coapt_farm.settle(t coapt_farm.task, p_worker bigint, p_seconds float8, p_bytes bytea) RETURNS void
LANGUAGE plpgsql SET search_path = coapt_farm, pg_temp AS $$
DECLARE agrees opinion; odd bigint;
BEGIN
  PERFORM FROM run WHERE id = t.run FOR UPDATE;
  SELECT * INTO agrees FROM opinion o
    WHERE o.run = t.run AND o.first = t.first AND o.worker <> p_worker AND o.bytes = p_bytes ORDER BY o.worker LIMIT 1;
  IF FOUND THEN
    INSERT INTO result (run, first, n, checked, worker, seconds, bytes)
      VALUES (t.run, t.first, t.n, true, agrees.worker, agrees.seconds, p_bytes);
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
      state = CASE WHEN (SELECT count(*) FROM opinion o WHERE o.run = t.run AND o.first = t.first) >= 5 THEN 'poison' ELSE 'open' END,
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

-- One transaction, which waits for the disk: what it has taken is never lost. 'kept', 'same' as an answer before, 'differs', or
-- 'unknown' if the run was forgotten meanwhile.
CREATE OR REPLACE FUNCTION coapt_farm.finish(p_worker bigint, p_run bigint, p_first bigint, p_seconds float8, p_bytes bytea)
RETURNS text
LANGUAGE plpgsql SECURITY DEFINER SET search_path = coapt_farm, pg_temp AS $$
DECLARE
  me worker := this_worker(p_worker);
  t task;
  kept result;
  of_run run;
  verdict text := 'kept';
BEGIN
  SELECT * INTO t FROM task WHERE run = p_run AND first = p_first FOR UPDATE;
  SELECT * INTO of_run FROM run WHERE id = p_run;
  IF t.run IS NULL OR of_run.id IS NULL THEN
    RETURN 'unknown';
  END IF;
  IF of_run.revision <> me.revision OR (of_run.team <> '' AND NOT may_use(of_run.team, me.login)) THEN
    RAISE EXCEPTION 'run % is not for this worker', p_run USING ERRCODE = 'CF003';
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
  IF NOT kept.checked AND kept.worker <> me.id THEN
    UPDATE result r SET checked = true WHERE r.run = p_run AND r.first = p_first;
    kept.checked := true;
  END IF;
  IF t.state IN ('open', 'claimed') THEN
    UPDATE task SET owner = NULL, lease_until = NULL,
        -- A worker that is alone checks itself: that finds a bit that flipped, not a machine that is always wrong.
        state = CASE WHEN t.wants_check AND NOT kept.checked AND others_alive(me.id, p_run, p_first) THEN 'open' ELSE 'done' END
      WHERE run = p_run AND first = p_first;
  END IF;
  RETURN 'same';
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
