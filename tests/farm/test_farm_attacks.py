"""What a login of the farm may try to make others believe, hold or see: nothing of it succeeds."""

import hashlib
import json
import unittest

from farm_runs import FAILURE, FarmTest, Request


def work_id(request):
    names = [hashlib.sha256(part).hexdigest() for part in request.parts]
    return hashlib.sha256("\n".join(["toy", *names]).encode()).hexdigest()


class Attacks(FarmTest):
    def setUp(self):
        super().setUp()
        self.boss = self.new_login("asks", "coapt_coordinator")
        self.carl = self.new_login("carl", "coapt_coordinator")
        self.honest = self.new_login("honest", "coapt_worker")
        self.new_login("mallory", "coapt_worker")

    def call(self, text, user="mallory"):
        return self.sql(f"SELECT * FROM coapt_farm.{text}", user=user, password=f"pw-{user}")

    def join(self, name, lease_s=60, user="mallory"):
        return int(self.call(f"join_farm('{name}', 'host', 1, 'toy', {lease_s})", user)[0][0])

    def claim(self, worker, most=1):
        return [int(row[1]) for row in self.call(f"claim({worker}, {most})")]

    def finish(self, worker, request, first, answer):
        return self.call(f"finish({worker}, 1, {first}, '{work_id(request)}', 1, '\\x{answer.hex()}')")[0][0]

    def lie(self, worker, request, first, letter=b"\0"):
        return self.finish(worker, request, first, letter * 80)

    def test_answers_to_tasks_that_were_not_claimed_are_not_taken(self):
        request = Request(30)
        self.farm("add", "-", "--check-share", "1", stdin=request.bytes(), url=self.boss)
        workers = [self.join("one"), self.join("two")]
        for first in (0, 10, 20):
            for worker in workers:
                self.assertEqual(self.lie(worker, request, first), "unclaimed")
        self.assertEqual(self.done(), 0)

    def test_one_login_does_not_confirm_itself_to_whoever_asked(self):
        request = Request(100)
        self.farm("add", "-", "--check-share", "1", stdin=request.bytes(), url=self.boss)
        workers = [self.join("one"), self.join("two")]
        for _ in range(11):
            for worker in workers:
                for first in self.claim(worker, 20):
                    self.lie(worker, request, first)
        self.call(f"claim({workers[0]}, 1)")
        self.assertEqual(self.status()["runs"][0]["state"], "done")
        fetched = self.farm("fetch", 1, url=self.boss, code=FAILURE)
        self.assertEqual(fetched.stdout, b"")
        self.assertRegex(fetched.stderr, "are wrong .* from (one|two), login mallory")
        self.assertEqual(self.status()["runs"][0]["state"], "open")
        coordinator = self.coordinator(request, "--check-share", "1", url=self.boss)
        self.worker(url=self.honest)
        for worker in workers:
            for first in self.claim(worker, 20):
                self.lie(worker, request, first)
        self.collect(coordinator, request)

    def test_workers_of_one_login_do_not_outvote_that_of_another(self):
        request = Request(10)
        self.farm("add", "-", "--check-share", "1", stdin=request.bytes(), url=self.boss)
        workers = [self.join(name) for name in "abcdef"]
        self.farm("work", "--name", "truth", "--seconds", "2", "--grace", "0.1", url=self.honest)
        for worker in workers:
            for first in self.claim(worker):
                self.lie(worker, request, first)
        self.assertEqual(self.sql("SELECT name FROM coapt_farm.worker WHERE barred"), [])
        self.assertIn(self.status()["runs"][0]["state"], ("open",))
        self.worker("--name", "truth", url=self.honest)
        coordinator = self.coordinator(request, "--check-share", "1", url=self.boss)
        self.worker("--name", "third", url=self.new_login("third", "coapt_worker"))
        self.collect(coordinator, request)
        self.assertNotIn(["truth"], self.sql("SELECT name FROM coapt_farm.worker WHERE barred"))

    def test_nobody_asks_for_one_thing_by_anothers_name(self):
        request, other = Request(30), Request(30, parts=["another valve"])
        names = [self.call(f"add_part('\\x{part.hex()}')", "carl")[0][0] for part in other.parts]
        told = "'toy', 'toy', '{" + ",".join(names) + "}', '', ''"
        with self.assertRaisesRegex(RuntimeError, "does not exist"):  # where a caller tells the name
            self.call(f"add_run('{work_id(request)}', {told}, 30, 10, 0)", "carl")
        run, work = self.call(f"add_run({told}, 30, 10, 0)", "carl")[0]
        self.assertEqual(work, work_id(other))
        for wrong in ("'toy', 'toy' || chr(10) || 'x'", "'toy', 'Toy!'"):
            with self.assertRaisesRegex(RuntimeError, "no request"):
                self.call(f"add_run({wrong}, '{{}}', '', '', 30, 10, 0)", "carl")
        with self.assertRaisesRegex(RuntimeError, "no request"):
            self.call("add_run('toy', 'toy', '{0123}', '', '', 30, 10, 0)", "carl")
        self.worker(url=self.honest)
        self.collect(self.coordinator(request, url=self.boss), request)

    def test_a_run_of_fewer_items_is_another_run(self):
        request = Request(30)
        names = [self.call(f"add_part('\\x{part.hex()}')", "carl")[0][0] for part in request.parts]
        self.call("add_run('toy', 'toy', '{" + ",".join(names) + "}', '', '', 10, 10, 0)", "carl")
        self.worker(url=self.honest)
        self.collect(self.coordinator(request, url=self.boss), request)

    def test_an_answer_to_other_work_under_the_number_of_a_run_is_not_taken(self):
        request = Request(10)
        self.farm("add", "-", stdin=request.bytes(), url=self.boss)
        worker = self.join("restored from a backup")
        self.assertEqual(self.claim(worker), [0])
        self.assertEqual(self.lie(worker, Request(10, parts=["another"]), 0), "unknown")

    def test_what_a_worker_holds_is_bounded(self):
        request = Request(1000)
        self.farm("add", "-", stdin=request.bytes(), url=self.boss)
        for lease_s in ("1e9", "3601", "0", "-1", "'NaN'", "'Infinity'", "NULL"):
            with self.assertRaisesRegex(RuntimeError, "a lease of"):
                self.join("long", lease_s)
        with self.assertRaisesRegex(RuntimeError, "names of workers"):
            self.join("x" * 201)
        worker = self.join("greedy", 3600)
        self.assertEqual(len(self.claim(worker, 1000)), 16)
        self.assertEqual(self.claim(worker, 1000), [])
        self.assertEqual(self.claim(worker, -5), [])

    def test_a_stranger_cannot_have_a_name_barred(self):
        request = Request(30)
        self.farm("add", "-", "--check-share", "1", stdin=request.bytes(), url=self.boss)
        worker = self.join("anna")
        for letter in (b"\0", b"\1"):
            for first in self.claim(worker, 1):
                self.lie(worker, request, first, letter)
        self.sql("UPDATE coapt_farm.worker SET barred = true WHERE login = 'mallory'")
        with self.assertRaisesRegex(RuntimeError, "barred"):
            self.join("anna")
        self.farm("work", "--until-dry", "--name", "anna", url=self.honest)
        self.assertGreater(self.done(), 0)

    def test_nothing_that_a_stranger_calls_itself_moves_the_terminal(self):
        bad = "E'\\x1b[2J\\x07\\u009b31m'"
        names = [self.call(f"add_part('\\x{part.hex()}')", "carl")[0][0] for part in Request(10).parts]
        self.call(f"add_run({bad}, 'toy', '{{{','.join(names)}}}', {bad}, '', 10, 10, 0)", "carl")
        worker = int(self.call(f"join_farm({bad}, {bad}, 1, {bad}, 60)")[0][0])
        for _ in range(3):
            for first in self.claim(worker):
                self.call(f"fail({worker}, 1, {first}, {bad})")
        told, metrics = self.farm("status", "--json"), self.farm("status", "--prometheus")
        self.assertEqual(json.loads(told.stdout)["runs"][0]["label"], "\x1b[2J\x07\u009b31m")
        self.assertIn('name=" [2J  31m"', metrics.stdout.decode())
        shown = [told, metrics, self.farm("status"), self.farm("work", "--until-dry")]
        shown += [self.farm("fetch", 1, "--tasks")]
        for run in shown:
            for text in (run.stdout, run.stderr.encode()):
                self.assertNotRegex(text, rb"[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")

    def test_an_answer_that_cannot_be_read_is_open_again(self):
        request = Request(30)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes(), url=self.boss)
        worker = self.join("liar")
        for first, answer in zip(self.claim(worker, 3), (b"", b"{}", b"\xff" * 79)):
            self.assertEqual(self.finish(worker, request, first, answer), "kept")
        self.claim(worker)
        coordinator = self.coordinator(request, "--recompute", "0", url=self.boss)
        self.worker(url=self.honest)
        self.assertIn("login mallory", self.collect(coordinator, request))
        self.assertEqual(self.farm("fetch", 1, url=self.boss).stdout, request.answers())

    def test_what_looks_wrong_is_computed_again_be_it_drawn_or_not(self):
        request = Request(30)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes(), url=self.boss)
        worker = self.join("liar")
        for first in self.claim(worker, 3):
            self.assertEqual(self.lie(worker, request, first), "kept")
        self.claim(worker)
        fetched = self.farm("fetch", 1, "--recompute", "0", url=self.boss, code=FAILURE)
        self.assertEqual(fetched.stdout, b"")
        self.assertIn("recomputed here, they differ", fetched.stderr)

    def test_what_looks_wrong_and_is_right_is_believed(self):
        request = Request(30, doubted=True)
        self.worker(url=self.honest)
        self.collect(self.coordinator(request, "--check-share", "0", "--recompute", "0", url=self.boss), request)

    def test_a_run_that_stays_wrong_is_told_and_not_printed(self):
        request = Request(10)
        for i in range(4):
            self.worker("--name", f"wrong {i}", TOY_FLIP="1", url=self.honest)
        run = self.run_farm("add", "-", "--wait", "--check-share", "0", stdin=request.bytes(), url=self.boss)
        self.assertEqual((run.returncode, run.stdout), (FAILURE, b""))
        self.assertEqual(run.stderr.count("are wrong"), 4)

    def test_a_farm_of_the_version_before_is_brought_up_to_date(self):
        self.sql(
            "UPDATE coapt_farm.schema_version SET number = 1; DROP TABLE coapt_farm.distrust;"
            "ALTER TABLE coapt_farm.run DROP CONSTRAINT run_work_id_revision_team_items_task_items_key;"
            "ALTER TABLE coapt_farm.run ADD UNIQUE (work_id, revision, team)"
        )
        self.assertIn("coapt-farm init", self.farm("status", code=FAILURE).stderr)
        self.farm("init")
        request = Request(30)
        self.worker()
        self.collect(self.coordinator(request), request)


if __name__ == "__main__":
    unittest.main()
