"""cmake --install --component library: libcoapt, and the C++ example built against it."""

import pathlib
import re
import subprocess
import tempfile
import unittest

from process_runs import HANGS_S
from programs import COAPT, SOURCE

BUILD = pathlib.Path(COAPT).parents[1]
# Other builds name their sources in debug information and assertions.
IS_RELEASE = "CMAKE_BUILD_TYPE:STRING=Release" in (BUILD / "CMakeCache.txt").read_text()


class Library(unittest.TestCase):
    def run_ok(self, *command):
        run = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=HANGS_S)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_the_example_builds_against_a_moved_installation(self):
        with tempfile.TemporaryDirectory() as folder:
            installed, moved, build = (pathlib.Path(folder) / name for name in ("installed", "moved", "build"))
            self.run_ok("cmake", "--install", BUILD, "--component", "library", "--prefix", installed)
            installed.rename(moved)
            self.assert_names_no_build_path(moved)
            self.run_ok("cmake", "-S", SOURCE / "examples/cpp", "-B", build, f"-DCMAKE_PREFIX_PATH={moved}")
            self.run_ok("cmake", "--build", build)
            self.check_output(self.run_ok(build / "first_repair"))

    def assert_names_no_build_path(self, prefix):
        for path in filter(pathlib.Path.is_file, prefix.rglob("*")):
            if path.suffix == ".a" and not IS_RELEASE:
                continue
            content = path.read_bytes()
            for place in (SOURCE, BUILD, prefix.parent / "installed"):
                self.assertNotIn(bytes(place), content, f"{path.name} names {place}")

    def check_output(self, text):
        leaks = [float(leak) for leak in re.findall(r": +converged, leak ([\d.]+) mm2", text)]
        self.assertEqual(len(leaks), 2, text)
        self.assertLess(leaks[1], leaks[0])
        self.assertRegex(
            text, r"1\. leak [\d.]+ mm2 as planned, [\d.]+ \(sd [\d.]+\) over its region\n   annuloplasty: "
        )
        self.assertIn("\n2. leak ", text)


if __name__ == "__main__":
    unittest.main()
