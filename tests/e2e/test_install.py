"""cmake --install: what a package would hold."""

import shutil
import subprocess
import tempfile
import pathlib
import unittest

from programs import COAPT, OK


class Install(unittest.TestCase):
    def install(self, prefix, *options):
        """Paths of what was installed, below the prefix."""
        build = pathlib.Path(COAPT).parents[1]
        run = subprocess.run(
            ["cmake", "--install", build, "--prefix", prefix, *options], capture_output=True, text=True
        )
        self.assertEqual(run.returncode, OK, run.stderr)
        return {str(path.relative_to(prefix)) for path in pathlib.Path(prefix).rglob("*") if path.is_file()}

    def test_programs_completion_and_man_pages_are_installed(self):
        build = pathlib.Path(COAPT).parents[1]
        with tempfile.TemporaryDirectory() as prefix:
            names = self.install(prefix)
            expected = {
                "bin/coapt",
                "bin/coapt-farm",
                "bin/coapt-server",
                "share/bash-completion/completions/coapt",
                "share/bash-completion/completions/coapt-farm",
                "share/bash-completion/completions/coapt-live",
                "share/bash-completion/completions/coapt-server",
                "share/doc/coapt/README.md",
                "share/doc/coapt/docs/surgeon.md",
                "share/doc/coapt/examples/plans/ring.json",
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

    def test_a_component_is_one_program_with_what_belongs_to_it(self):
        with tempfile.TemporaryDirectory() as prefix:
            names = self.install(prefix, "--component", "coapt-farm")
            expected = {"bin/coapt-farm", "share/bash-completion/completions/coapt-farm"}
            if shutil.which("scdoc"):
                expected |= {"share/man/man1/coapt-farm.1"}
            self.assertEqual(names, expected)

    def test_the_python_package_holds_sources_types_and_the_engine(self):
        with tempfile.TemporaryDirectory() as prefix:
            names = {pathlib.PurePath(name).name for name in self.install(prefix, "--component", "python")}
        if not names:
            self.skipTest("built without the engine")
        self.assertLessEqual({"__init__.py", "local.py", "py.typed", "_engine.pyi"}, names)
        self.assertEqual(sum(name.startswith("_engine.") and name.endswith(".so") for name in names), 1)


if __name__ == "__main__":
    unittest.main()
