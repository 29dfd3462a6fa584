"""Workers that answer wrongly: found by the share of tasks that two compute, and what they answered is done again."""

import signal
import unittest

from farm_runs import FAILURE, FarmTest, Request, wait_until


class Checks(FarmTest):
    def test_a_worker_that_answers_wrongly_is_found_and_its_answers_are_replaced(self):
        request = Request(300, ms=1)
        coordinator = self.coordinator(request, "--check-share", "0.5")
        # Without another one alive the wrong one would check itself.
        right = self.stopped_worker("--name", "right", items=0, lease=60)
        self.worker("--name", "wrong", TOY_FLIP="0.3")
        wait_until(lambda: self.number("SELECT sum(tasks) FROM coapt_farm.worker") >= 15)
        right.send_signal(signal.SIGCONT)
        self.worker("--name", "also right")
        self.collect(coordinator, request)
        self.assert_each_item_once(request)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.worker WHERE barred"), [["wrong"]])
        self.assertEqual({fault["worker"] for fault in self.status()["faults"] if fault["what"] == "barred"}, {"wrong"})
        again = self.farm("work", "--name", "wrong", code=FAILURE)
        self.assertIn("barred", again.stderr)

    def test_two_workers_that_differ_wait_for_a_third(self):
        request = Request(10)
        self.worker("--name", "wrong", TOY_FLIP="1", lease=60)
        self.worker("--name", "right", lease=60)
        wait_until(lambda: self.number("SELECT count(*) FROM coapt_farm.worker") == 2)  # one alone would check itself
        coordinator = self.coordinator(request, "--check-share", "1")
        twice = "SELECT count(*) FROM coapt_farm.opinion WHERE given = 2"
        wait_until(lambda: self.number(twice) == 2)
        self.assertIsNone(coordinator.poll())
        self.assertIn("answered in different ways", self.farm("status").stdout.decode())
        self.worker("--name", "third")
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
        wrong = self.worker("--name", "wrong", TOY_FLIP="1")
        wait_until(lambda: self.done() == 2)
        wrong.terminate()
        wrong.wait(30)
        self.sql("UPDATE coapt_farm.task SET state = 'open' WHERE first = 0")
        for name in ("right", "third"):
            self.worker("--name", name)
        barred = "SELECT name FROM coapt_farm.worker WHERE barred"
        wait_until(lambda: self.sql(barred) == [["wrong"]])
        self.sql("UPDATE coapt_farm.task SET lease_until = now() WHERE first = 20")
        self.assertEqual(self.farm("fetch", 1, "--wait").stdout, request.answers())

    def test_the_share_is_kept(self):
        request = Request(4000, task_items=1)
        self.farm("add", "-", "--check-share", "0.1", stdin=request.bytes())
        checked = self.number("SELECT count(*) FROM coapt_farm.task WHERE wants_check")
        self.assertAlmostEqual(checked / 4000, 0.1, delta=0.02)


if __name__ == "__main__":
    unittest.main()
