"""`coapt diagnose`: why valves leak, and what a search makes of it."""

import json
import unittest

from programs import BAD_INPUT, NO_COMPETENT_PLAN, OK, ProgramTest, coapt


def diagnosis_of(valve, *arguments):
    result = coapt("diagnose", valve, *arguments, "--json")
    assert result.returncode == OK, result.stderr
    return json.loads(result.stdout)


def first_plan(valve, *arguments):
    result = coapt(
        *("plan", valve, "--evaluations", "120", "--plans", "2", "--region-points", "17", "--no-evidence"),
        *("--model-draws", "8", "--json", *arguments),
    )
    return json.loads(result.stdout), result.returncode


class Diagnose(ProgramTest):
    def test_presets_have_the_type_of_their_disease(self):
        for valve, kind in [
            ("human-normal", None),
            ("human-functional-mr", "IIIb"),
            ("human-p2-prolapse", "II"),
            ("barlow", "II"),
        ]:
            with self.subTest(valve):
                found = diagnosis_of(valve)
                self.assertEqual((found["schema"], found["valve"]), ("coapt.diagnosis/1", valve))
                self.assertEqual((found["type"], found["competent"]), (kind, kind is None))
                self.assertEqual(
                    kind == "II", any(segment["finding"] in ("prolapse", "flail") for segment in found["segments"])
                )
                closed = json.loads(coapt("close", valve, "--json").stdout)
                self.assertEqual(closed["diagnosis"]["sentence"], found["sentence"])
                self.assertIn(found["sentence"], coapt("diagnose", valve).stdout)

    def test_a_competent_valve_gets_no_operation(self):
        result, code = first_plan("human-normal")
        self.assertEqual((code, len(result["plans"])), (OK, 1))
        self.assertEqual(result["plans"][0]["steps"], [])
        self.assertEqual(result["plans"][0]["plan"]["steps"], [])
        self.assertTrue(result["diagnosis"]["competent"])

    def test_a_flail_gets_a_neochorda_and_no_suture_of_a_muscle(self):
        result, code = first_plan("human-p2-prolapse")
        self.assertEqual(code, OK)
        for plan in result["plans"]:
            self.assertNotIn("papillary_approximation", [step["step"] for step in plan["plan"]["steps"]])
        best = result["plans"][0]
        self.assertIn("neochorda", [step["step"] for step in best["plan"]["steps"]])
        self.assertTrue(best["simplest_of_class"])
        self.assertGreaterEqual(best["acceptable_probability"], 0.95)

    def test_a_request_that_closes_what_is_indicated_gets_the_reasons(self):
        rules = {"forbidden": ["annuloplasty", "neochorda"]}
        search = self.write("search.json", {"rules": rules})
        result, code = first_plan("human-p2-prolapse", "--search", search)
        self.assertEqual((code, result["plans"], result["stop"]), (NO_COMPETENT_PLAN, [], "exhausted"))
        self.assertIn({"what": "neochordae", "why": "forbidden"}, result["cut"])
        self.assertIn({"what": "resection", "why": "available on request"}, result["cut"])

    def test_what_is_no_valve_is_refused(self):
        result = coapt("diagnose", "no-such-valve")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))


if __name__ == "__main__":
    unittest.main()
