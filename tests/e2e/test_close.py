"""coapt close and coapt evaluate."""

import json
import math
import re
import unittest

from programs import BAD_INPUT, FAILURE, NO_COMPETENT_PLAN, NOT_CLOSED, OK, ProgramTest, coapt

VALVE = "human-functional-mr"
NOTHING = {"schema": "coapt.plan/1", "steps": []}
RING = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": 2}]}


class Close(ProgramTest):
    def close(self, *arguments):
        result = coapt("close", *arguments, "--json")
        closure = json.loads(result.stdout)
        closed = closure["status"] == "converged" and not closure["crossing"]
        self.assertEqual(result.returncode, OK if closed else NOT_CLOSED)
        return closure

    def test_json_has_the_keys_that_scripts_rely_on(self):
        closure = self.close("human-normal")
        self.assertIn(closure["status"], ["converged", "step_limit", "diverged"])
        self.assertEqual((closure["method"], closure["membrane"]), ("fast", "continuum"))
        self.assertIsInstance(closure["crossing"], bool)
        self.assertIsInstance(closure["steps"], int)
        self.assertIsInstance(closure["triangles"], int)
        for key in ["leak_mm2", "residual", "seconds"]:
            self.assertIsInstance(closure[key], (int, float), key)
        self.assertEqual(closure["schema"], "coapt.closure/2")
        self.assertEqual(
            set(closure["leak"]),
            {"area_mm2", "error_mm2", "numerical", "tissue", "execution", "between_mm2", "openings"},
        )
        self.assertEqual(closure["leak"]["area_mm2"], closure["leak_mm2"])

    def test_a_healthy_valve_is_competent_and_the_functional_one_leaks(self):
        self.assertLess(self.close("human-normal")["leak_mm2"], 1.0)
        self.assertGreater(self.close(VALVE)["leak_mm2"], 5.0)

    def test_a_leak_lies_between_its_bounds_and_its_openings_are_largest_first(self):
        leak = self.close("human-p2-prolapse")["leak"]
        low, high = leak["between_mm2"]
        self.assertTrue(low <= leak["area_mm2"] <= high)
        areas = [opening["area_mm2"] for opening in leak["openings"]]
        self.assertEqual(areas, sorted(areas, reverse=True))
        widest = leak["openings"][0]
        self.assertIn("P2", widest["segments"])
        self.assertGreater(widest["width_mm"], 1.0)
        self.assertAlmostEqual(math.hypot(*widest["normal"]), 1.0)
        self.assertGreater(len(widest["outline_mm"]), 10)

    def test_the_opening_is_told_where_it_is_asked_for(self):
        printed = json.loads(coapt("open", VALVE, "--json").stdout)
        opening = self.close(VALVE, "--open")["opening"]
        for key in ["status", "crossing", "opening_area_mm2", "projected_area_mm2", "gradient_mmhg", "flow_ml_s"]:
            self.assertEqual(opening[key], printed[key], key)
        self.assertNotIn("opening", self.close(VALVE))
        words = coapt("close", VALVE, "--open").stdout
        shown, error = re.search(
            r"\n  opening +([\d.]+) ± ([\d.]+) cm2, mean gradient [\d.]+ ± [\d.]+ mmHg at ", words
        ).groups()
        area = opening["estimates"]["opening_area_mm2"]
        self.assertEqual((area["value"], area["tissue"]), (opening["opening_area_mm2"], None))
        self.assertAlmostEqual(float(shown), 0.01 * area["value"], delta=0.006)
        self.assertAlmostEqual(float(error), 0.01 * (area["numerical"][1] - area["value"]), delta=0.006)

    def test_pressure_and_tissue_take_the_place_of_the_valves_own(self):
        own = self.close("human-functional-mr")["leak_mm2"]
        self.assertGreater(self.close("human-functional-mr", "--pressure", "60")["leak_mm2"], 1.2 * own)
        self.assertGreater(self.close("human-functional-mr", "--radial-extension", "0.05")["leak_mm2"], own)
        stiff = ("--radial-stiffness", "3", "--circumferential-stiffness", "3")
        self.assertNotEqual(self.close("human-functional-mr", *stiff)["leak_mm2"], own)
        result = coapt("close", "human-normal", "--pressure", "0", "--thickness-mm", "99")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn(" --pressure: is 0, must be from 1 to 400 mmHg", result.stderr)
        self.assertIn(" --thickness-mm: is 99, must be from 0.05 to 10 mm", result.stderr)

    def test_a_ring_makes_the_leak_of_the_functional_valve_smaller(self):
        plan = self.write("plan.json", RING)
        before = self.close(VALVE)
        after = self.close(VALVE, "--plan", plan)
        self.assertLess(after["leak_mm2"], before["leak_mm2"])

    def test_the_membrane_can_be_chosen_with_either_method(self):
        default = self.close(VALVE)
        again = self.close(VALVE, "--membrane", "continuum")
        self.assertEqual(again["leak_mm2"], default["leak_mm2"])
        for method in ("fast", "thesis"):
            springs = self.close(VALVE, "--membrane", "springs", "--method", method)
            self.assertEqual((springs["method"], springs["membrane"]), (method, "springs"))
            self.assertNotEqual(springs["leak_mm2"], default["leak_mm2"])
            self.assertAlmostEqual(springs["leak_mm2"], default["leak_mm2"], delta=20.0)
        result = coapt("close", VALVE, "--membrane", "cheese")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("--membrane", result.stderr)

    def test_an_accuracy_chooses_mesh_and_tolerances_and_keeps_it(self):
        plain, near = self.close(VALVE), self.close(VALVE, "--accuracy", "1.5")
        plain_error, near_error = plain["leak"]["error_mm2"], near["leak"]["error_mm2"]
        self.assertGreater(plain_error, 1.5)
        self.assertLessEqual(near_error, 1.5)
        self.assertEqual(near["triangles"], plain["triangles"] * 4 ** near["accuracy"]["refinements"])
        self.assertGreater(near["triangles"], plain["triangles"])
        self.assertLess(abs(plain["leak_mm2"] - near["leak_mm2"]), plain_error + near_error)
        loose = self.close(VALVE, "--accuracy", "100")["accuracy"]
        self.assertEqual(loose["refinements"], 0)
        self.assertGreater(loose["residual_tolerance"], near["accuracy"]["residual_tolerance"])
        self.assertNotIn("accuracy", plain)
        words = coapt("close", VALVE, "--accuracy", "100").stdout
        self.assertRegex(words, r"\n  leak +[\d.]+ ± [\d.]+ mm2")
        self.assertRegex(words, r"\n  accuracy +at most 100 mm2 requested: 0 refinements, residual 0.1,")

    def test_finer_meshes_are_closed_until_the_leak_stands(self):
        closure = self.close(VALVE, "--converge", "--within", "100")
        convergence = closure["convergence"]
        first, last = convergence["levels"]
        self.assertEqual(convergence["stop"], "settled")
        self.assertEqual(last["triangles"], 4 * first["triangles"])
        self.assertEqual((closure["triangles"], closure["leak_mm2"]), (last["triangles"], last["leak_mm2"]))
        self.assertIsNone(first["change_mm2"])
        self.assertLess(abs(convergence["other_end_mm2"]), closure["leak"]["error_mm2"])
        self.assertAlmostEqual(last["change_mm2"], last["leak_mm2"] - first["leak_mm2"])
        self.assertAlmostEqual(convergence["leak_error_mm2"], abs(last["change_mm2"]))
        self.assertAlmostEqual(first["leak_mm2"], self.close(VALVE)["leak_mm2"])
        self.assertNotIn("convergence", self.close(VALVE))
        words = coapt("close", VALVE, "--converge", "--within", "0", "--most-vertices", "2000").stdout
        self.assertIn("the leak has not converged: the next mesh would have too many vertices", words)
        self.assertRegex(words, r"\n +2,592 +\d+\.\d +-?\d+\.\d +\d+\.\d\d\n")

    def test_what_belongs_to_finer_meshes_is_refused_without_them(self):
        for option in ["--within", "--most-vertices"]:
            result = coapt("close", VALVE, option, "100")
            self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
            self.assertIn("--converge", result.stderr)

    def test_an_accuracy_that_no_mesh_keeps_is_refused_with_the_range(self):
        for wanted in ["0.0001", "0.1"]:
            result = coapt("close", VALVE, "--accuracy", wanted)
            self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
            self.assertRegex(result.stderr, rf"--accuracy: is {wanted}, must be at least \S+ mm2, the ")
        self.assertEqual(coapt("close", VALVE, "--accuracy", "1", "--converge").returncode, BAD_INPUT)
        result = coapt("close", VALVE, "--accuracy", "1", "--method", "thesis")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("only for method fast", result.stderr)
        self.assertEqual(coapt("close", VALVE, "--accuracy", "-1").returncode, BAD_INPUT)

    def test_the_picture_is_a_png_and_stdout_is_still_json(self):
        picture = self.folder / "closed.png"
        self.close("human-normal", "--render", picture)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_picture_is_refused_before_anything_is_closed_if_it_has_no_place(self):
        result = coapt("close", "human-normal", "--render", "/nowhere/closed.png")
        self.assertEqual((result.returncode, result.stdout), (FAILURE, ""))
        self.assertIn("/nowhere/closed.png: cannot be written", result.stderr)
        result = coapt("close", "human-normal", "--json", "--render", "-")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("--render", result.stderr)

    def test_standard_input_is_read_once(self):
        for command in [["close", "-", "--plan", "-"], ["evaluate", "-", "-"], ["evaluate", VALVE, "-", "-"]]:
            with self.subTest(command):
                valve = coapt("valve", "make", "human-normal", "-o", "-").stdout
                result = coapt(*command, stdin=valve if command[1] == "-" else json.dumps(RING))
                self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
                self.assertIn("standard input can be read only once", result.stderr)

    def test_the_words_go_to_stdout_and_nothing_to_stderr(self):
        result = coapt("close", "human-normal")
        self.assertIn("human-normal: ", result.stdout)
        self.assertIn("mm2", result.stdout)
        self.assertEqual(result.stderr, "")

    def test_the_words_begin_with_the_reason_and_the_leak_even_where_leaflets_overlap_it(self):
        words = coapt("close", "human-p2-prolapse").stdout
        leak_mm2 = self.close("human-p2-prolapse")["leak_mm2"]
        self.assertGreater(leak_mm2, 20.0)
        told = re.match(r"  leak +([\d.]+) ± [\d.]+ mm2", words.splitlines()[2])
        self.assertAlmostEqual(float(told[1]), leak_mm2, delta=0.5)

    def test_openings_too_small_to_show_are_left_to_json(self):
        for valve in ["human-normal", VALVE, "human-p2-prolapse"]:
            self.assertNotIn("  0.0 mm2 at", coapt("close", valve).stdout)

    def test_an_absurd_ring_is_warned_about_in_words_and_in_json(self):
        ring = {"step": "annuloplasty", "shape": "own", "sizes_below": 6}
        plan = self.write("plan.json", {"schema": "coapt.plan/1", "steps": [ring]})
        self.assertEqual(self.close(VALVE)["warnings"], [])
        warnings = self.close(VALVE, "--plan", plan)["warnings"]
        self.assertTrue(any("27 mm or less predicts functional stenosis" in line for line in warnings), warnings)
        words = coapt("close", VALVE, "--plan", plan).stdout
        for line in warnings:
            self.assertIn(f"  ! {line}\n", words)

    def test_a_wrong_plan_is_pointed_at(self):
        wrong = {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": "none"}]}
        result = coapt("close", "human-normal", "--plan", self.write("plan.json", wrong), "--json")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("/steps/0", result.stderr)
        self.assertEqual(result.stdout, "")


class Evaluate(ProgramTest):
    def test_own_plans_are_ranked_with_the_leak_that_close_finds(self):
        ring, nothing = self.write("ring.json", RING), self.write("nothing.json", NOTHING)
        result = coapt("evaluate", VALVE, ring, nothing, "--region-points", "3", "--json")
        self.assertIn(result.returncode, [OK, NO_COMPETENT_PLAN], result.stderr)
        plans = {plan["file"]: plan for plan in json.loads(result.stdout)["plans"]}
        self.assertEqual(set(plans), {str(ring), str(nothing)})
        self.assertEqual(plans[str(nothing)]["plan"], NOTHING)
        for file in plans:
            closed = json.loads(coapt("close", VALVE, "--plan", file, "--json").stdout)
            self.assertEqual(plans[file]["measure"]["leak"], closed["leak"])
        self.assertEqual(plans[str(ring)]["rank"], 1)
        self.assertGreater(plans[str(nothing)]["leak_mm2"]["sd"], 0.0)

    def test_every_wrong_plan_is_named(self):
        wrong, absent = self.write("wrong.json", {"schema": "coapt.plan/1"}), self.folder / "absent.json"
        result = coapt("evaluate", VALVE, wrong, absent)
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("wrong.json: /steps", result.stderr)
        self.assertIn("absent.json", result.stderr)
        self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
