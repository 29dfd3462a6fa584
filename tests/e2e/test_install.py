"""cmake --install: what a package would hold."""

import shutil
import subprocess
import tempfile
import pathlib
import unittest

from programs import COAPT, OK


class Install(unittest.TestCase):
    def test_programs_completion_and_man_pages_are_installed(self):
        build = pathlib.Path(COAPT).parents[1]
        with tempfile.TemporaryDirectory() as prefix:
            run = subprocess.run(["cmake", "--install", build, "--prefix", prefix], capture_output=True, text=True)
            self.assertEqual(run.returncode, OK, run.stderr)
            names = {str(path.relative_to(prefix)) for path in pathlib.Path(prefix).rglob("*") if path.is_file()}
            expected = {
                "bin/coapt",
                "bin/coapt-farm",
                "bin/coapt-live",
                "bin/coapt-server",
                "share/bash-completion/completions/coapt",
                "share/bash-completion/completions/coapt-farm",
                "share/bash-completion/completions/coapt-live",
                "share/bash-completion/completions/coapt-server",
            }
            if (build.parent / "web/index.html").exists():
                expected |= {"share/coapt/web/index.html"}
            if shutil.which("scdoc"):
                expected |= {
                    f"share/man/man1/{name}.1" for name in ("coapt", "coapt-farm", "coapt-live", "coapt-server")
                }
            self.assertLessEqual(expected, names)
            version = subprocess.run([f"{prefix}/bin/coapt", "--version"], capture_output=True, text=True)
            self.assertEqual(version.returncode, OK)


if __name__ == "__main__":
    unittest.main()
