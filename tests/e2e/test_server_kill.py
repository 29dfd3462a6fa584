"""A killed service goes on where it was: tests/service/kill_nine.py with three searches."""

import unittest

from programs import SERVER, ProgramTest
import server_runs  # noqa: F401 (the path of kill_nine)

import kill_nine  # found through server_runs


class Kill(ProgramTest):
    def test_killed_searches_come_to_the_plans_of_undisturbed_ones(self):
        figures = kill_nine.run(SERVER, self.folder, searches=3, evaluations=40)
        self.assertEqual(figures["wrong"], [])
        self.assertGreaterEqual(figures["kills"], 3)


if __name__ == "__main__":
    unittest.main()
