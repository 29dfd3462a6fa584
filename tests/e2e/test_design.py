"""coapt design ring."""

import csv
import json
import struct
import unittest
import xml.etree.ElementTree

from programs import BAD_INPUT, ProgramTest, coapt

VALVE = "human-functional-mr"
# The least that a search does: eight designs and two descents.
QUICK = ("--evaluations", 100, "--seed", 1)


class OnePatient(ProgramTest):
    def test_ring_its_files_and_what_scripts_rely_on(self):
        ring = self.folder / "ring.json"
        printed = self.run_ok("design", "ring", "--valve", VALVE, *QUICK, "-o", ring, "--json")
        result = json.loads(printed.stdout)
        self.assertEqual(result["schema"], "coapt.ring_design/1")
        self.assertLessEqual(result["gain_low"], result["gain_held_out"])
        self.assertLessEqual(result["gain_held_out"], result["gain_high"])
        document = json.loads(ring.read_text())
        self.assertEqual(document, result["design"])
        self.assertEqual(document["schema"], "coapt.ring/1")
        self.assertEqual(document["provenance"]["gain_held_out"], result["gain_held_out"])

        stl = ring.with_suffix(".stl").read_bytes()
        self.assertEqual(len(stl), 84 + 50 * struct.unpack("<I", stl[80:84])[0])
        xml.etree.ElementTree.parse(ring.with_suffix(".svg"))
        with open(ring.with_suffix(".csv"), newline="") as file:
            self.assertEqual([row["size_mm"] for row in csv.DictReader(file)], [str(s) for s in range(24, 41, 2)])
        self.assertIn("not a medical device", ring.with_suffix(".html").read_text())

        # Other commands sew it in, by its rule or in a size.
        sized = json.loads(self.run_ok("close", VALVE, "--ring", f"{ring}:30", "--json").stdout)
        self.assertAlmostEqual(sized["annulus"]["al_pm_mm"], 30.0, delta=0.5)
        self.run_ok("close", VALVE, "--ring", ring, "--json")
        self.run_ok("open", VALVE, "--ring", f"{ring}:36", "--json")
        few = ("--evaluations", 40, "--plans", 1, "--region-points", 1, "--no-evidence")
        coarse = ("--fine-levels", 0, "--model-draws", 0)
        plans = json.loads(coapt("plan", VALVE, "--ring", ring, *few, *coarse, "--json").stdout)
        self.assertIn(document["ring"], plans["reproduce"]["search"]["rules"]["shapes"])
        refused = coapt("close", VALVE, "--ring", f"{ring}:31")
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("/steps/0/size_mm", refused.stderr)

    def test_bad_input(self):
        for arguments, words in (
            ((), "either --population or --valve"),
            (("--valve", VALVE, "--name", "own"), "--name"),
            (("--population", self.folder / "none"), "none"),
        ):
            refused = coapt("design", "ring", *QUICK, "-o", self.folder / "bad.json", *arguments)
            self.assertEqual(refused.returncode, BAD_INPUT)
            self.assertIn(words, refused.stderr)


if __name__ == "__main__":
    unittest.main()
