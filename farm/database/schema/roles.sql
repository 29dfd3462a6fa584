-- Who may call what. Nobody but the owner touches a table; what a login may do follows from the roles that it is granted.

DO $$
DECLARE role_name text;
BEGIN
  FOREACH role_name IN ARRAY ARRAY['coapt_coordinator', 'coapt_worker', 'coapt_reader'] LOOP
    IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = role_name) THEN
      EXECUTE format('CREATE ROLE %I NOLOGIN', role_name);
    END IF;
  END LOOP;
END $$;

REVOKE ALL ON SCHEMA coapt_farm FROM PUBLIC;
REVOKE ALL ON ALL TABLES IN SCHEMA coapt_farm FROM PUBLIC;
REVOKE ALL ON ALL FUNCTIONS IN SCHEMA coapt_farm FROM PUBLIC;
GRANT USAGE ON SCHEMA coapt_farm TO coapt_coordinator, coapt_worker, coapt_reader;
GRANT EXECUTE ON FUNCTION coapt_farm.hello() TO coapt_coordinator, coapt_worker, coapt_reader;
GRANT EXECUTE ON FUNCTION
  coapt_farm.join_farm(text, text, int, text, float8), coapt_farm.claim(bigint, bigint),
  coapt_farm.renew(bigint, bigint[], bigint[]), coapt_farm.give_back(bigint, bigint[], bigint[]),
  coapt_farm.leave_farm(bigint), coapt_farm.read_part(bigint, bigint, text), coapt_farm.waiting(bigint),
  coapt_farm.finish(bigint, bigint, bigint, text, float8, bytea), coapt_farm.fail(bigint, bigint, bigint, text)
  TO coapt_worker;
GRANT EXECUTE ON FUNCTION
  coapt_farm.add_part(bytea),
  coapt_farm.add_run(text, text, text[], text, text, bigint, bigint, float8),
  coapt_farm.request_of(bigint), coapt_farm.part_of(bigint, text), coapt_farm.doubt(bigint, bigint, text),
  coapt_farm.disputed(bigint), coapt_farm.judge(bigint, bigint, bytea),
  coapt_farm.result_chunk(bigint, bigint, bigint), coapt_farm.cancel(bigint), coapt_farm.forget(bigint)
  TO coapt_coordinator;
GRANT EXECUTE ON FUNCTION coapt_farm.progress(bigint), coapt_farm.status() TO coapt_coordinator, coapt_reader;
