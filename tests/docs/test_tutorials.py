#!/usr/bin/python3
"""How a tutorial is followed, on pages of plain commands."""

import pathlib
import unittest

from check_tutorials import followed

NOWHERE = pathlib.Path("/nonexistent/bin")


def page(*lines):
    return "\n".join(["# Page", "```console", *lines, "```", ""])


class Tutorials(unittest.TestCase):
    def follow(self, text):
        return followed(text, NOWHERE)

    def test_what_agrees_stays_and_seconds_do_not_count(self):
        text = page("$ x=1", "$ echo $x; echo done in 3.5 s", "1", "done in 7 s") + page("$ echo $x again", "1 again")
        self.assertEqual(self.follow(text), (text, []))

    def test_what_differs_is_named_and_corrected(self):
        corrected, wrong = self.follow(page("$ echo one; echo two >&2", "1"))
        self.assertEqual(corrected, page("$ echo one; echo two >&2", "one", "two"))
        self.assertEqual(wrong, ["$ echo one; echo two >&2\none\ntwo"])

    def test_dots_stand_for_whatever_follows(self):
        text = page("$ seq 3", "1", "...")
        self.assertEqual(self.follow(text), (text, []))
        self.assertEqual(self.follow(page("$ seq 3", "2", "..."))[0], text)

    def test_a_file_is_saved_before_and_a_service_gets_another_port(self):
        text = "Save this as `a.py`:\n```python\nprint(6 * 7)\n```\n" + page(
            "$ python3 a.py; echo :8080", "42", ":8080"
        )
        self.assertEqual(self.follow(text), (text, []))


if __name__ == "__main__":
    unittest.main()
