"""coapt-lab leak."""

import csv
import json
import unittest

from laboratory import coapt_lab
from programs import BAD_INPUT, OK, ProgramTest


class Leak(ProgramTest):
    def test_every_valve_has_its_reference_and_its_surface_and_the_agreement_is_printed(self):
        result = coapt_lab("leak", "--count", "2", "--finest", "0.5", "--surfaces", "-o", self.folder / "leak")
        self.assertEqual(result.returncode, OK, result.stderr)
        self.assertIn("2 of 2 valves", result.stderr)
        self.assertIn("| leak | held out |", result.stdout)
        with open(self.folder / "leak" / "leaks.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["valve"] for row in rows], ["porcine-1", "porcine-2"])
        self.assertEqual([row["held_out"] for row in rows], ["false", "true"])
        self.assertLessEqual(float(rows[0]["dual_mm2"]), float(rows[0]["primal_mm2"]))
        surface = json.loads((self.folder / "leak" / "surface-1.json").read_text())
        self.assertEqual(surface["half_thickness_mm"], 0.5)
        self.assertEqual(len(surface["faces"]), int(rows[1]["triangles"]))
        self.assertFalse(set(surface["annulus"]) & {vertex for edge in surface["free_edge"] for vertex in edge})

    def test_voxels_that_it_cannot_halve_to_are_refused(self):
        result = coapt_lab("leak", "--finest", "0.3")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))


if __name__ == "__main__":
    unittest.main()
