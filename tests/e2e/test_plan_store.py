"""coapt plan --store: closures kept in a file, so that none is made twice."""

import contextlib
import json
import os
import signal
import sqlite3
import subprocess
import time
import unittest

from plan_runs import BARE, VALVE, options, rows, without_machine
from process_runs import HANGS_S
from programs import BAD_INPUT, COAPT, FAILURE, NO_COMPETENT_PLAN, OK, ProgramTest, coapt, small_valve


class Store(ProgramTest):
    def setUp(self):
        super().setUp()
        self.store = self.folder / "closures.sqlite"

    def plan(self, *arguments, valve=None, **changes):
        result = coapt("plan", valve or small_valve(), *options(**BARE | changes), *arguments, "--json")
        self.assertIn(result.returncode, [OK, NO_COMPETENT_PLAN], result.stderr)
        return json.loads(result.stdout)

    def kill_when(self, closures, command):
        """Kills the search when so many closures are kept; returns how many there were then."""
        with subprocess.Popen(command, stdout=subprocess.DEVNULL) as search:
            while search.poll() is None and len(rows(self.store)) < closures:
                time.sleep(0.02)
            search.kill()
        self.assertEqual(search.returncode, -signal.SIGKILL)
        return len(rows(self.store))

    def test_a_search_that_is_killed_twice_goes_on_to_the_same_answer_and_closes_nothing_twice(self):
        size = {"evaluations": 50, "region_points": 17, "fine_levels": 1, "model_draws": 8}
        whole = self.plan(valve=VALVE, **size)
        command = [COAPT, "plan", VALVE, *options(threads=1, **size), "--store", self.store]
        searching = self.kill_when(20, command)
        ranking = self.kill_when(55, command)
        self.assertLess(searching, 50)
        self.assertLess(ranking, whole["closures"] - 1)

        resumed = self.plan("--store", self.store, valve=VALVE, threads=2, **size)
        self.assertEqual(without_machine(resumed), without_machine(whole))
        self.assertEqual(resumed["closures_known"], ranking)
        kept = rows(self.store)
        self.assertEqual(len({row[:3] for row in kept}), len(kept))
        # All but the valve as it is; that one is of no plan.
        self.assertEqual(len(kept), resumed["closures"] - 1)

        again = self.plan("--store", self.store, valve=VALVE, **size)
        self.assertEqual(without_machine(again), without_machine(whole))
        self.assertEqual(again["closures_known"], again["closures"] - 1)
        self.assertEqual(rows(self.store), kept)

    def test_another_search_takes_what_it_shares_and_another_valve_nothing(self):
        first = self.plan("--store", self.store, evaluations=4)
        second = self.plan("--store", self.store, evaluations=20)
        self.assertEqual(without_machine(second), without_machine(self.plan(evaluations=20)))
        self.assertGreater(second["closures_known"], 0)
        self.assertEqual(
            len(rows(self.store)), first["closures"] - 1 + second["closures"] - 1 - second["closures_known"]
        )
        other = self.plan("--store", self.store, valve=small_valve("human-p2-prolapse"))
        self.assertEqual(other["closures_known"], 0)

    def test_own_plans_are_known_from_a_search(self):
        search = self.plan("--store", self.store)
        own = self.write("own.json", search["plans"][0]["plan"])
        result = coapt(
            "evaluate", small_valve(), own, "--region-points", "2", "--no-evidence", "--json", "--store", self.store
        )
        answer = json.loads(result.stdout)
        self.assertEqual((answer["closures"], answer["closures_known"]), (3, 2))
        self.assertEqual(answer["plans"][0]["cost"], search["plans"][0]["cost"])

    def test_two_searches_at_once_share_a_store(self):
        command = [COAPT, "plan", small_valve(), *options(evaluations=20, **BARE), "--json", "--store", self.store]
        both = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(2)]
        answers = [json.loads(search.communicate(timeout=HANGS_S)[0]) for search in both]
        self.assertEqual(*map(without_machine, answers))
        self.assertEqual(len(rows(self.store)), answers[0]["closures"] - 1)

    def locked(self, lock, **changes):
        """coapt plan while another connection holds a lock."""
        with contextlib.closing(sqlite3.connect(self.store, isolation_level=None)) as other:
            for statement in lock:
                other.execute(statement)
            return coapt("plan", small_valve(), *options(**changes), "--store", self.store, "--json")

    def test_a_store_that_is_locked_in_the_search_is_1_and_loses_nothing(self):
        self.plan("--store", self.store, valve=small_valve("human-p2-prolapse"), evaluations=2)
        before = rows(self.store)
        result = self.locked(["BEGIN EXCLUSIVE"], evaluations=1, region_points=1)
        self.assertEqual((result.returncode, result.stdout), (FAILURE, ""))
        self.assertEqual(result.stderr, f"coapt: {self.store}: a closure cannot be kept: database is locked\n")
        self.assertEqual(rows(self.store), before)
        self.assertEqual(without_machine(self.plan("--store", self.store)), without_machine(self.plan()))

    def test_a_store_that_is_locked_from_the_start_is_1_and_said(self):
        self.plan("--store", self.store)
        before = rows(self.store)
        result = self.locked(["PRAGMA locking_mode = EXCLUSIVE", "BEGIN EXCLUSIVE"])
        self.assertEqual(result.stdout, "")
        self.assertIn(f"{self.store}: cannot be opened: database is locked\n", result.stderr)
        self.assertEqual(result.returncode, FAILURE)
        self.assertEqual(rows(self.store), before)

    def test_a_file_that_is_no_store_is_refused_and_left_as_it_was(self):
        database = self.folder / "other.sqlite"
        with contextlib.closing(sqlite3.connect(database)) as other:
            other.execute("CREATE TABLE patients (name)")
            other.commit()
        for path in [self.write("notes.txt", "not to be lost\n"), self.make("human-normal"), database]:
            with self.subTest(path.name):
                before = path.read_bytes()
                for command in [
                    ["plan", VALVE],
                    ["evaluate", VALVE, self.write("p.json", {"schema": "coapt.plan/1", "steps": []})],
                ]:
                    result = coapt(*command, "--store", path, "--json")
                    self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
                    self.assertIn(f"{path}: is not a store of plans", result.stderr)
                self.assertEqual(path.read_bytes(), before)
        self.assertEqual(list(self.folder.glob("*-wal")) + list(self.folder.glob("*-shm")), [])

    def test_a_store_without_a_place_is_refused_before_the_search(self):
        for path in ["/nowhere/store.sqlite", self.folder]:
            with self.subTest(path):
                result = coapt("plan", VALVE, "--evaluations", "100000", "--store", path, "--json")
                self.assertIn(result.returncode, [FAILURE, BAD_INPUT])
                self.assertEqual(result.stdout, "")
                self.assertIn(f"{path}: cannot be opened", result.stderr)

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_store_that_cannot_be_written_is_refused_before_the_search(self):
        self.plan("--store", self.store)
        self.store.chmod(0o400)
        result = coapt("plan", VALVE, "--evaluations", "100000", "--store", self.store, "--json")
        self.assertIn(result.returncode, [FAILURE, BAD_INPUT])
        self.assertIn(f"{self.store}: is read-only", result.stderr)


if __name__ == "__main__":
    unittest.main()
