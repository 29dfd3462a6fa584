"""The plans of examples/plans: each mends the valve that its README names, and no rule of practice speaks against it."""

import json
import pathlib
import re
import unittest

from programs import OK, ProgramTest, coapt

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples" / "plans"
ROW = re.compile(r"^\| \[([a-z-]+\.json)\].*`([a-z0-9-]+)` \|$", re.MULTILINE)


class ExamplePlans(ProgramTest):
    def test_each_closes_its_valve_within_the_rules(self):
        rows = ROW.findall((FOLDER / "README.md").read_text())
        self.assertEqual(sorted(name for name, _ in rows), sorted(file.name for file in FOLDER.glob("*.json")))
        for name, valve in rows:
            result = coapt("close", valve, "--plan", FOLDER / name, "--json")
            self.assertEqual(result.returncode, OK, f"{name}: {result.stderr}")
            closure = json.loads(result.stdout)
            self.assertLess(closure["leak_mm2"], 1.0, name)
            self.assertEqual([], [warning for warning in closure["warnings"] if "rejected" in warning], name)


if __name__ == "__main__":
    unittest.main()
