"""The types of the package, by mypy."""

import shutil
import subprocess
import tempfile
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


if __name__ == "__main__":
    unittest.main()
