#!/usr/bin/env python3
"""cmake/check_includes.py passes this repository and finds each kind of wrong arrow."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).resolve().parents[2] / "cmake/check_includes.py"
sys.path.insert(0, str(CHECK.parent))
from check_includes import complaints  # noqa: E402

PASSES = [
    ("core/closure/a.cpp", '#include "core/valve/valve.h"'),
    ("clients/cli/a.cpp", '#include "io/json/valve_json.h"'),
    ("server/endpoints/a.cpp", '#include "server/answer.h"'),
    ("io/store/a.cpp", "#include <sqlite3.h>"),
    ("search/parallel.h", "#pragma omp parallel for"),
    ("search/studies/a.cpp", '#include "search/plans/objective.h"'),
    ("search/plans/a.cpp", '#include "search/evaluator.h"'),
    ("server/endpoints/a.cpp", '#include "server/jobs/job_board.h"'),
    ("lab/comparators/a.cpp", '#include "core/closure/model.h"'),
    ("lab/cli/a.cpp", '#include "clients/cli/print.h"'),
]
PRODUCT = "core/closure search search/plans search/studies io/json io/picture server clients/cli lab/rivals".split()
FAILS = [
    ("core/valve/a.cpp", '#include "core/closure/closure.h"'),
    ("core/repair/a.h", '  #  include "core/closure/closure.h"'),
    ("core/closure/a.cpp", '#include "core/metrics/measure.h"'),
    ("core/metrics/a.cpp", '#include "search/search.h"'),
    ("search/a.cpp", '#include "io/json/valve_json.h"'),
    ("io/json/a.cpp", '#include "server/http.h"'),
    ("server/a.cpp", '#include "clients/cli/print.h"'),
    ("farm/program/a.cpp", '#include "clients/cli/print.h"'),
    ("clients/cli/a.cpp", '#include "server/http.h"'),
    ("io/json/a.cpp", '#include "tests/scenes/small_valve.h"'),
    ("core/valve/a.cpp", '#include "valve.h"'),
    ("core/valve/a.cpp", "#include <nlohmann/json.hpp>"),
    ("search/a.cpp", "#include <nlohmann/json.hpp>"),
    ("server/a.cpp", "#include <nlohmann/json.hpp>"),
    ("io/json/a.cpp", "#include <nlopt.hpp>"),
    ("search/a.cpp", "#include <sqlite3.h>"),
    ("core/valve/a.cpp", "#include <chrono>"),
    ("core/valve/a.cpp", "#pragma omp parallel for"),
    ("core/valve/a.cpp", "/**/ # pragma omp simd"),
    ("core/valve/a.cpp", "#include_next <chrono>"),
    ("search/plans/a.cpp", '#include "search/studies/findings.h"'),
    ("search/a.cpp", '#include "search/plans/objective.h"'),
    ("io/mesh/a.cpp", '#include "search/evaluator.h"'),
    ("io/json/a.cpp", '#include "io/picture/svg.h"'),
    ("io/exchange/a.cpp", '#include "io/store/subject.h"'),
    ("io/mesh/a.cpp", '#include "io/picture/import_picture.h"'),
    ("io/store/a.cpp", '#include "io/picture/svg.h"'),
    ("server/jobs/a.cpp", '#include "server/endpoints/jobs.h"'),
    ("core/colour/a.cpp", "#include <string>"),
    ("lab/comparators/a.cpp", '#include "search/search.h"'),
    ("lab/closures/a.cpp", '#include "clients/cli/print.h"'),
    ("lab/comparators/a.cpp", "#include <chrono>"),
    ("lab/comparators/a.cpp", "#pragma omp parallel for"),
    *((f"{folder}/a.cpp", '#include "lab/closures/closure_study.h"') for folder in PRODUCT),
]


class Includes(unittest.TestCase):
    def test_this_repository_passes(self):
        subprocess.run([CHECK], check=True)

    def test_a_tree_with_wrong_arrows_fails_and_names_each(self):
        with tempfile.TemporaryDirectory() as tree:
            for file, line in (("core/valve/a.cpp", "#include <chrono>"), ("io/json/a.h", '#include "server/http.h"')):
                (Path(tree) / file).parent.mkdir(parents=True)
                (Path(tree) / file).write_text(line + "\n")
            run = subprocess.run([CHECK, tree], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"^core/valve/a.cpp:1: .*<chrono>\nio/json/a.h:1: .* server/http.h\n$")

    def test_arrows_that_pass(self):
        for file, line in PASSES:
            self.assertEqual([], list(complaints(file, [line])))

    def test_arrows_that_fail(self):
        for file, line in FAILS:
            self.assertEqual(1, len(list(complaints(file, [line]))), (file, line))


if __name__ == "__main__":
    unittest.main()
