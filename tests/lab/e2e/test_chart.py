"""coapt-lab chart."""

import csv
import unittest

from laboratory import coapt_lab
from programs import BAD_INPUT, FAILURE, OK, ProgramTest

PNG = b"\x89PNG"  # how the file begins


class Ablation(ProgramTest):
    def test_there_is_a_line_for_every_change_and_scene_and_a_chart(self):
        folder = self.folder / "charts"
        result = coapt_lab("chart", "ablation", "-o", folder, "--variations", "0", "--repeats", "1")
        self.assertEqual((result.returncode, result.stdout), (OK, ""), result.stderr)
        with open(folder / "ablation.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        changes = {row["change"] for row in rows}
        self.assertEqual(
            {row["scene"] for row in rows}, {"human-normal", "human-functional-mr", "human-p2-prolapse", "porcine-1"}
        )
        self.assertEqual(len(rows), 4 * len(changes))
        self.assertEqual((folder / "ablation.png").read_bytes()[:4], PNG)

    def test_an_impossible_count_is_refused(self):
        result = coapt_lab("chart", "ablation", "--variations", "-1")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("--variations", result.stderr)


class Stability(ProgramTest):
    def test_one_axis_gives_a_table_and_a_picture_of_all_methods(self):
        result = coapt_lab(
            "chart", "stability", "--scene", "human-normal", "--axis", "pressure", "-o", self.folder / "new"
        )
        self.assertEqual((result.returncode, result.stdout), (OK, ""), result.stderr)
        with open(self.folder / "new" / "stability.csv", newline="") as file:
            cells = list(csv.DictReader(file))
        methods = ["thesis", "newton", "xpbd", "fast (springs)", "unguarded", "fast", "preconditioned", "coapt"]
        self.assertEqual([cell["method"] for cell in cells], [m for m in methods for _ in range(6)])
        self.assertEqual({cell["axis"] for cell in cells}, {"pressure"})
        self.assertEqual([cell["level"] for cell in cells if cell["nominal"] == "true"], ["16"] * len(methods))
        for cell in cells:
            if cell["method"] == "coapt":
                self.assertEqual(cell["crossing_pairs"], "0", cell)
        self.assertEqual((self.folder / "new" / "stability.png").read_bytes()[:4], PNG)

    def test_what_is_unknown_or_has_no_place_is_refused_before_anything_is_closed(self):
        self.assertEqual(coapt_lab("chart", "stability", "--axis", "weather").returncode, BAD_INPUT)
        self.assertEqual(coapt_lab("chart", "stability", "-o", "/proc/nowhere").returncode, FAILURE)


class Uniqueness(ProgramTest):
    def test_there_is_a_line_for_every_scene_and_rigidity_and_a_chart(self):
        arguments = ("--preset", "human-normal", "--scenes", "1", "--anatomies", "0", "--bending", "0.03", "0.1")
        result = coapt_lab("chart", "uniqueness", *arguments, "-o", self.folder)
        self.assertEqual((result.returncode, result.stdout), (OK, ""), result.stderr)
        with open(self.folder / "uniqueness.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(
            [(row["kind"], row["bending_n_mm"]) for row in rows],
            [("known", "0.03"), ("new", "0.03"), ("known", "0.1"), ("new", "0.1")],
        )
        self.assertEqual((self.folder / "uniqueness.png").read_bytes()[:4], PNG)


class Verdicts(ProgramTest):
    def test_every_valve_has_its_plans_and_the_agreement_is_printed(self):
        arguments = ("--plans", "2", "--nodes", "1", "--reference", "650")
        result = coapt_lab("chart", "verdicts", *arguments, "-o", self.folder)
        self.assertEqual(result.returncode, OK, result.stderr)
        self.assertIn("own mesh, all valves: ", result.stdout)
        self.assertIn(" of 12 verdicts agree", result.stdout)
        with open(self.folder / "verdicts.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["held_out"] for row in rows], ["false"] * 6 + ["true"] * 6)
        self.assertEqual((self.folder / "verdicts.png").read_bytes()[:4], PNG)


if __name__ == "__main__":
    unittest.main()
