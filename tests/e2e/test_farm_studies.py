"""Studies and searches whose work a farm does: the same files, bit for bit, as those made here."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import unittest

from process_runs import HANGS_S
from programs import BAD_INPUT, COAPT, FAILURE, INTERRUPTED, NO_COMPETENT_PLAN, OK, SERVER, SOURCE, ProgramTest, coapt

sys.path[:0] = [str(SOURCE / "tests" / "farm"), str(SOURCE / "tests" / "service")]

from private_postgres import PrivatePostgres, tool  # noqa: E402
from served import Server  # noqa: E402

FARM = str(pathlib.Path(COAPT).with_name("coapt-farm"))
QUICK = [
    "--evaluations",
    3,
    "--plans",
    1,
    "--region-points",
    1,
    "--fine-levels",
    0,
    "--model-draws",
    0,
    "--no-evidence",
]


def files(folder):
    """All but the closures, whose order is that of their making."""
    return {
        path.name: path.read_bytes()
        for path in folder.iterdir()
        if path.is_file() and not path.name.startswith("closures.sqlite")
    }


@unittest.skipUnless(tool("initdb"), "PostgreSQL is not installed")
class FarmStudies(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.postgres = PrivatePostgres()
        cls.addClassCleanup(cls.postgres.remove)
        cls.postgres.sql("postgres", "CREATE DATABASE farm")
        cls.url = cls.postgres.url("farm")
        subprocess.run([FARM, "init", "--db", cls.url], check=True, stdout=subprocess.DEVNULL)
        for _ in range(2):
            worker = subprocess.Popen(
                [FARM, "work", "--db", cls.url, "--threads", "1", "--quiet"],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            cls.addClassCleanup(worker.wait)
            cls.addClassCleanup(worker.kill)

    def by_farm(self, *arguments, status=OK):
        result = coapt(*arguments, "--farm", self.url)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def assert_same_files(self, here, there):
        one, other = files(here), files(there)
        self.assertEqual(set(one), set(other))
        for name, content in one.items():
            self.assertEqual(other[name], content, name)

    def test_a_study_leaves_the_same_files(self):
        here, there = self.folder / "here", self.folder / "there"
        for study in ["annulus", "ring"]:
            one = json.loads(self.run_ok("study", study, "human-functional-mr", "-o", here, "--json").stdout)
            other = json.loads(self.by_farm("study", study, "human-functional-mr", "-o", there, "--json").stdout)
            self.assertEqual(other | {"seconds": 0}, one | {"seconds": 0}, study)
            self.assert_same_files(here, there)
        again = json.loads(self.by_farm("study", "annulus", "human-functional-mr", "-o", there, "--json").stdout)
        self.assertEqual(again["closures"], again["closures_known"], "kept here, too")

    def test_anatomies_leave_the_same_files(self):
        here, there = self.folder / "here", self.folder / "there"
        # None of these is competent, which is known by one closure each: others take thousands.
        anchors = ["study", "anchors", "--anatomies", 1, "--seed", 3, "--region-points", 17]
        self.run_ok(*anchors, "-o", here)
        self.by_farm(*anchors, "-o", there)
        self.assert_same_files(here, there)

    def test_plans_of_several_valves_are_the_same(self):
        here, there = self.folder / "here", self.folder / "there"
        valve = self.make("human-normal")
        plan = ["plan", "human-functional-mr", valve, valve, *QUICK]
        one = coapt(*plan, "-o", here)
        self.assertEqual(one.returncode, NO_COMPETENT_PLAN, one.stderr)
        self.by_farm(*plan, "-o", there, status=NO_COMPETENT_PLAN)
        self.assert_same_files(here, there)
        names = {
            f"{name}.{kind}"
            for name in ["human-functional-mr", "human-normal", "human-normal-2"]
            for kind in ["json", "html"]
        }
        self.assertEqual(set(files(here)), names | {"summary.csv"})
        of_one = json.loads(coapt("plan", "human-functional-mr", *QUICK, "--json").stdout)
        of_many = json.loads((here / "human-functional-mr.json").read_text())
        self.assertEqual(of_many, of_one | {"seconds": None})
        alone = json.loads(coapt("plan", "human-functional-mr", *QUICK, "--json", "--farm", self.url).stdout)
        self.assertEqual(alone, of_many)

    def test_imports_of_a_folder_are_the_same(self):
        maps = self.folder / "maps"
        maps.mkdir()
        valve = self.make("human-normal")
        self.run_ok("export", valve, "--open", "-o", maps / "sound.nrrd")
        (maps / "damaged.nrrd").write_bytes((maps / "sound.nrrd").read_bytes()[:-40])
        here, there = self.folder / "here", self.folder / "there"
        study = ["study", "imports", maps, "--evaluations", 3, "--json"]
        one = json.loads(self.run_ok(*study, "-o", here).stdout)
        self.assertEqual((one["stages"]["refused"], one["stages"]["imported"]), (1, 0))
        self.assertEqual(json.loads(self.by_farm(*study, "-o", there).stdout), one)
        self.assert_same_files(here, there)
        self.assertEqual(
            (here / "valves/sound.nrrd.json").read_bytes(), (there / "valves/sound.nrrd.json").read_bytes()
        )

    def test_a_service_hands_its_jobs_to_the_farm(self):
        server = Server(SERVER, self.folder / "jobs.sqlite", "--farm", self.url)
        self.addCleanup(server.stop)
        service = ["--server", f"http://127.0.0.1:{server.port}"]
        runs = "SELECT count(*) FROM coapt_farm.run"
        before = int(self.postgres.sql("farm", runs)[0][0])
        here, there, report = self.folder / "here", self.folder / "there", self.folder / "report.html"
        plan = ["plan", "human-functional-mr", *QUICK, "--seed", 2, "--json"]
        one = json.loads(coapt(*plan).stdout)
        other = coapt(*plan, *service, "-o", report)
        self.assertEqual(other.returncode, NO_COMPETENT_PLAN, other.stderr)
        self.assertEqual(json.loads(other.stdout) | {"seconds": 0}, one | {"seconds": 0})
        self.assertIn("including ranking", report.read_text())
        self.run_ok("study", "annulus", "human-p2-prolapse", "-o", here)
        self.run_ok("study", "annulus", "human-p2-prolapse", "-o", there, *service)
        self.assert_same_files(here, there)
        self.assertEqual(int(self.postgres.sql("farm", runs)[0][0]), before + 2)

    def test_an_interrupted_search_ends_and_leaves_its_work_to_the_farm(self):
        running = subprocess.Popen(
            # So few evaluations, because a worker ends what it has begun, cancelled or not.
            [
                COAPT,
                "plan",
                "human-functional-mr",
                "--evaluations",
                "100",
                *map(str, QUICK[2:]),
                "--seed",
                "7",
                "--farm",
                self.url,
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        runs = "SELECT count(*) FROM coapt_farm.run WHERE kind = 'plans' AND state = 'open'"
        while self.postgres.sql("farm", runs) == [["0"]]:
            self.assertIsNone(running.poll())
        running.send_signal(signal.SIGTERM)
        _, said = running.communicate(timeout=HANGS_S)
        self.assertEqual(running.returncode, INTERRUPTED, said)
        self.assertIn("the farm keeps the work", said)
        ((run,),) = self.postgres.sql("farm", "SELECT max(id) FROM coapt_farm.run WHERE kind = 'plans'")
        subprocess.run([FARM, "cancel", run, "--db", self.url], check=True, stdout=subprocess.DEVNULL)


class Refused(ProgramTest):
    def refused(self, status, *arguments, **environment):
        result = subprocess.run(
            [COAPT, *map(str, arguments)], capture_output=True, text=True, env=os.environ | environment, timeout=HANGS_S
        )
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stderr

    def test_several_valves_need_a_directory_and_know_no_store(self):
        several = ["plan", "human-normal", "human-functional-mr"]
        self.assertIn("-o DIR", self.refused(BAD_INPUT, *several))
        said = self.refused(BAD_INPUT, *several, "-o", self.folder, "--store", "s", "--seconds", 9, "--json")
        for option in ["--store", "--seconds", "--json"]:
            self.assertIn(option, said)
        self.assertIn("no-such", self.refused(BAD_INPUT, "plan", "no-such", "human-normal", "-o", self.folder))
        self.assertIn(
            "one valve", self.refused(BAD_INPUT, *several, "-o", self.folder, "--server", "http://127.0.0.1:9")
        )

    def test_a_farm_that_is_not_there_or_a_server_beside_it(self):
        folder = self.folder / "study"
        said = self.refused(
            FAILURE, "study", "annulus", "human-normal", "-o", folder, COAPT_FARM="postgresql://nobody@/x?host=/nowhere"
        )
        self.assertIn("/nowhere", said)
        said = self.refused(
            BAD_INPUT, "study", "annulus", "human-normal", "--farm", "postgresql:///x", "--server", "http://127.0.0.1:9"
        )
        self.assertIn("--farm", said)


if __name__ == "__main__":
    unittest.main()
