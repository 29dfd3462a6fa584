"""Good, bad and hostile requests at once: tests/service/hostile.py, shortly."""

import unittest

from server_runs import ServerTest

import hostile  # found through server_runs


class Hostile(ServerTest):
    def test_every_kind_of_request_gets_its_answer_and_no_job_is_lost(self):
        figures = hostile.examine(self.server, requests=300, seconds=20.0, seed=1)
        self.assertEqual(figures["wrong"], [])
        self.assertEqual(set(figures["outcomes"]), {kind.__name__ for kind in hostile.KINDS})
        self.assertGreater(figures["jobs_at_end"], 0)


if __name__ == "__main__":
    unittest.main()
