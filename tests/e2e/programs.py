"""The binaries under test, as ctest names them, and what every test asks of them."""

import atexit
import functools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from process_runs import HANGS_S

COAPT = os.environ["COAPT"]
# Not for the programs under test: to them it is the address of a service.
SERVER = os.environ.pop("COAPT_SERVER")
SOURCE = pathlib.Path(__file__).resolve().parents[2]

OK, FAILURE, BAD_INPUT, NOT_CLOSED, NO_COMPETENT_PLAN, INTERRUPTED = 0, 1, 2, 3, 4, 130


def coapt(*arguments, stdin=""):
    """Runs coapt; the result has returncode, stdout, stderr."""
    command = [COAPT, *map(str, arguments)]
    return subprocess.run(command, input=stdin, capture_output=True, text=True, timeout=HANGS_S)


@functools.cache
def small_valve(preset="human-functional-mr"):
    """A file with the preset in about 200 triangles, for tests that do not ask about the mesh."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="coapt-small-"))
    atexit.register(shutil.rmtree, folder)
    path = folder / f"{preset}.json"
    subprocess.run([COAPT, "valve", "make", preset, "--triangles", "200", "-o", path], check=True)
    return path


class ProgramTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def make(self, preset, *arguments):
        path = self.folder / f"{preset}.json"
        self.run_ok("valve", "make", preset, *arguments, "-o", path)
        return path

    def run_ok(self, *arguments, stdin=""):
        result = coapt(*arguments, stdin=stdin)
        self.assertEqual(result.returncode, OK, result.stderr)
        return result
