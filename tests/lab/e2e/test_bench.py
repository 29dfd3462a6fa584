"""coapt-lab bench."""

import json
import unittest

from laboratory import coapt_lab
from programs import BAD_INPUT, OK, SOURCE, ProgramTest

CLOSURES = ("bench", "closures", "human-normal")


class BenchClosures(ProgramTest):
    def test_an_accuracy_chooses_the_tolerances_that_are_measured(self):
        bench = coapt_lab(*CLOSURES, "--count", "1", "--no-accuracy", "--json", "--accuracy", "5.6")
        self.assertEqual(bench.returncode, OK, bench.stderr)
        self.assertEqual(json.loads(bench.stdout)["accuracy"]["residual_tolerance"], 0.1)

    def test_all_presets_are_closed_in_turn(self):
        bench = coapt_lab("bench", "closures", "presets", "--count", "15", "--no-accuracy")
        self.assertEqual(bench.returncode, OK, bench.stderr)
        self.assertIn("15 closures: ", bench.stdout)
        self.assertNotIn("scene", bench.stdout)

    def test_warm_starts_of_method_thesis_are_refused(self):
        result = coapt_lab(*CLOSURES, "--warm", "--method", "thesis")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("--warm: is available only for method fast", result.stderr)


class BenchSearch(ProgramTest):
    def test_a_lattice_that_is_not_there_is_refused_with_those_that_are(self):
        real = SOURCE / "examples/valves/bodyparts3d-leaking.json"
        result = coapt_lab("bench", "search", "--lattice", "moon", "--real", real, "-o", self.folder / "search")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("porcine-both", result.stderr)


class BenchIndications(ProgramTest):
    def test_a_valve_that_is_not_of_the_table_is_refused_with_those_that_are(self):
        result = coapt_lab(
            "bench", "indications", "--members", "0", "--valve", "moon", "-o", self.folder / "indications.csv"
        )
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("must be a valve of the table: atrial, ischaemic", result.stderr)


if __name__ == "__main__":
    unittest.main()
