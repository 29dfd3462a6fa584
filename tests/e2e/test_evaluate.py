"""coapt evaluate."""

import json
import unittest

from plan_runs import VALVE, is_acceptable
from programs import BAD_INPUT, NO_COMPETENT_PLAN, OK, ProgramTest, coapt, small_valve

SMALL = ["--region-points", "9", "--no-evidence"]


MENDING = {
    "schema": "coapt.plan/1",
    "steps": [{"step": "annuloplasty", "shape": "generic-etlogix-like", "size_mm": 30}],
}


def ring(sizes_below):
    return {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": sizes_below}]}


class Evaluate(ProgramTest):
    def setUp(self):
        super().setUp()
        self.mild = self.write("mild.json", ring(2))
        self.mending = self.write("mending.json", MENDING)

    def evaluate(self, *arguments):
        result = coapt("evaluate", small_valve(), *arguments, "--json")
        self.assertIn(result.returncode, [OK, NO_COMPETENT_PLAN], result.stderr)
        self.assertEqual(result.stderr, "")
        return json.loads(result.stdout), result.returncode

    def test_own_plans_are_ranked_under_their_names(self):
        answer, code = self.evaluate(self.mild, self.mending, *SMALL)
        best, worse = answer["plans"]
        self.assertEqual(
            [(plan["rank"], plan["name"]) for plan in answer["plans"]], [(1, str(self.mending)), (2, str(self.mild))]
        )
        self.assertEqual([best["plan"], worse["plan"]], [MENDING, ring(2)])
        self.assertLess(best["cost"], worse["cost"])
        self.assertGreater(best["probability_outranks_next"], 0.95)
        self.assertEqual((is_acceptable(best), code, answer["any_competent"]), (True, OK, True))
        self.assertEqual([plan["region_closures"] for plan in answer["plans"]], [9, 9])
        self.assertEqual((answer["closures"], answer["plans_tried"]), (1 + 2 * 9, 2))

    def test_enough_variants_say_which_measurement_would_say_more(self):
        page = self.folder / "report.html"
        few = ("--region-points", "1", "--no-evidence")
        answer, _ = self.evaluate(self.mild, *few, "--model-draws", "64", "-o", page)
        shares = [row["share_removed"] for row in answer["information"] if row["share_removed"] is not None]
        self.assertTrue(shares and shares == sorted(shares, reverse=True), answer["information"])
        self.assertIn("What would say more", page.read_text())
        low, high = answer["plans"][0]["leak"]["tissue"]
        closed = coapt("close", small_valve(), "--plan", self.mild, "--draws", "64", "--json")
        there = json.loads(closed.stdout)["leak"]["tissue"]
        self.assertAlmostEqual(low, there[0], delta=1.0 + 0.1 * there[0])  # the same draws, closed from other starts
        self.assertAlmostEqual(high, there[1], delta=1.0 + 0.1 * there[1])
        self.assertEqual(self.evaluate(self.mild, *few, "--model-draws", "8")[0]["information"], [])

    def test_what_plan_prints_and_what_the_page_saves_are_plans(self):
        ranked = coapt(
            "plan",
            small_valve(),
            "--evaluations",
            "20",
            "--plans",
            "2",
            "--region-points",
            "5",
            "--no-evidence",
            "--json",
        )
        found = json.loads(ranked.stdout)["plans"]
        result = coapt("evaluate", small_valve(), "-", *SMALL, "--json", stdin=ranked.stdout)
        answer = json.loads(result.stdout)
        self.assertEqual(sorted(plan["name"] for plan in answer["plans"]), ["-: plan 1", "-: plan 2"])
        by_name = {plan["name"]: plan["plan"] for plan in answer["plans"]}
        self.assertEqual([by_name["-: plan 1"], by_name["-: plan 2"]], [plan["plan"] for plan in found])

        saved = self.write(
            "plans.json", {"plans": [{"name": "mine", "plan": MENDING}, {"name": "mild", "plan": ring(2)}]}
        )
        second = coapt("close", small_valve(), "--plan", saved, "--rank", "2", "--json")
        alone = coapt("close", small_valve(), "--plan", self.mild, "--json")
        self.assertEqual(json.loads(second.stdout)["leak_mm2"], json.loads(alone.stdout)["leak_mm2"])
        third = coapt("close", small_valve(), "--plan", saved, "--rank", "3")
        self.assertEqual(third.returncode, BAD_INPUT)
        self.assertIn("has no plan 3; --rank must be from 1 to 2", third.stderr)

    def test_the_order_of_the_files_and_the_threads_change_nothing_but_time(self):
        one, _ = self.evaluate(self.mild, self.mending, *SMALL, "--threads", "1")
        two, _ = self.evaluate(self.mending, self.mild, *SMALL, "--threads", "2")
        self.assertEqual(one | {"seconds": 0}, two | {"seconds": 0})

    def test_a_plan_that_does_not_mend_the_valve_is_4(self):
        answer, code = self.evaluate(self.mild, *SMALL)
        self.assertEqual((code, answer["any_competent"]), (NO_COMPETENT_PLAN, False))
        self.assertIsNone(answer["plans"][0]["probability_outranks_next"])
        words = coapt("evaluate", small_valve(), self.mild, *SMALL)
        self.assertEqual(words.returncode, NO_COMPETENT_PLAN)
        self.assertRegex(
            words.stdout,
            r"\nNo plan is acceptable; plan 1 is not, because it leaks less than 5 mm²\s+with\s+a\s+probability of",
        )
        self.assertIn(f"{self.mild}:\n", words.stdout)

    def test_the_report_is_that_of_a_search_without_a_search(self):
        report = self.folder / "report.html"
        result = coapt("evaluate", VALVE, self.mending, *SMALL, "-o", report)
        self.assertEqual(result.returncode, OK, result.stderr)
        page = report.read_text()
        for words in [
            "How the plans were scored",
            "The given plans were scored",
            "not a medical device",
            "coapt evaluate human-functional-mr",
            "<img ",
        ]:
            self.assertIn(words, page)
        self.assertNotIn("How the search went", page)

    def test_evidence_is_88_closures_more_for_a_plan_without_suture_that_leaks(self):
        answer, _ = self.evaluate(self.mild, "--region-points", "2")
        self.assertEqual(answer["closures"], 1 + 2 + 88)
        remodelled = answer["plans"][0]["remodelling"]
        self.assertEqual([curve["direction"] for curve in remodelled], ["apical", "outwards", "posterior", "all three"])
        self.assertEqual({len(curve["leak_mm2"]) for curve in remodelled}, {7})

    def test_a_plan_is_closed_as_coapt_close_does(self):
        plan = self.evaluate(self.mending, "--region-points", "1", "--no-evidence")[0]["plans"][0]
        closed = json.loads(coapt("close", small_valve(), "--plan", self.mending, "--json").stdout)
        self.assertEqual(plan["measure"]["leak"], closed["leak"])
        self.assertEqual(plan["measure"]["leak_mm2"], closed["leak_mm2"])

    def test_what_practice_rejects_is_evaluated_and_said(self):
        six = self.write("six.json", ring(6))
        answer = json.loads(coapt("evaluate", "human-normal", six, *SMALL, "--json").stdout)
        gates = {gate["rule"]: gate for gate in answer["plans"][0]["gates"]}
        self.assertEqual(gates["undersizing"]["severity"], "reject")
        self.assertIn(gates["undersizing"]["finding"], answer["plans"][0]["warnings"])

    def test_every_name_of_the_same_plan_is_told(self):
        same = self.write("same.json", ring(2))
        answer, _ = self.evaluate(self.mild, same, *SMALL)
        names = json.dumps([plan["name"] for plan in answer["plans"]])
        self.assertIn("mild.json", names)
        self.assertIn("same.json", names)

    def test_plans_for_another_valve_are_refused_with_their_files_and_pointers(self):
        chorda = self.write(
            "chorda.json", {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": "none"}]}
        )
        head = self.write(
            "head.json",
            {
                "schema": "coapt.plan/1",
                "steps": [
                    {"step": "annuloplasty", "shape": "own", "sizes_below": 1},
                    {
                        "step": "neochorda",
                        "head": "of-another",
                        "length_mm": 20,
                        "insertion": {"leaflet": "anterior", "along": 0.5, "height": 1},
                    },
                ],
            },
        )
        result = coapt("evaluate", small_valve(), self.mild, chorda, head, "--json")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        first, second = result.stderr.splitlines()
        self.assertTrue(first.startswith(f"coapt: {chorda}: /steps/0/chorda: is 'none'"), first)
        self.assertTrue(second.startswith(f"coapt: {head}: /steps/1/head: is 'of-another'"), second)

    def test_every_file_that_is_no_plan_is_refused(self):
        wrong = self.write("wrong.json", '{"steps": NaN}')
        result = coapt("evaluate", small_valve(), self.folder / "missing.json", self.mild, wrong)
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        first, second = result.stderr.splitlines()
        self.assertIn("missing.json: cannot be opened", first)
        self.assertIn("wrong.json: /steps: ", second)


if __name__ == "__main__":
    unittest.main()
