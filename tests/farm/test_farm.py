"""A farm under kills, stops and restarts: each run ends with the bytes of a single process, each item counted once."""

import json
import signal
import unittest

from farm_runs import BAD_INPUT, FAILURE, HOLES, INTERRUPTED, OK, FarmTest, Request, wait_until


class Kills(FarmTest):
    def test_a_killed_worker_loses_nothing(self):
        request = Request(600, ms=2)
        coordinator = self.coordinator(request)
        for _ in range(2):
            self.stopped_worker().kill()
        self.worker()
        self.collect(coordinator, request)
        self.assert_each_item_once(request)
        lost = [fault for fault in self.status()["faults"] if fault["what"] == "lost"]
        self.assertGreaterEqual(len(lost), 2)

    def test_an_answer_that_comes_late_is_compared(self):
        request = Request(60, ms=20)
        coordinator = self.coordinator(request, "--check-share", "0")
        slow = self.stopped_worker("--name", "slow")
        self.worker("--name", "quick")
        self.collect(coordinator, request)
        slow.send_signal(signal.SIGCONT)
        answered = "SELECT sum(tasks) FROM coapt_farm.worker"
        wait_until(lambda: self.number(answered) > 6)
        self.assertEqual([fault["what"] for fault in self.status()["faults"] if fault["what"] != "lost"], [])
        self.assert_each_item_once(request)

    def test_a_database_that_crashes_is_waited_for(self):
        request = Request(800, ms=2)
        coordinator = self.coordinator(request)
        workers = [self.worker() for _ in range(2)]
        wait_until(lambda: self.done() > 10)
        kept = self.done()
        self.postgres.crash_and_restart()
        self.assertGreaterEqual(self.done(), kept)
        self.collect(coordinator, request)
        self.assert_each_item_once(request)
        self.assertEqual([worker.poll() for worker in workers], [None, None])

    def test_a_coordinator_that_was_killed_finds_its_run_again(self):
        request = Request(200, ms=2)
        worker = self.worker()
        first = self.coordinator(request)
        wait_until(lambda: self.done() > 2)
        first.kill()
        self.collect(self.coordinator(request), request)
        self.assert_each_item_once(request)
        worker.send_signal(signal.SIGTERM)
        self.assertEqual(worker.wait(30), OK)
        self.collect(self.coordinator(request), request)  # without any worker

    def test_two_coordinators_of_the_same_work_share_a_run(self):
        request = Request(200, ms=2)
        coordinators = [self.coordinator(request) for _ in range(2)]
        self.worker()
        for coordinator in coordinators:
            self.collect(coordinator, request)
        self.assert_each_item_once(request)


class Ends(FarmTest):
    def test_a_stopped_worker_gives_back_what_it_holds(self):
        request = Request(4, task_items=1, ms=100_000)
        self.farm("add", "-", stdin=request.bytes())
        for sent, code in ((signal.SIGTERM, OK), (signal.SIGINT, INTERRUPTED)):
            worker = self.start("work", "--grace", "0.1", "--json")
            claimed = "SELECT count(*) FROM coapt_farm.task WHERE state = 'claimed'"
            wait_until(lambda: self.number(claimed) == 2)
            worker.send_signal(sent)
            out, err = worker.communicate(timeout=30)
            self.assertEqual((worker.returncode, json.loads(out)["end"]), (code, "stopped"), err)
            self.assertEqual(
                self.sql("SELECT DISTINCT state, losses, tries FROM coapt_farm.task"), [["open", "0", "0"]]
            )

    def test_a_worker_ends_before_its_limit(self):
        request = Request(10_000, task_items=10, ms=10)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes())  # each task is answered once
        told = json.loads(self.farm("work", "--seconds", "3", "--grace", "0.5", "--json").stdout)
        self.assertEqual((told["end"], told["tasks"]), ("time_limit", self.done()))
        self.assertLess(told["tasks"] * 10 * 0.010, 3.0 - 0.5)  # seconds that these items take at least
        self.assertEqual(self.number("SELECT count(*) FROM coapt_farm.task WHERE state = 'claimed'"), 0)

    def test_without_open_runs_a_worker_ends_if_asked_to(self):
        self.assertEqual(json.loads(self.farm("work", "--until-dry", "--json").stdout)["end"], "dry")

    def test_what_cannot_be_computed_leaves_a_hole_and_the_rest(self):
        request = Request(50, throws_at=23)
        self.worker()
        run = self.run_farm("add", "-", "--wait", "--progress-json", stdin=request.bytes())
        self.assertEqual((run.returncode, run.stdout), (HOLES, b""))
        lines = [json.loads(line) for line in run.stderr.splitlines()]
        self.assertEqual(lines[-2], {**lines[-2], "done": 40, "items": 50, "workers": 1})
        self.assertIn("item that cannot be", lines[-1]["error"]["message"])
        self.assertIn("items from 20 (10)", lines[-1]["error"]["message"])
        self.farm("fetch", 1, code=FAILURE)
        rest = self.farm("fetch", 1, "--tasks").stdout
        self.assertTrue(rest.startswith(b"0 10 80\n" + request.answers()[:80] + b"10 10 80\n"))
        self.assertNotIn(b"\n20 10 80\n", rest)

    def test_an_item_that_kills_is_given_up_after_ten_workers(self):
        request = Request(3, task_items=1, kills_at=1)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes())
        self.sql("UPDATE coapt_farm.task SET losses = 8 WHERE first = 1")
        for _ in range(2):
            self.assertEqual(self.worker("--until-dry").wait(30), -signal.SIGKILL)
        self.assertEqual(self.worker("--until-dry").wait(30), OK)
        self.assertEqual([run["state"] for run in self.status()["runs"]], ["holes"])
        self.assertEqual(self.done(), 2)

    def test_a_cancelled_run_rests_and_goes_on_and_is_forgotten(self):
        request, other = Request(300, ms=2), Request(10, ms=0)
        coordinator = self.coordinator(request)
        worker = self.stopped_worker()
        self.farm("forget", 1, code=FAILURE)
        self.farm("cancel", 1)
        self.assertEqual(coordinator.wait(30), FAILURE)
        worker.send_signal(signal.SIGCONT)
        self.collect(self.coordinator(other), other)
        self.assertLess(self.done(), 31)
        self.collect(self.coordinator(request), request)
        self.farm("forget", 1)
        self.assertEqual(self.number("SELECT count(*) FROM coapt_farm.blob"), 2)  # of the other
        self.assertEqual(worker.poll(), None)
        self.farm("fetch", 1, code=BAD_INPUT)
        self.assertEqual(self.farm("fetch", 2).stdout, other.answers())


