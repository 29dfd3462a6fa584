#!/usr/bin/env python3
"""cmake/check_includes.py and check_functions.py pass this repository and find each kind of wrong arrow and of a function elsewhere."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).resolve().parents[2] / "cmake/check_includes.py"
sys.path.insert(0, str(CHECK.parent))
import check_functions  # noqa: E402
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


class Functions(unittest.TestCase):
    def found(self, **texts):
        """Complaints of sources by their names, `a_h` for io/a.h."""
        files = ((f"io/{name.replace('_', '.')}", text) for name, text in texts.items())
        return list(check_functions.complaints(files))

    def test_this_repository_passes(self):
        subprocess.run([CHECK.with_name("check_functions.py")], check=True)

    def test_functions_and_those_of_classes_are_found_elsewhere(self):
        header = (
            "struct Kept {\n  int count() const;\n};\nstd::vector<int> read(const Kept& from,\n    int first = 0);\n"
        )
        source = "int Kept::count() const {\n}\nstd::vector<int> read(const Kept& from, int first) {\n}\n"
        self.assertEqual(self.found(a_h=header, a_cpp=source), [])
        self.assertEqual(
            self.found(a_h=header, b_cpp=source),
            ["io/b.cpp: Kept::count() is declared in io/a.h", "io/b.cpp: read() is declared in io/a.h"],
        )

    def test_other_overloads_and_a_source_s_own_functions_are_not(self):
        header = "void read(const Kept& from);\n"
        self.assertEqual(self.found(a_h=header, b_cpp="void read(int from) {\n}\n"), [])
        own = "namespace {\nvoid read(const Kept& from) {\n}\n}  // namespace\n"
        self.assertEqual(self.found(a_h=header, b_cpp=own), [])

    def test_headers_that_front_several_files_pass(self):
        self.assertEqual(self.found(commands_h="void add(int to);\n", b_cpp="void add(int to) {\n}\n"), [])


if __name__ == "__main__":
    unittest.main()
