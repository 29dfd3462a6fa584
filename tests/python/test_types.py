"""The types of the package, by mypy."""

import pathlib
import shutil
import subprocess
import tempfile
import textwrap
import unittest

from programs import OK, SOURCE


class Types(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_the_package_is_strictly_typed(self):
        with tempfile.TemporaryDirectory() as cache:
            run = subprocess.run(
                ["mypy", "--cache-dir", cache], cwd=SOURCE / "clients/python", capture_output=True, text=True
            )
        self.assertEqual(run.returncode, OK, run.stdout)

    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_a_misspelt_option_is_found(self):
        lines = """import coapt
        valve = coapt.preset("human-normal")
        valve.search(evaluations=3, seed=1).result().plans[0].rank
        valve.close(pressure_mmhg=140).strain.shape
        valve.search(evaluatoins=3)
        valve.close(presure_mmhg=140)
        valve.space(forbiden=[])
        """
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "script.py"
            file.write_text(textwrap.dedent(" " * 8 + lines))
            run = subprocess.run(
                ["mypy", "--cache-dir", f"{folder}/cache", "--strict", "--config-file", "pyproject.toml", file],
                cwd=SOURCE / "clients/python", capture_output=True, text=True,
            )  # fmt: skip
        found = [line.split(":")[1] for line in run.stdout.splitlines() if "script.py" in line and ": error:" in line]
        self.assertEqual(found, ["5", "6", "7"], run.stdout)


if __name__ == "__main__":
    unittest.main()
