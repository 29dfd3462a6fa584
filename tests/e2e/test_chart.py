"""coapt chart."""

import csv
import unittest
import xml.etree.ElementTree

from programs import BAD_INPUT, ProgramTest, coapt


class Ablation(ProgramTest):
    def test_table_and_chart_show_the_same_changes(self):
        folder = self.folder / "charts"
        result = self.run_ok("chart", "ablation", "-o", folder, "--variations", "0", "--repeats", "1")
        self.assertEqual(result.stdout, "")
        with open(folder / "ablation.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        changes = {row["change"] for row in rows}
        self.assertEqual({row["scene"] for row in rows},
                         {"human-normal", "human-functional-mr", "human-p2-prolapse", "porcine-1"})
        self.assertEqual(len(rows), 4 * len(changes))
        tree = xml.etree.ElementTree.parse(folder / "ablation.svg")
        texts = {text.text for text in tree.iter("{http://www.w3.org/2000/svg}text")}
        self.assertLessEqual(changes, texts)

    def test_an_impossible_count_is_refused(self):
        result = coapt("chart", "ablation", "--variations", "-1")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("--variations", result.stderr)


if __name__ == "__main__":
    unittest.main()
