"""SIGTERM ends the service soon, whatever it is doing, and loses nothing."""

import contextlib
import socket
import sqlite3
import unittest

from programs import OK
from server_runs import ServerTest, search_of

import kill_nine  # found through server_runs
from served import ENDED

LONG = search_of(3, evaluations=60, region_points=17)


class Stop(ServerTest):
    def stop(self):
        """The service is asked to end; states of the jobs that it leaves."""
        self.assertEqual(self.server.stop(), OK, self.server.messages.read_text())
        with contextlib.closing(sqlite3.connect(self.server.db)) as database:
            return [state for (state,) in database.execute("SELECT state FROM jobs ORDER BY number")]

    def test_a_search_that_was_stopped_goes_on_with_the_next_start_to_the_same_plans(self):
        undisturbed = self.start_server("undisturbed.sqlite")
        request = {"valve": "human-functional-mr", "search": LONG}
        expected, _ = kill_nine.outcome_of(undisturbed, undisturbed.wait_for_end(undisturbed.submit(request)["id"]))
        job_id = self.submit(LONG)["id"]
        self.server.wait_until(job_id, lambda job: job["progress"]["closures"] > 10)
        self.assertNotIn(self.stop()[0], ENDED)
        self.server = self.start_server()
        job = self.server.wait_for_end(job_id)
        got, known = kill_nine.outcome_of(self.server, job)
        self.assertEqual(kill_nine.difference(expected, got), "")
        self.assertGreater(known, 0)

    def test_queued_jobs_are_still_there(self):
        ids = [self.submit(search_of(seed))["id"] for seed in range(6)]
        self.assertEqual(self.stop()[-1], "QUEUED")
        self.server = self.start_server()
        for job_id in ids:
            self.assertEqual(self.server.wait_for_end(job_id)["state"], "SUCCEEDED")

    def test_clients_that_neither_send_nor_take_do_not_keep_it(self):
        job_id = self.submit(LONG)["id"]
        stuck = [
            b"",
            b"GET /vers",
            b"GET /openapi.json HTTP/1.1\r\nHost: localhost\r\n\r\n",
            b"POST /v1/closures HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000\r\n\r\n{",
            f"GET /v1/jobs/{job_id}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode(),
        ]
        for request in stuck:
            client = socket.create_connection(("127.0.0.1", self.server.port), timeout=10)
            self.addCleanup(client.close)
            client.sendall(request)
        self.assertNotIn(self.stop()[0], ENDED)

    def test_a_stop_before_anything_was_asked_is_clean(self):
        self.stop()


if __name__ == "__main__":
    unittest.main()
