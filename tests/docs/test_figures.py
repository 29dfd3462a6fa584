#!/usr/bin/env python3
"""What check_figures.py and check_documents.py find in documents that are wrong."""

import pathlib
import tempfile
import unittest

from check_documents import missing_files
from check_figures import agrees, cell_problem, table_problems, tables


class Tables(unittest.TestCase):
    def test_a_number_agrees_if_it_is_the_files_rounded_to_its_digits(self):
        for printed, value in (
            ("57.7", "57.70"),
            ("2.6", "2.65"),
            ("2.7", "2.65"),
            ("1,112", "1111.6"),
            ("-0.4", "-0.37"),
        ):
            self.assertTrue(agrees(printed, value), printed)
        for printed, value in (("53.1", "57.7"), ("58", "57.4"), ("0.0", "0.06"), ("1112", "1112.6")):
            self.assertFalse(agrees(printed, value), printed)

    def test_a_cell_says_which_of_its_numbers_is_another(self):
        self.assertEqual(cell_problem("3.2 / 1.8", ["3.18", "1.75"]), (None, 2))
        self.assertEqual(cell_problem("3.2 / 1.7", ["3.18", "1.84"]), ("prints 1.7, the file has 1.84", 2))
        self.assertEqual(cell_problem("9 of 9", ["9", 9]), (None, 2))
        self.assertEqual(cell_problem("ring 38", "ring 40")[0], "prints 'ring 38', the file has 'ring 40'")
        self.assertIn("prints ''", cell_problem("", ["1.0"])[0])

    def test_tables_have_the_line_that_they_begin_at(self):
        text = "words\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n  | c |\n  |---|\n"
        found = list(tables(text))
        self.assertEqual([(line, header) for line, header, _ in found], [(3, "| a | b |"), (7, "| c |")])
        self.assertEqual(found[0][2][2], ["1", "2"])

    def test_the_documents_tables_are_found_and_compared(self):
        wrong, compared = table_problems()
        self.assertEqual(wrong, [])
        self.assertGreater(compared, 700)


class Examples(unittest.TestCase):
    def test_a_script_that_is_not_there_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(
                "`lab/charts/plot.py` and `examples/scripts/*.py`\n```\nexamples/gone.py x\n```\nlab/prose.py\n"
            )
            self.assertEqual(missing_files(page), ["examples/gone.py"])


if __name__ == "__main__":
    unittest.main()