class Told(FarmTest):
    def test_workers_of_another_revision_leave_a_run_alone(self):
        request = Request(10)
        self.farm("add", "-", stdin=request.bytes())
        other = self.farm("work", "--until-dry", TOY_REVISION="later")
        self.assertIn("revision toy; this worker has later", other.stderr)
        self.assertEqual(self.done(), 0)
        self.assertIn("waiting for a worker of revision toy", self.farm("status").stdout.decode())

    def test_progress_is_told_every_second(self):
        request = Request(60, ms=40)
        coordinator = self.coordinator(request, "--progress-json", "--label", "slowly")
        self.worker()
        lines = [json.loads(line) for line in self.collect(coordinator, request).splitlines()]
        self.assertGreaterEqual(len(lines), 3)
        self.assertEqual(set(lines[0]), {"done", "items", "workers", "rate_per_s", "eta_s"})
        self.assertEqual((lines[-1]["done"], lines[-1]["workers"]), (60, 1))
        self.assertIn("slowly", self.farm("status").stdout.decode())

    def test_runs_that_ended_long_ago_are_only_counted(self):
        for items in range(1, 13):
            self.farm("add", "-", "--label", "of twelve", stdin=Request(items, ms=0).bytes())
        self.farm("cancel", 12)
        self.farm("work", "--until-dry")
        text = self.farm("status").stdout.decode()
        self.assertEqual(text.count("of twelve"), 10)
        self.assertIn("2 earlier runs done or cancelled", text)

    def test_metrics_are_those_of_the_status(self):
        request = Request(20)
        self.farm("add", "-", "--check-share", "0", "--label", 'quoted "twice"\\', stdin=request.bytes())
        self.farm("work", "--until-dry", "--name", "anna")
        text = self.farm("status", "--prometheus").stdout.decode()
        self.assertIn('coapt_farm_run_items_done{run="1",label="quoted \\"twice\\"\\\\",state="done"} 20\n', text)
        self.assertRegex(text, r'coapt_farm_worker_items_total\{name="anna",pid="\d+"\} 20\n')
        self.assertIn('coapt_farm_workers{state="alive"} 0\n', text)
        for line in text.splitlines():
            self.assertRegex(line, r"^(# (HELP|TYPE) .+|[a-z_]+(\{.*\})? [0-9.e+-]+)$")

    def test_a_database_without_a_farm_says_what_to_do(self):
        self.sql("DROP SCHEMA coapt_farm CASCADE")
        self.assertIn("coapt-farm init", self.farm("status", code=FAILURE).stderr)

    def test_a_farm_of_another_version_is_refused_and_left_alone(self):
        self.sql("UPDATE coapt_farm.schema_version SET number = 999")
        for command in (["status"], ["init"], ["work"]):
            self.assertIn("version 999", self.farm(*command, code=FAILURE).stderr)


if __name__ == "__main__":
    unittest.main()
