"""What the file of jobs may run into: no room, another writer, another service, another file."""

import contextlib
import resource
import sqlite3
import subprocess
import time
import unittest

from process_runs import HANGS_S
from programs import FAILURE, OK, SERVER
from server_runs import ServerTest, search_of


class Full(ServerTest):
    @contextlib.contextmanager
    def no_room(self):
        """The service can write to no file past its first page, as on a full disk."""
        before = resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE)
        resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE, (4096, before[1]))
        try:
            yield
        finally:
            resource.prlimit(self.server.process.pid, resource.RLIMIT_FSIZE, before)

    def test_a_full_disk_refuses_new_jobs_and_nothing_else(self):
        job_id = self.submit(search_of(1))["id"]
        self.server.wait_for_end(job_id)
        with self.no_room():
            self.assert_problem(self.post("/v1/plans", {"valve": "human-normal"}), 507)
            self.assertEqual(self.curl(f"/v1/jobs/{job_id}")[2]["state"], "SUCCEEDED")
            self.assertEqual(self.curl(f"/v1/jobs/{job_id}/result")[0], 200)
            self.assertEqual(self.post("/v1/closures", {"valve": "human-normal"})[0], 200)
            self.assertEqual(self.curl("/healthz/live")[0], 200)
            self.assertEqual(self.curl("/healthz/ready")[0], 503)
        self.assertEqual(self.curl("/healthz/ready")[0], 200)
        self.assertEqual(self.server.wait_for_end(self.submit(search_of(2))["id"])["state"], "SUCCEEDED")

    def test_a_running_search_waits_for_room_and_goes_on(self):
        job_id = self.submit(search_of(3, evaluations=150))["id"]
        self.server.wait_until(job_id, lambda job: job["progress"]["closures"] > 10)
        with self.no_room():
            waiting = self.server.wait_until(job_id, lambda job: job["waiting_for"] is not None)
            self.assertEqual(waiting["state"], "RUNNING")
        job = self.server.wait_for_end(job_id)
        self.assertEqual((job["state"], job["waiting_for"]), ("SUCCEEDED", None))
        self.assertGreater(len(job["plans"]), 0)


class Shared(ServerTest):
    def test_another_writer_is_waited_for_but_not_for_ever(self):
        job_id = self.submit(search_of(1))["id"]
        self.server.wait_for_end(job_id)
        with contextlib.closing(sqlite3.connect(self.server.db, isolation_level=None)) as other:
            other.execute("BEGIN IMMEDIATE")
            status, headers, body = self.curl_with_headers(
                "/v1/plans", "-H", "Content-Type: application/json", "--data", '{"valve": "human-normal"}'
            )
            self.assertEqual(status, 503)
            self.assertIn(self.server.db.name, str(body))
            self.assertNotIn(str(self.server.db.parent), str(body))
            self.assertGreater(int(headers["retry-after"]), 0)
            self.assertEqual(self.curl(f"/v1/jobs/{job_id}")[0], 200)
            other.execute("ROLLBACK")
        self.assertEqual(self.server.wait_for_end(self.submit(search_of(2))["id"])["state"], "SUCCEEDED")

    def run_second(self, db):
        return subprocess.run([SERVER, "--port", "0", "--db", db], capture_output=True, text=True, timeout=HANGS_S)

    def test_a_second_service_on_the_same_file_does_not_start(self):
        second = self.run_second(self.server.db)
        self.assertEqual(second.returncode, FAILURE)
        self.assertIn(str(self.server.db), second.stderr)
        self.assertEqual(self.curl("/healthz/ready")[0], 200)
        self.assertEqual(self.server.stop(), OK)
        self.server = self.start_server()

    def test_a_file_of_another_kind_is_refused_and_not_a_byte_of_it_changed(self):
        foreign = self.folder / "foreign.sqlite"
        with contextlib.closing(sqlite3.connect(foreign)) as database:
            database.execute("CREATE TABLE letters (content TEXT)")
            database.commit()
        for path in [foreign, self.write("text.sqlite", "Dear Sir or Madam,\n" * 100)]:
            with self.subTest(path.name):
                before = path.read_bytes(), path.stat().st_mtime_ns
                time.sleep(0.01)
                second = self.run_second(path)
                self.assertEqual(second.returncode, FAILURE)
                self.assertIn(str(path), second.stderr)
                self.assertEqual((path.read_bytes(), path.stat().st_mtime_ns), before)


if __name__ == "__main__":
    unittest.main()
