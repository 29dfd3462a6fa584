"""coapt open: a valve in diastole."""

import json
import unittest

from programs import BAD_INPUT, OK, ProgramTest, coapt

VALVE = "human-functional-mr"
RING = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": 6}]}


class Open(ProgramTest):
    def open(self, *arguments):
        result = coapt("open", *arguments, "--json")
        self.assertEqual(result.returncode, OK, result.stderr)
        return json.loads(result.stdout)

    def test_json_has_the_keys_that_scripts_rely_on(self):
        opening = self.open(VALVE)
        self.assertEqual(
            (opening["schema"], opening["status"], opening["crossing"]), ("coapt.opening/2", "converged", False)
        )
        for key in [
            "opening_area_mm2",
            "projected_area_mm2",
            "annulus_area_mm2",
            "gradient_mmhg",
            "gradient_exercise_mmhg",
        ]:
            self.assertGreater(opening[key], 0.0, key)
        self.assertEqual(opening["leak"]["area_mm2"], opening["opening_area_mm2"])
        self.assertIsNone(opening["leak"]["error_mm2"])
        self.assertGreater(len(opening["leak"]["openings"]), 0)
        self.assertEqual(self.open("human-normal")["warnings"], [])
        self.assertIn("mean gradient", coapt("open", VALVE).stdout)

    def test_a_small_ring_narrows_the_opening_and_is_warned_of(self):
        before, after = self.open(VALVE), self.open(VALVE, "--plan", self.write("ring.json", RING))
        self.assertLess(after["projected_area_mm2"], before["projected_area_mm2"])
        self.assertGreater(after["gradient_mmhg"], before["gradient_mmhg"])
        self.assertNotEqual(after["warnings"], [])

    def test_the_gradient_grows_with_the_square_of_flow_over_the_opening_that_flow_widens(self):
        once, twice = self.open(VALVE, "--flow", 100), self.open(VALVE, "--flow", 200)
        self.assertGreater(twice["opening_area_mm2"], once["opening_area_mm2"])
        wider = twice["opening_area_mm2"] / once["opening_area_mm2"]
        self.assertAlmostEqual(twice["gradient_mmhg"] * wider**2, 4.0 * once["gradient_mmhg"])
        refused = coapt("open", VALVE, "--flow", 1)
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("--flow", refused.stderr)

    def test_pictures_and_leaflets_are_written(self):
        picture, leaflets = self.folder / "open.png", self.folder / "open.ply"
        self.open(VALVE, "--render", picture, "--opened", leaflets)
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
        self.assertTrue(leaflets.read_bytes().startswith(b"ply"))


if __name__ == "__main__":
    unittest.main()
