"""Workers that answer wrongly: found by the share of tasks that two logins compute, and what they answered is done again."""

import signal
import unittest

from farm_runs import FAILURE, FarmTest, Request, wait_until


class Checks(FarmTest):
    def setUp(self):
        super().setUp()
        self.one, self.two, self.three = (self.new_login(f"lab{i}", "coapt_worker") for i in (1, 2, 3))

    def test_a_worker_that_answers_wrongly_is_found_and_its_answers_are_replaced(self):
        request = Request(300, ms=1)
        coordinator = self.coordinator(request, "--check-share", "0.5", "--recompute", "0")
        # Without another one alive the wrong one would check itself.
        right = self.stopped_worker("--name", "right", items=0, lease=60, url=self.one)
        self.worker("--name", "wrong", TOY_FLIP="0.5", url=self.two)
        # None of 25 is both wrong and drawn to be checked once in 1,300 runs.
        wait_until(lambda: self.number("SELECT sum(tasks) FROM coapt_farm.worker") >= 25)
        right.send_signal(signal.SIGCONT)
        self.worker("--name", "also right", url=self.three)
        self.collect(coordinator, request)
        self.assert_each_item_once(request)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.worker WHERE barred"), [["wrong"]])
        self.assertEqual({fault["worker"] for fault in self.status()["faults"] if fault["what"] == "barred"}, {"wrong"})
        again = self.farm("work", "--name", "wrong", url=self.two, code=FAILURE)
        self.assertIn("barred", again.stderr)
        self.farm("work", "--name", "wrong", "--until-dry", url=self.one)  # names are each login's own

    def test_two_logins_that_differ_wait_for_a_third(self):
        request = Request(10)
        self.worker("--name", "wrong", TOY_FLIP="1", lease=60, url=self.one)
        self.worker("--name", "right", lease=60, url=self.two)
        wait_until(lambda: self.number("SELECT count(*) FROM coapt_farm.worker") == 2)  # one alone would check itself
        coordinator = self.coordinator(request, "--check-share", "1", "--recompute", "0")
        twice = "SELECT count(*) FROM coapt_farm.opinion WHERE given = 2"
        wait_until(lambda: self.number(twice) == 2)
        self.assertIsNone(coordinator.poll())
        self.assertIn("returned different results", self.farm("status").stdout.decode())
        self.worker("--name", "third", url=self.three)
        self.collect(coordinator, request)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.worker WHERE barred"), [["wrong"]])

    def test_a_worker_alone_checks_itself(self):
        request = Request(100, ms=0)
        coordinator = self.coordinator(request, "--check-share", "1")
        self.worker()
        self.collect(coordinator, request)
        self.assertEqual(self.number("SELECT sum(tasks) FROM coapt_farm.worker"), 20)
        self.assertEqual(self.sql("SELECT DISTINCT checked FROM coapt_farm.result"), [["f"]])

    def test_a_late_answer_that_differs_opens_the_task_again(self):
        request = Request(30, ms=0)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes())
        self.sql("UPDATE coapt_farm.task SET state = 'claimed', lease_until = 'infinity' WHERE first = 20")
        wrong = self.worker("--name", "wrong", TOY_FLIP="1", url=self.one)
        wait_until(lambda: self.done() == 2)
        wrong.terminate()
        wrong.wait(30)
        self.sql("UPDATE coapt_farm.task SET state = 'open' WHERE first = 0")
        for name, login in (("right", self.two), ("third", self.three)):
            self.worker("--name", name, url=login)
        barred = "SELECT name FROM coapt_farm.worker WHERE barred"
        wait_until(lambda: self.sql(barred) == [["wrong"]])
        self.sql("UPDATE coapt_farm.task SET lease_until = now() WHERE first = 20")
        self.assertEqual(self.farm("fetch", 1, "--wait").stdout, request.answers())

    def test_without_a_third_whoever_asks_is_the_third(self):
        request = Request(300)
        self.worker("--name", "wrong", TOY_FLIP="0.5", lease=60, url=self.one)
        self.worker("--name", "right", lease=60, url=self.two)
        wait_until(lambda: self.number("SELECT count(*) FROM coapt_farm.worker") == 2)
        self.collect(self.coordinator(request, "--check-share", "1"), request)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.distrust"), [["wrong"]])

    def test_machines_of_one_login_settle_what_they_alone_have_answered(self):
        request = Request(300, ms=1)
        coordinator = self.coordinator(request, "--check-share", "1", "--recompute", "0")
        right = self.stopped_worker("--name", "right", items=0, lease=60, url=self.one)
        self.worker("--name", "wrong", TOY_FLIP="0.3", url=self.one)
        wait_until(lambda: self.number("SELECT sum(tasks) FROM coapt_farm.worker") >= 15)
        right.send_signal(signal.SIGCONT)
        self.worker("--name", "also right", url=self.one)
        self.collect(coordinator, request)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.worker WHERE barred"), [["wrong"]])
        self.assertEqual(self.sql("SELECT DISTINCT checked FROM coapt_farm.result"), [["f"]])

    def test_whoever_asks_for_more_checks_of_the_same_work_has_them(self):
        request = Request(100, ms=0)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes())
        self.farm("work", "--until-dry", url=self.one)
        self.assertEqual([run["state"] for run in self.status()["runs"]], ["done"])
        coordinator = self.coordinator(request, "--check-share", "1")
        self.worker(url=self.two)
        self.collect(coordinator, request)
        self.assertEqual(self.sql("SELECT DISTINCT checked FROM coapt_farm.result"), [["t"]])

    def test_the_share_is_kept(self):
        request = Request(4000, task_items=1)
        self.farm("add", "-", "--check-share", "0.1", stdin=request.bytes())
        checked = self.number("SELECT count(*) FROM coapt_farm.task WHERE wants_check")
        self.assertAlmostEqual(checked / 4000, 0.1, delta=0.02)
        self.sql("CREATE TABLE drawn AS SELECT first FROM coapt_farm.task WHERE wants_check")
        self.farm("work", "--until-dry", "--threads", "2")
        self.farm("forget", 1)
        self.farm("add", "-", "--check-share", "0.1", stdin=request.bytes())
        both = "SELECT count(*) FROM drawn JOIN coapt_farm.task USING (first) WHERE wants_check"
        self.assertLess(self.number(both), 80)  # 40 by chance, where the request decided all 400


if __name__ == "__main__":
    unittest.main()
