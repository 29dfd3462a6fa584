"""coapt study."""

import atexit
import csv
import functools
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

from process_runs import wait_until
from programs import BAD_INPUT, COAPT, FAILURE, ProgramTest, coapt, small_valve

VALVE = "human-normal"
CONFIGURATIONS = 5 * 31
RING_CONFIGURATIONS = 4 * (3 * (4**3 - 1) + 1)  # sizes x (classes x displacements + none)
RING_LATTICE = 4 * 3 * (3**3 - 2**3)  # what these start from, at 3 mm, and nobody asks for
TABLES = ["annulus.csv", "annulus.svg", "findings.json", "index.html", "study.json"]
OF_THE_RUN = ["closures_known", "seconds"]  # in no file


def contents(folder):
    return {name: (folder / name).read_bytes() for name in TABLES}


def without_run(summary):
    return {key: value for key, value in summary.items() if key not in OF_THE_RUN}


def closures_kept(folder):
    """Rows of the store; 0 if there is none yet."""
    try:
        store = sqlite3.connect(f"file:{folder / 'closures.sqlite'}?mode=ro", uri=True)
    except sqlite3.OperationalError:
        return 0
    try:
        return store.execute("SELECT count(*) FROM closures").fetchone()[0]
    except sqlite3.OperationalError:  # no table yet, or locked
        return 0
    finally:
        store.close()


def study(kind, valve, folder, *arguments):
    """Its summary."""
    result = coapt("study", kind, valve, "-o", folder, "--json", *arguments)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


