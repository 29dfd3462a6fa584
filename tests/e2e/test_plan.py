"""coapt plan: what it answers."""

import functools
import json
import signal
import subprocess
import unittest

from plan_runs import BARE, VALVE, is_acceptable, options, rows, without_machine
from process_runs import HANGS_S, catches, cpu_seconds, wait_until
from programs import BAD_INPUT, COAPT, FAILURE, INTERRUPTED, NO_COMPETENT_PLAN, OK, ProgramTest, coapt, small_valve

COMPARED = 5  # plans, however few are reported (search_options.h)
LONG = ["--evaluations", "100000", "--json"]
GATES = [
    "ring_width",
    "ring_stenosis",
    "undersizing",
    "papillary_movement",
    "suture_length",
    "filling",
    "neochorda_length",
    "neochorda_half",
    "native_chordae",
    "opening_area",
    "mean_gradient",
    "convergence",
    "crossing",
    "contact",
    "coaptation_height",
    "chordal_tension",
    "systolic_anterior_motion",
    "regurgitation_grade",
    "neochorda_strength",
    "ring_sutures",
]


def planned(*arguments, valve=None, **changes):
    """The answer of a small search, and the exit code."""
    result = coapt("plan", valve or small_valve(), *options(**changes), *arguments, "--json")
    assert result.returncode in (OK, NO_COMPETENT_PLAN) and result.stderr == "", result.stderr
    return json.loads(result.stdout), result.returncode


@functools.cache
def search(**changes):
    """One that several tests read."""
    return planned(evaluations=40, region_points=17, **changes)


@functools.cache
def words():
    """What a search of the preset prints for people."""
    return coapt("plan", VALVE, *options(evaluations=3, plans=1)).stdout


@functools.cache
def out_of_time():
    """The answer of a long search that has had time for a plan, which a busy machine needs more of."""
    for seconds in [1, 4, 16, 64]:
        result, _ = planned(valve=VALVE, evaluations=100000, region_points=1089, plans=1, seconds=seconds, threads=2)
        if result["plans"]:
            return result
    raise TimeoutError("no plan in 64 s")


