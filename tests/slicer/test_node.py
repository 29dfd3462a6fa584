#!/usr/bin/env python3
"""test_node.py PACKAGE: without a coapt-server, node closes and plans by the npm package, and says what it cannot do."""

import json
import pathlib
import shutil
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "clients/slicer/Coapt"))

from CoaptLib import case, scene, service  # noqa: E402

PACKAGE = ROOT / "build/npm"
SMALL = {"evaluations": 6, "plans": 1, "region_points": 2, "evidence": False, "fine_levels": 0, "model_draws": 0}


class Node(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()  # a PATH without an installed coapt-server, which would go first
        cls.addClassCleanup(folder.cleanup)
        (pathlib.Path(folder.name) / "node").symlink_to(shutil.which("node"))
        cls.finder = service.Finder({"module": str(PACKAGE)}, {"PATH": folder.name})
        cls.service = service.waited(cls.finder.found())
        cls.taken = case.Case()
        cls.taken.take_valve(json.loads((PACKAGE / "presets/human-functional-mr.json").read_text()))

    @classmethod
    def tearDownClass(cls):
        process = cls.finder.started.process
        cls.finder.stop()
        assert process.poll() is not None

    def trouble(self, steps):
        with self.assertRaises(service.Trouble) as raised:
            service.waited(steps)
        return str(raised.exception)

    def test_a_valve_closes_and_is_drawn_with_its_motion(self):
        self.assertEqual(self.service.kind, "module")
        shown = service.waited(self.taken.closing(self.service))
        self.assertRegex(shown.words(), "^Leak ")
        self.assertEqual(len(scene.closing(shown.scene, shown.matrix)), case.FRAMES)
        self.assertIsNone(shown.markups)

    def test_a_search_is_a_job_that_tells_how_far_it_is_and_can_be_cancelled(self):
        self.assertEqual(len(service.waited(self.taken.planning(self.service, **SMALL))), 1)
        task, deadline = service.Task(self.taken.planning(self.service, evaluations=50000)), time.monotonic() + 1200
        while "closures" not in task.said or ": 0 " in task.said:
            self.assertFalse(task.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        task.cancel()
        while not task.poll():
            time.sleep(0.02)
        self.assertEqual(str(task.error), "The search was cancelled before it had a plan.")

    def test_what_it_cannot_do_and_what_is_wrong_is_said(self):
        self.assertIn("cannot import segmentations", self.trouble(self.taken.importing(self.service)))
        self.assertIn("cannot write reports", self.trouble(self.taken.reporting(self.service)))
        self.assertIn("/valve", self.trouble(self.asked(self.service.ask("POST", "/v1/closures", {"valve": {}}))))
        stranger = service.Service(self.service.url, "another")
        self.assertIn("asks for a token", self.trouble(self.asked(stranger.ask("GET", "/v1/presets"))))

    @staticmethod
    def asked(exchange):
        return (yield exchange)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PACKAGE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
