"""coapt prefer: questions, answers and what they say of the weights."""

import json
import unittest

from plan_runs import VALVE, options
from programs import BAD_INPUT, ProgramTest, coapt

TERMS = """step undersizing undersizing_above_4 movement movement_above_10 leak incompetence margin coaptation gap tension
gradient_above_3 gradient_above_5 durability untrusted""".split()


def plan(step, leak):
    amounts = dict.fromkeys(TERMS, 0.0) | {"step": step, "leak": leak}
    return {"description": [f"{step} steps"], "cost_terms": amounts, "leak_mm2": {"mean": leak}}


class Prefer(ProgramTest):
    def setUp(self):
        super().setUp()
        plans = [plan(0, 3.0), plan(1, 1.5), plan(2, 0.6), plan(3, 0.0)]
        self.plans = self.write("plans.json", {"schema": "coapt.plans/2", "plans": plans})
        self.answers = self.folder / "answers.json"

    def next(self, *arguments):
        result = self.run_ok("prefer", self.plans, "--answers", self.answers, *arguments)
        return json.loads(result.stdout)

    def test_questions_are_asked_and_answered_through_pipes(self):
        first = self.next("--rater", "A")
        self.assertEqual((first["schema"], first["answers"]), ("coapt.question/1", 0))
        self.assertFalse(self.answers.exists())
        self.assertEqual(self.next("--next"), first)
        second = self.next("--rater", "A", "--answer", "first")
        self.assertEqual(second["answers"], 1)
        asked = first["question"]
        sheet = json.loads(self.answers.read_text())
        self.assertEqual(sheet["rater"], "A")
        expected = {key: asked[key] for key in ("case", "first", "second")} | {"answer": "first"}
        self.assertEqual(sheet["answers"], [expected])
        self.assertNotEqual(
            {second["question"]["first"], second["question"]["second"]}, {asked["first"], asked["second"]}
        )

    def test_an_expert_who_minds_steps_makes_them_dear(self):
        question = self.next()["question"]
        while question:
            answer = "first" if question["first"] < question["second"] else "second"
            question = self.next("--answer", answer)["question"]
        weights = self.next("--json", "-o", self.folder / "weights.json")
        self.assertEqual(weights, json.loads((self.folder / "weights.json").read_text()))
        self.assertEqual((weights["schema"], weights["answers"]), ("coapt.weights/1", 6))
        self.assertGreater(weights["weights"]["step"], 1.0)
        self.assertLess(weights["weights"]["leak"], 1.0)
        self.assertIn(
            "Weights that the answers do not constrain",
            self.run_ok("prefer", self.plans, "--answers", self.answers, "-o", self.folder / "weights.json").stdout,
        )
        refused = coapt("prefer", self.plans, "--answers", self.answers, "--answer", "first")
        self.assertEqual(refused.returncode, BAD_INPUT)
        alike = self.next("--compare", self.answers, "--json")
        self.assertEqual((alike["pairs"], alike["alike"]), (6, 1.0))

    def test_answers_on_other_plans_are_refused_with_their_place(self):
        bad = {
            "schema": "coapt.answers/1",
            "rater": "A",
            "answers": [{"case": "x", "first": 1, "second": 9, "answer": "?"}],
        }
        self.answers.write_text(json.dumps(bad))
        refused = coapt("prefer", self.plans, "--answers", self.answers)
        self.assertEqual(refused.returncode, BAD_INPUT)
        for place in ("/answers/0/case", "/answers/0/answer"):
            self.assertIn(place, refused.stderr)

    def test_a_search_takes_the_weights(self):
        weights = self.next("--json")
        weights["weights"]["step"] = 1.75
        learned = self.write("weights.json", weights)
        words = options(evaluations=2, plans=2, region_points=1)
        result = coapt("plan", VALVE, *words, "--weights", learned, "--json")
        ranked = json.loads(result.stdout)
        self.assertEqual(ranked["weights"]["step"], 1.75)
        *before, last = (entry["preferred_over_next"] for entry in ranked["plans"])
        self.assertIsNone(last)
        self.assertTrue(all(0.0 <= share <= 1.0 for share in before))
        both = self.write("search.json", {"weights": {"leak": 2.0}})
        refused = coapt("plan", VALVE, *words, "--weights", learned, "--search", both)
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("/weights", refused.stderr)


if __name__ == "__main__":
    unittest.main()
