"""`coapt observe`: what images show of a valve, and that later answers are weighed by it."""

import json
import unittest

from programs import BAD_INPUT, OK, ProgramTest, coapt, small_valve


class Observe(ProgramTest):
    def observed(self, *arguments):
        path = self.folder / "seen.json"
        result = coapt("observe", "human-functional-mr", *arguments, "-o", path)
        self.assertEqual(result.returncode, OK, result.stderr)
        return path

    def test_stores_figures_with_their_source_and_replaces_those_given_before(self):
        path = self.observed("--leak", "30", "--leak-sd", "8", "--source", "3D planimetry")
        again = coapt(
            "observe", path, "--leak", "20", "--leak-sd", "4", "--widest-gap", "3", "--widest-gap-sd", "0.5", "-o", "-"
        )
        self.assertEqual(
            json.loads(again.stdout)["observed"],
            {"leak_mm2": {"value": 20, "sd": 4}, "widest_gap_mm": {"value": 3, "sd": 0.5}},
        )
        with open(path, encoding="utf-8") as file:
            self.assertEqual(
                json.load(file)["observed"], {"leak_mm2": {"value": 30, "sd": 8, "source": "3D planimetry"}}
            )
        self.assertNotIn("observed", json.loads(coapt("observe", path, "--forget", "-o", "-").stdout))

    def test_an_effective_area_is_kept_as_the_anatomic_one_with_the_coefficient_s_spread(self):
        path = self.observed("--effective-leak", "24", "--effective-leak-sd", "4", "--source", "PISA")
        with open(path, encoding="utf-8") as file:
            seen = json.load(file)["observed"]["leak_mm2"]
        self.assertAlmostEqual(seen["value"], 30)
        self.assertAlmostEqual(seen["sd"], (5**2 + (30 * 0.06 / 0.8) ** 2) ** 0.5)
        self.assertEqual(seen["source"], "effective orifice area 24 ± 4 mm2, discharge coefficient 0.8 ± 0.06; PISA")

    def test_refuses_what_it_cannot_weigh_by(self):
        for arguments, words in [
            (("--effective-leak", "24"), "--effective-leak-sd is required with --effective-leak"),
            (
                ("--effective-leak", "24", "--effective-leak-sd", "4", "--leak", "30", "--leak-sd", "8"),
                "--effective-leak and --leak are of one figure",
            ),
            (("--effective-leak", "24", "--effective-leak-sd", "4", "--discharge", "0"), "0.5"),
            (("--leak", "30"), "--leak-sd is required with --leak"),
            (("--leak-sd", "8"), "--leak is required with --leak-sd"),
            (("--leak", "30", "--leak-sd", "0"), "0.01"),
            (("--leak", "30", "--leak-sd", "-1"), "0.01"),
            (("--leak", "nan", "--leak-sd", "8"), "2000"),
            (("--leak", "1e9", "--leak-sd", "8"), "2000"),
            ((), "an observation is required"),
        ]:
            with self.subTest(arguments):
                result = coapt("observe", "human-functional-mr", *arguments, "-o", self.folder / "none.json")
                self.assertEqual(result.returncode, BAD_INPUT)
                self.assertIn(words, result.stderr)

    def test_may_be_said_with_an_import(self):
        folder, valve = self.folder / "open", self.folder / "valve.json"
        self.run_ok("export", small_valve(), "--open", "-o", f"{folder}/")
        said = ("--leak", "30", "--leak-sd", "8", "--observed-by", "3D planimetry")
        self.run_ok("valve", "import", "--slicerheart", folder, *said, "-o", valve)
        with open(valve, encoding="utf-8") as file:
            self.assertEqual(
                json.load(file)["observed"], {"leak_mm2": {"value": 30, "sd": 8, "source": "3D planimetry"}}
            )
        refused = coapt("valve", "import", "--slicerheart", folder, "--leak", "30", "-o", self.folder / "none.json")
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("--leak-sd is required with --leak", refused.stderr)

    def test_narrows_what_the_tissue_leaves_of_a_leak(self):
        def tissue(valve):
            result = coapt("close", valve, "--draws", "24", "--json")
            self.assertEqual(result.returncode, OK, result.stderr)
            return json.loads(result.stdout)

        before, after = tissue("human-functional-mr"), tissue(self.observed("--leak", "40", "--leak-sd", "8"))
        low, high = before["leak"]["tissue"]
        self.assertLess(low, high)
        self.assertEqual(before["tissue_draws"]["observed"], [])
        self.assertEqual(after["tissue_draws"]["observed"], ["leak_mm2"])
        self.assertEqual(after["leak"]["area_mm2"], before["leak"]["area_mm2"])
        self.assertLess(after["leak"]["tissue"][1] - after["leak"]["tissue"][0], high - low)
        self.assertEqual(after["observed"], {"leak_mm2": {"value": 40, "sd": 8}})
        self.assertIn(" mm² with tissue error)", after["diagnosis"]["sentence"])

    def test_a_plain_closure_says_what_was_observed_and_which_error_it_knows(self):
        seen = self.observed("--leak", "30", "--leak-sd", "8", "--source", "3D planimetry")
        said = self.run_ok("close", seen).stdout
        self.assertRegex(said, r"observed +leak 30 ± 8 mm2 \(3D planimetry\); used with --draws")
        self.assertRegex(said, r"leak +\d+ ± \d+ mm2 \(numerical error; tissue error not known\)")
        self.assertNotIn("observed", self.run_ok("close", "human-functional-mr").stdout)

    def test_says_what_is_worth_measuring(self):
        result = coapt("study", "information", "human-functional-mr", "--draws", "32", "--json")
        self.assertEqual(result.returncode, OK, result.stderr)
        rows = json.loads(result.stdout)["rows"]
        shares = [row["share_removed"] for row in rows if row["share_removed"] is not None]
        self.assertEqual(shares, sorted(shares, reverse=True))
        self.assertTrue(all(0 <= share <= 1 for share in shares))


if __name__ == "__main__":
    unittest.main()
