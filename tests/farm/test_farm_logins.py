"""Who may do what: coordinators, workers, readers, teams, and those without a password."""

import unittest

from farm_runs import FAILURE, OK, FarmTest, Request, wait_until


class Logins(FarmTest):
    def setUp(self):
        super().setUp()
        self.farm("init", "--team", "heart")
        self.new_login("asks", "coapt_coordinator", "coapt_team_heart")
        self.new_login("works", "coapt_worker")
        self.new_login("heartworks", "coapt_worker", "coapt_team_heart")
        self.new_login("reads", "coapt_reader")

    def login(self, name, password=None):
        return self.postgres.url(self.name, name, password or f"pw-{name}")

    def test_a_wrong_password_is_refused_and_not_repeated(self):
        for url in (self.login("works", "guessed"), self.postgres.url(self.name, "works")):
            run = self.run_farm("work", "--until-dry", url=url, PGPASSWORD="")
            self.assertEqual(run.returncode, FAILURE)
            self.assertIn("password", run.stderr)
            self.assertNotIn("guessed", run.stderr)
        broken = self.run_farm("status", url="postgresql://works:guessed@/farm?colour=red")
        self.assertNotIn("guessed", broken.stderr)

    def test_workers_and_readers_may_not_ask(self):
        for login in ("works", "reads"):
            run = self.run_farm("add", "-", url=self.login(login), stdin=Request(1).bytes())
            self.assertEqual(run.returncode, FAILURE)
            self.assertIn("permission denied", run.stderr)
        self.assertEqual(self.run_farm("work", "--until-dry", url=self.login("reads")).returncode, FAILURE)
        self.farm("status", url=self.login("reads"))

    def test_nobody_reads_tables(self):
        for login in ("asks", "works", "reads"):
            for table in ("blob", "run", "task", "result", "worker", "opinion", "fault", "distrust"):
                with self.assertRaisesRegex(RuntimeError, "permission denied"):
                    self.sql(f"SELECT * FROM coapt_farm.{table}", user=login, password=f"pw-{login}")

    def test_functions_that_others_are_made_of_are_nobodys(self):
        for call in ("bar(1, 1, 1, '')", "end_run(1)", "expire(1)", "this_run(1)", "this_worker(1)"):
            with self.assertRaisesRegex(RuntimeError, "permission denied"):
                self.sql(f"SELECT coapt_farm.{call}", user="works", password="pw-works")

    def test_a_team_keeps_its_runs_to_itself(self):
        request = Request(30)
        asks = self.login("asks")
        self.farm("add", "-", "--team", "heart", stdin=request.bytes(), url=asks)
        self.farm("work", "--until-dry", url=self.login("works"))
        self.assertEqual(self.done(), 0)
        self.assertIn(b"no runs\n", self.farm("status", url=self.login("reads")).stdout)
        self.farm("work", "--until-dry", url=self.login("heartworks"))
        self.assertEqual(self.farm("fetch", 1, url=asks).stdout, request.answers())
        self.farm("add", "-", "--team", "lung", stdin=request.bytes(), url=asks, code=FAILURE)

    def test_parts_and_tasks_of_others_are_out_of_reach(self):
        request = Request(3, task_items=1, ms=100_000)
        self.farm("add", "-", "--team", "heart", stdin=request.bytes(), url=self.login("asks"))
        worker = self.start("work", "--grace", "0.1", url=self.login("heartworks"))
        claimed = "SELECT count(*) FROM coapt_farm.task WHERE state = 'claimed'"
        wait_until(lambda: self.number(claimed) == 2)
        part = self.sql("SELECT sha256 FROM coapt_farm.blob LIMIT 1")[0][0]
        mine = self.sql("SELECT coapt_farm.join_farm('x', 'x', 1, 'toy', 60)", user="works", password="pw-works")[0][0]
        theirs = self.sql("SELECT id FROM coapt_farm.worker WHERE login = 'heartworks'")[0][0]
        for call, said in (
            (f"read_part({theirs}, 1, '{part}')", "not known"),
            (f"read_part({mine}, 1, '{part}')", "only while"),
            (f"finish({mine}, 1, 0, 'w', 1, 'x')", "not for this worker"),
            (f"finish({theirs}, 1, 0, 'w', 1, 'x')", "not known"),
            ("doubt(1, 0, 'because')", "permission denied"),
            ("part_of(1, 'x')", "permission denied"),
        ):
            with self.assertRaisesRegex(RuntimeError, said):
                self.sql(f"SELECT coapt_farm.{call}", user="works", password="pw-works")
        self.assertEqual(self.sql(f"SELECT * FROM coapt_farm.claim({mine}, 9)", user="works", password="pw-works"), [])
        worker.terminate()
        self.assertEqual(worker.wait(30), OK)


if __name__ == "__main__":
    unittest.main()