@functools.cache
def undisturbed():
    """The summary of a study that several tests read, and its folder: to be copied before anything is added."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="coapt-study-"))
    atexit.register(shutil.rmtree, folder)
    return study("annulus", VALVE, folder, "--threads", "2"), folder


class Annulus(ProgramTest):
    def copy(self):
        """Of the folder of undisturbed()."""
        return shutil.copytree(undisturbed()[1], self.folder / "study")

    def test_summary_tables_and_findings_have_what_scripts_rely_on(self):
        summary, folder = undisturbed()
        self.assertEqual(summary["valve"], VALVE)
        self.assertEqual(summary["configurations"], CONFIGURATIONS)
        self.assertEqual((summary["closures"], summary["closures_known"]), (CONFIGURATIONS, 0))
        self.assertEqual(summary["untrusted"], 0)
        self.assertGreater(summary["seconds"], 0.0)
        self.assertEqual(summary["study"], "annulus")
        self.assertEqual(summary["version"], coapt("--version").stdout.split()[1])
        self.assertEqual(json.loads((folder / "study.json").read_text()), without_run(summary))
        with open(folder / "annulus.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), CONFIGURATIONS)
        self.assertEqual({row["annular_height_percent"] for row in rows}, {"100", "75", "50", "25", "0"})
        undilated = [row for row in rows if row["ap_dilation_percent"] == "0"][0]
        self.assertLess(float(undilated["orifice_mm2"]), 5.0)
        xml.etree.ElementTree.parse(folder / "annulus.svg")
        self.assertIn("findings", (folder / "index.html").read_text())
        findings = json.loads((folder / "findings.json").read_text())
        self.assertEqual(len(findings), summary["findings"])
        self.assertEqual(sum(finding["agrees"] for finding in findings), summary["agree"])
        for finding in findings:
            for key in ["finding", "section", "thesis", "ours", "judged"]:
                self.assertIsInstance(finding[key], str, key)
            self.assertIsInstance(finding["agrees"], bool)

    def test_a_second_run_closes_nothing_and_writes_the_same(self):
        folder = self.copy()
        first = contents(folder)
        again = study("annulus", VALVE, folder)
        self.assertEqual((again["closures"], again["closures_known"]), (CONFIGURATIONS, CONFIGURATIONS))
        self.assertEqual(again["configurations"], CONFIGURATIONS)
        self.assertEqual(contents(folder), first)

    def test_a_study_counts_only_its_own_configurations(self):
        folder, valve = self.folder / "shared", small_valve(VALVE)
        study("annulus", valve, folder)
        ring = study("ring", valve, folder)
        self.assertEqual(ring["study"], "ring")
        self.assertEqual(ring["configurations"], RING_CONFIGURATIONS)
        self.assertEqual((ring["closures"], ring["closures_known"]), (RING_CONFIGURATIONS, 1))  # undisturbed in both
        self.assertEqual(closures_kept(folder), CONFIGURATIONS + RING_CONFIGURATIONS - 1 + RING_LATTICE)
        self.assertEqual(json.loads((folder / "study.json").read_text()), without_run(ring))

    def test_the_directory_is_named_after_the_study_if_none_is_given(self):
        for name in ["annulus", "thesis", "calibrate", "anchors", "generality", "model"]:
            self.assertIn(f"study-{name}", self.run_ok("study", name, "--help").stdout)

    def test_threads_do_not_change_a_byte(self):
        one = self.folder / "one"
        study("annulus", VALVE, one, "--threads", "1")
        self.assertEqual(contents(one), contents(undisturbed()[1]))

    def test_a_killed_study_goes_on_where_it_was(self):
        folder = self.folder / "killed"
        running = subprocess.Popen(
            [COAPT, "study", "annulus", VALVE, "-o", folder, "--threads", "1"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        wait_until(lambda: closures_kept(folder) > 0 or running.poll() is not None)
        running.send_signal(signal.SIGKILL)
        running.wait()
        self.assertEqual(running.returncode, -signal.SIGKILL, "it ended before it was killed")
        kept = closures_kept(folder)
        self.assertGreater(kept, 0)
        self.assertLess(kept, CONFIGURATIONS)
        rest = study("annulus", VALVE, folder)
        self.assertEqual((rest["closures"], rest["closures_known"]), (CONFIGURATIONS, kept))
        self.assertEqual(contents(folder), contents(undisturbed()[1]))


PARAMETERS = [
    "bending rigidity",
    "insertion zone",
    "leaflet thickness",
    "moduli below the transition",
    "moduli above the transition",
    "circumferential transition",
    "radial transition",
    "chordal modulus",
    "chordal length",
]


class Model(ProgramTest):
    def study(self, name, *arguments):
        folder = self.folder / name
        return study("model", "human-functional-mr", folder, *arguments), folder

    def test_areas_parameters_and_draws_have_what_scripts_rely_on(self):
        found, folder = self.study("model", "--draws", "24", "--threads", "2")
        self.assertEqual((found["schema"], found["valve"]), ("coapt.model_study/2", "human-functional-mr"))
        self.assertEqual((found["draws"], found["untrusted"]), (24, 0))
        self.assertEqual(json.loads((folder / "model.json").read_text()), found)
        leak = found["leak"]
        self.assertLess(leak["p5_mm2"], leak["mean_mm2"])
        self.assertLess(leak["mean_mm2"], leak["p95_mm2"])
        self.assertGreater(leak["sd_mm2"], 1.0)
        self.assertEqual([parameter["name"] for parameter in leak["parameters"]], PARAMETERS)
        for parameter in leak["parameters"]:
            self.assertLess(parameter["lower"], 1.0)
            self.assertGreater(parameter["upper"], 1.0)
            self.assertLessEqual(parameter["first"], parameter["total"] + 1e-9)
        with open(folder / "draws.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 24)
        self.assertEqual(list(rows[0])[:9], PARAMETERS)
        self.assertIn("Distribution of the leak", (folder / "index.html").read_text())
        one, _ = self.study("one", "--draws", "24", "--threads", "1")
        self.assertEqual(one, found)

    def test_a_plan_is_applied_first_and_the_table_says_the_models_error(self):
        plan = self.write(
            "ring.json",
            '{"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": 3}]}',
        )
        bare, _ = self.study("bare", "--draws", "3")
        ringed, _ = self.study("ringed", "--draws", "3", "--plan", plan)
        self.assertLess(ringed["leak"]["as_it_is_mm2"], bare["leak"]["as_it_is_mm2"])
        words = self.run_ok("study", "model", VALVE, "--draws", "3", "-o", self.folder / "words").stdout
        self.assertRegex(words, r"\nmm2 +nominal +mean +tissue ± +5 % +95 %\nleak +\d")

    def test_too_few_draws_are_refused(self):
        result = coapt("study", "model", VALVE, "--draws", "0")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--draws", result.stderr)


class Physiology(ProgramTest):
    def test_each_row_has_its_range_source_and_verdict(self):
        told = json.loads(self.run_ok("study", "physiology", small_valve("human-normal"), "--json").stdout)
        self.assertEqual(told["schema"], "coapt.physiology/1")
        self.assertEqual((told["kind"], told["kind_judged"], told["species"]), ("healthy", True, "human"))
        rows = {row["quantity"]: row for row in told["rows"]}
        self.assertLessEqual(
            {"leak", "tenting_area", "struts_cut_ratio", "leak_200", "ring_34", "opening", "clip_share"}, set(rows)
        )
        for row in rows.values():
            with self.subTest(row["quantity"]):
                keys = ["high", "low", "quantity", "source", "unit", "value", "verdict", "what"]
                self.assertEqual(sorted(row), keys)
                if row["low"] is None:
                    self.assertIn(row["verdict"], ("no range", "unknown"))
                elif row["value"] is not None:
                    side = "below" if row["value"] < row["low"] else "above" if row["value"] > row["high"] else "met"
                    self.assertEqual(row["verdict"], side)

    def test_ranges_are_of_the_kind_that_is_said(self):
        words = self.run_ok("study", "physiology", small_valve("human-normal"), "--kind", "functional").stdout
        self.assertIn("functional, human (inferred)", words)
        self.assertRegex(words, r"Leak at the valve's own pressure +\S+ +20 +60 +mm2 +below")


class Refused(ProgramTest):
    def refused(self, status, *arguments):
        result = coapt("study", *arguments)
        self.assertEqual((result.returncode, result.stdout), (status, ""), result.stderr)
        return result.stderr

    def test_an_unknown_valve(self):
        folder = self.folder / "new"
        self.assertIn("no-such-valve", self.refused(BAD_INPUT, "annulus", "no-such-valve", "-o", folder))
        self.assertFalse(folder.exists())

    def test_an_impossible_number_of_threads(self):
        self.assertIn("--threads", self.refused(BAD_INPUT, "annulus", VALVE, "--threads", "-1"))

    def test_a_study_or_protocol_that_does_not_exist(self):
        self.refused(BAD_INPUT)
        self.refused(BAD_INPUT, "weather", VALVE)
        self.assertIn("--protocol", self.refused(BAD_INPUT, "approximation", VALVE, "--protocol", "guessed"))

    def test_a_directory_that_cannot_be_made(self):
        self.assertIn("/proc/nowhere", self.refused(FAILURE, "annulus", VALVE, "-o", "/proc/nowhere"))
        taken = self.write("taken", "a file")
        self.assertIn(str(taken), self.refused(FAILURE, "annulus", VALVE, "-o", taken))

    def test_a_file_of_closures_that_is_none_is_left_as_it_is(self):
        garbage = b"not a database, but somebody's letter\n" * 50
        (self.folder / "closures.sqlite").write_bytes(garbage)
        self.assertIn("closures.sqlite", self.refused(FAILURE, "annulus", VALVE, "-o", self.folder))
        self.assertEqual((self.folder / "closures.sqlite").read_bytes(), garbage)
        self.assertEqual(os.listdir(self.folder), ["closures.sqlite"])


if __name__ == "__main__":
    unittest.main()
