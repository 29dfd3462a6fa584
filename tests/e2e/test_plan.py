"""coapt plan."""

import json
import signal
import subprocess
import time
import unittest

from programs import BAD_INPUT, COAPT, FAILURE, INTERRUPTED, NO_COMPETENT_PLAN, OK, SOURCE, ProgramTest, coapt

VALVE = "human-functional-mr"
SMALL = ["--evaluations", "12", "--seed", "3", "--plans", "2", "--region-points", "2"]


def without_seconds(value):
    """`value` without what depends on the machine."""
    if isinstance(value, dict):
        return {k: without_seconds(v) for k, v in value.items() if k not in ("seconds", "threads")}
    if isinstance(value, list):
        return [without_seconds(entry) for entry in value]
    return value


class Plan(ProgramTest):
    def plan(self, *arguments):
        result = coapt("plan", VALVE, *SMALL, *arguments, "--json")
        self.assertIn(result.returncode, [OK, NO_COMPETENT_PLAN], result.stderr)
        self.assertEqual(result.stderr, "")
        return json.loads(result.stdout), result.returncode

    def test_the_ranking_is_the_same_for_one_and_two_threads_and_can_be_closed_again(self):
        one, code = self.plan("--threads", "1")
        two, _ = self.plan("--threads", "2")
        self.assertEqual(without_seconds(one), without_seconds(two))

        self.assertGreater(one["before"]["orifice_area_mm2"], 5.0)
        self.assertGreaterEqual(one["closures"], 12)
        self.assertIsInstance(one["seconds"], (int, float))
        self.assertEqual([plan["rank"] for plan in one["plans"]], [1, 2])
        best = one["plans"][0]
        self.assertEqual(set(best["orifice_area_mm2"]) & {"nominal", "mean", "sd"},
                         {"nominal", "mean", "sd"})
        competent = any(plan["orifice_area_mm2"]["nominal"] < 1.0 for plan in one["plans"])
        self.assertLessEqual(code == OK, competent)

        closed = coapt("close", VALVE, "--plan", self.write("plan.json", best["plan"]), "--json")
        self.assertEqual(json.loads(closed.stdout)["orifice_area_mm2"],
                         best["orifice_area_mm2"]["nominal"])

    def test_the_closures_are_those_that_the_help_adds_up(self):
        arguments = ["--evaluations", "40", "--plans", "1", "--region-points", "7", "--json"]
        result = json.loads(coapt("plan", VALVE, *arguments).stdout)
        self.assertEqual(result["evaluations"], 40)
        self.assertEqual(result["closures"], 1 + 40 + 2 * 4 + 2)

    def test_the_report_is_one_page_with_the_pictures_in_it(self):
        report = self.folder / "report.html"
        self.plan("-o", report)
        page = report.read_text()
        self.assertIn("data:image/png;base64,", page)
        self.assertNotIn('src="http', page)
        self.assertIn("not a medical device", page)

    def test_a_report_without_a_place_is_refused_before_the_search(self):
        for path, code in [("/nowhere/r.html", FAILURE), ("-", BAD_INPUT)]:
            with self.subTest(path):
                result = coapt("plan", VALVE, "--evaluations", "100000", "--json", "-o", path)
                self.assertEqual((result.returncode, result.stdout), (code, ""))
                self.assertIn(path, result.stderr)

    def test_a_path_that_was_only_tested_is_left_as_it_was(self):
        old, new = self.write("old.html", "old"), self.folder / "new.html"
        for path in [old, new]:
            with subprocess.Popen([COAPT, "plan", VALVE, "--evaluations", "100000", "-o", path],
                                  stdout=subprocess.DEVNULL) as search:
                time.sleep(1)
                search.kill()
        self.assertEqual(old.read_text(), "old")
        self.assertFalse(new.exists())

    def test_ctrl_c_prints_the_best_so_far(self):
        command = [COAPT, "plan", VALVE, "--evaluations", "100000", "--json"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as search:
            time.sleep(3)
            search.send_signal(signal.SIGINT)
            output, _ = search.communicate(timeout=60)
        self.assertEqual(search.returncode, INTERRUPTED)
        self.assertIn("before", json.loads(output))

    def test_a_second_ctrl_c_ends_a_long_closure_at_once(self):
        valve = self.folder / "fine.json"
        coapt("valve", "make", "human-functional-mr", "--triangles", "10400", "-o", valve)
        with subprocess.Popen([COAPT, "plan", valve], stdout=subprocess.PIPE, text=True) as search:
            time.sleep(1)
            search.send_signal(signal.SIGINT)
            time.sleep(0.05)
            self.assertIsNone(search.poll())
            search.send_signal(signal.SIGINT)
            output, _ = search.communicate(timeout=60)
        self.assertEqual((search.returncode, output), (-signal.SIGINT, ""))

    def test_a_plan_that_was_not_re_scored_has_no_region(self):
        arguments = ["plan", VALVE, "--evaluations", "3", "--plans", "1", "--region-points", "1"]
        orifice = json.loads(coapt(*arguments, "--json").stdout)["plans"][0]["orifice_area_mm2"]
        self.assertIsInstance(orifice["nominal"], float)
        self.assertEqual([orifice[key] for key in ["mean", "sd", "worst"]], [None] * 3)
        words = coapt(*arguments).stdout
        self.assertRegex(words, r"\n +1 +\S+ +\S+ +- +- +- ")
        self.assertNotIn("region of interest", words)

    def test_without_any_plan_there_is_no_table(self):
        words = coapt("plan", VALVE, "--seconds", "1e-9").stdout
        self.assertIn("\nno plan yet\n", words)
        self.assertNotIn("rank", words)

    def test_the_time_limit_ends_the_search(self):
        result = coapt("plan", VALVE, "--evaluations", "100000", "--plans", "1", "--region-points", "1",
                       "--seconds", "2", "--json")
        self.assertLess(json.loads(result.stdout)["closures"], 100000)


if __name__ == "__main__":
    unittest.main()
