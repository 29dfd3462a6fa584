"""A killed service goes on where it was, and one with a damaged database says so: tests/service/kill_nine.py with three searches,
damaged_databases.py with six databases."""

import json
import unittest

from programs import SERVER, ProgramTest, small_valve
import server_runs  # noqa: F401 (the path of kill_nine)

import damaged_databases  # found through server_runs
import kill_nine


class Kill(ProgramTest):
    def test_killed_searches_come_to_the_plans_of_undisturbed_ones(self):
        valve = json.loads(small_valve().read_text())
        figures = kill_nine.run(SERVER, self.folder, searches=3, evaluations=40, valves=[valve])
        self.assertEqual(figures["wrong"], [])
        self.assertGreaterEqual(figures["kills"], 3)

    def test_a_damaged_database_is_served_or_refused(self):
        figures = damaged_databases.run(SERVER, self.folder, seeds=range(6))
        self.assertEqual(figures["wrong"], [])


if __name__ == "__main__":
    unittest.main()