class Plan(ProgramTest):
    def test_the_ranking_is_the_same_for_one_and_two_threads_and_can_be_closed_again(self):
        (one, code), (two, _) = search(threads=1), search(threads=2)
        self.assertEqual(without_machine(one), without_machine(two))

        self.assertGreater(one["before"]["leak_mm2"], 5.0)
        self.assertIsInstance(one["seconds"], (int, float))
        self.assertEqual([plan["rank"] for plan in one["plans"]], [1, 2])
        best = one["plans"][0]
        self.assertEqual(set(best["leak_mm2"]) & {"nominal", "mean", "sd"}, {"nominal", "mean", "sd"})
        self.assertEqual(code == OK, is_acceptable(best))
        self.assertEqual(one["any_competent"], any(map(is_acceptable, one["plans"])))

        closed = coapt("close", small_valve(), "--plan", self.write("plan.json", best["plan"]), "--json")
        self.assertEqual(json.loads(closed.stdout)["leak"], best["measure"]["leak"])
        self.assertEqual(best["leak_mm2"]["nominal"], best["measure"]["leak_mm2"])

    def test_reported_plans_are_closed_once_more_on_a_finer_mesh(self):
        result, _ = search(threads=1)
        mesh, triangles = result["fine_mesh"], len(json.loads(small_valve().read_text())["faces"])
        self.assertEqual((mesh["levels"], mesh["triangles"], mesh["closures"]), (1, 4 * triangles, 1 + COMPARED))
        self.assertGreater(mesh["leak_before_mm2"], 5.0)
        self.assertEqual(
            sorted(plan["fine"]["own_mesh_rank"] for plan in result["plans"]),
            [plan["rank"] for plan in result["plans"]],
        )
        for plan in result["plans"]:
            self.assertEqual(plan["closes_robustly"], is_acceptable(plan))
            self.assertAlmostEqual(plan["fine"]["leak_mm2"], plan["measure"]["leak_mm2"], delta=10.0)
        own, _ = search(**BARE)
        self.assertEqual(own["fine_mesh"]["levels"], 0)
        self.assertEqual([plan["fine"] for plan in own["plans"]], [None] * len(own["plans"]))
        self.assertEqual(own["closures"], result["closures"])
        self.assertRegex(words(), r"\nFiner mesh: 2,592 triangles, unrepaired leak \d+\.\d mm2; it does not change")

    def test_reported_plans_are_closed_under_draws_of_the_model(self):
        result, _ = search(threads=1)
        plans, drawn = result["plans"], result["model_draws"]
        self.assertEqual((drawn["draws"], drawn["closures"]), (8, 8 * (1 + COMPARED)))
        self.assertGreater(drawn["before"]["leak_mm2"]["sd"], 1.0)
        for plan, following in zip(plans, plans[1:] + [None]):
            leak = plan["under_draws"]["leak_mm2"]
            self.assertLessEqual(leak["mean"], leak["worst"])
            self.assertEqual(plan["tie_with_next"], bool(following) and following["class"] == plan["class"])
        own, _ = search(**BARE)
        self.assertEqual(
            own["model_draws"], {"draws": 0, "before": None, "closures": 0, "chordae_drawn": False, "fit_drawn": False}
        )
        self.assertEqual([plan["under_draws"] for plan in own["plans"]], [None] * len(plans))
        self.assertEqual({plan["cost"] for plan in own["plans"]}, {plan["cost"] for plan in plans})
        self.assertRegex(words(), r"\nModel: 8 variants of tissue and chordae")

    def test_no_more_plans_than_asked_for(self):
        for changes in [{"region_points": 2}, {"region_points": 1}]:
            with self.subTest(changes):
                self.assertEqual(len(planned(plans=1, **BARE, **changes)[0]["plans"]), 1)
        self.assertEqual(len(out_of_time()["plans"]), 1)

    def test_each_plan_says_what_speaks_for_it_and_against_it(self):
        result, _ = search(threads=1)
        for plan in result["plans"]:
            self.assertEqual([gate["rule"] for gate in plan["gates"]], GATES)
            for gate in plan["gates"]:
                self.assertEqual(set(gate), {"rule", "severity", "finding", "source"})
                self.assertIn(gate["severity"], ["pass", "warn", "not_assessed"])  # rejected: not tried
                self.assertTrue(gate["finding"] and gate["source"])
                if gate["severity"] == "warn":
                    self.assertIn(gate["finding"], plan["warnings"])
            severity = {gate["rule"]: gate["severity"] for gate in plan["gates"]}
            self.assertIn(severity["opening_area"], ["pass", "warn"])
            self.assertGreater(plan["opening_area_mm2"], 150.0)
            self.assertGreater(plan["projected_area_mm2"], 100.0)
            self.assertGreater(plan["gradient_mmhg"], 0.0)
            self.assertGreaterEqual(plan["gradient_exercise_mmhg"], plan["gradient_mmhg"])
            self.assertEqual(severity["convergence"], "pass")
            margin = dict(plan["margin_to_leak"])
            why = margin.pop("why_unknown")
            self.assertEqual(set(margin), {"suture_length_mm", "angle_deg", "share"})
            self.assertTrue(all(value is None or value >= 0.0 for value in margin.values()), margin)
            self.assertEqual(why is None, None not in (margin["suture_length_mm"], margin["angle_deg"]))
            self.assertTrue(plan["description"])
        ahead = [plan["probability_outranks_next"] for plan in result["plans"]]
        self.assertTrue(0.0 <= ahead[0] <= 1.0, ahead)
        self.assertIsNone(ahead[-1])
        tie = 0.05 <= ahead[0] <= 0.95
        self.assertEqual([plan["tie_with_next"] for plan in result["plans"]], [tie, False])
        self.assertTrue(any(plan["pareto"] for plan in result["plans"]))
        self.assertGreater(len(result["not_modelled"]), 0)

    def test_a_valve_that_no_plan_mends_is_4_with_the_least_bad_ranked(self):
        valve = self.folder / "worst.json"
        self.run_ok(
            "valve",
            "remodel",
            small_valve(),
            "--ap-dilation",
            "60",
            "--displace-pm",
            "12,12,12",
            "--displace-al",
            "12,12,12",
            "-o",
            valve,
        )
        result, code = planned(valve=valve)
        self.assertEqual((code, result["any_competent"]), (NO_COMPETENT_PLAN, False))
        likely = [plan["acceptable_probability"] for plan in result["plans"]]
        self.assertEqual((len(likely), likely), (2, sorted(likely, reverse=True)))
        for plan in result["plans"]:
            self.assertFalse(is_acceptable(plan))
        told = coapt("plan", valve, *options(evaluations=3, **BARE))
        self.assertEqual(told.returncode, NO_COMPETENT_PLAN)
        self.assertRegex(
            told.stdout,
            r"\nNo plan is acceptable; plan 1 is not, because it leaks less than 5 mm²\s+with\s+a\s+probability of",
        )
        self.assertRegex(told.stdout, r"\n +1  \S+ ")

    def test_the_report_is_one_page_with_the_pictures_in_it(self):
        report = self.folder / "report.html"
        planned("-o", report, evaluations=3, plans=1)
        page = report.read_text()
        self.assertIn("data:image/png;base64,", page)
        self.assertNotIn('src="http', page)
        self.assertIn("not a medical device", page)

    def search_with_closures(self, closures, *arguments):
        """A long search that has kept so many closures."""
        store = self.folder / f"{closures}-{len(list(self.folder.iterdir()))}.sqlite"
        search = subprocess.Popen(
            [COAPT, "plan", small_valve(), *LONG, "--store", store, *arguments], stdout=subprocess.PIPE, text=True
        )
        wait_until(lambda: len(rows(store)) >= closures)
        return search

    def test_a_report_without_a_place_is_refused_before_the_search(self):
        for path, code in [("/nowhere/r.html", FAILURE), ("-", BAD_INPUT)]:
            with self.subTest(path):
                result = coapt("plan", small_valve(), *LONG, "-o", path)
                self.assertEqual((result.returncode, result.stdout), (code, ""))
                self.assertIn(path, result.stderr)

    def test_a_path_that_was_only_tested_is_left_as_it_was(self):
        old, new = self.write("old.html", "old"), self.folder / "new.html"
        for path in [old, new]:
            with self.search_with_closures(1, "-o", path) as search:
                search.kill()
        self.assertEqual(old.read_text(), "old")
        self.assertFalse(new.exists())

    def test_ctrl_c_prints_the_best_so_far(self):
        with self.search_with_closures(20) as search:
            search.send_signal(signal.SIGINT)
            output, _ = search.communicate(timeout=HANGS_S)
        self.assertEqual(search.returncode, INTERRUPTED)
        result = json.loads(output)
        self.assertEqual(result["stop"], "cancelled")
        self.assertIn("before", result)
        self.assertGreater(len(result["plans"]), 0)

    def test_a_second_ctrl_c_ends_a_long_closure_at_once(self):
        valve = self.folder / "fine.json"
        self.run_ok("valve", "make", VALVE, "--triangles", "10400", "-o", valve)
        with subprocess.Popen([COAPT, "plan", valve], stdout=subprocess.PIPE, text=True) as search:
            wait_until(lambda: cpu_seconds(search) > 1.0)  # it has read the valve and closes it
            search.send_signal(signal.SIGINT)
            wait_until(lambda: not catches(search, signal.SIGINT))
            self.assertIsNone(search.poll())
            search.send_signal(signal.SIGINT)
            output, _ = search.communicate(timeout=HANGS_S)
        self.assertEqual((search.returncode, output), (-signal.SIGINT, ""))

    def test_a_plan_that_was_not_re_scored_has_no_region(self):
        arguments = ["plan", small_valve(), *options(evaluations=3, plans=1, region_points=1)]
        result = coapt(*arguments, "--json")
        self.assertEqual(result.returncode, NO_COMPETENT_PLAN)
        best = json.loads(result.stdout)["plans"][0]
        self.assertIsInstance(best["leak_mm2"]["nominal"], float)
        self.assertEqual([best["leak_mm2"][key] for key in ["mean", "sd", "worst"]], [None] * 3)
        told = coapt(*arguments).stdout
        self.assertRegex(told, r"\n +1  [a-z ]+  +not known  ")
        self.assertIn("It is unknown whether a plan is acceptable", told)
        self.assertNotIn("region of interest", told)

    def test_without_any_plan_there_is_no_table(self):
        result = coapt("plan", VALVE, "--seconds", "1e-9")
        self.assertEqual(result.returncode, NO_COMPETENT_PLAN)
        self.assertIn("\nno plan yet\n", result.stdout)
        self.assertNotIn("\nrank ", result.stdout)

    def test_the_time_limit_ends_the_search(self):
        result = out_of_time()
        self.assertEqual(result["stop"], "time_limit")
        self.assertLess(result["closures"], 100000)
        self.assertLess(result["plans"][0]["region_closures"], 1089)


if __name__ == "__main__":
    unittest.main()
