"""The examples in the package's docstrings run and answer what they say."""

import doctest
import importlib.util
import inspect
import os
import pkgutil
import subprocess
import unittest

import coapt
from client_runs import has_engine
from coapt import plots
from programs import COAPT, OK, SOURCE, ProgramTest

DRAWS = importlib.util.find_spec("pandas") and importlib.util.find_spec("matplotlib")
MODULES = [one.name for one in pkgutil.iter_modules(coapt.__path__, "coapt.") if one.name != "coapt._engine"]


@unittest.skipUnless(has_engine() and DRAWS, "the engine, pandas and matplotlib are needed")
class Docstrings(ProgramTest):
    """An example goes on from that of the package, with the public names; it runs where examples/ is."""

    def setUp(self):
        super().setUp()
        os.environ["MPLBACKEND"] = "Agg"
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        run = subprocess.run([COAPT, "export", "human-normal", "--open", "-o", f"{self.folder}/exported/"])
        self.assertEqual(run.returncode, OK)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def test_every_example_answers_what_it_says(self):
        finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
        failures = []
        first = finder.find(coapt, "coapt")[0]
        runner.run(first, out=failures.append, clear_globs=False)
        names = {name: getattr(coapt, name) for name in coapt.__all__} | first.globs
        run = {first.docstring}  # a valve's functions have those of the engine's
        for module in MODULES:
            for test in finder.find(importlib.import_module(module), globs=names):
                if test.docstring not in run:
                    runner.run(test, out=failures.append, clear_globs=False)
                run.add(test.docstring)
        self.assertEqual("".join(failures), "")
        self.assertGreater(runner.tries, 200)

    def test_every_public_name_has_an_example(self):
        silent = []
        for name in coapt.__all__:
            thing = getattr(coapt, name)
            if callable(thing):
                silent += [] if ">>> " in (thing.__doc__ or "") else [name]
            if isinstance(thing, type):
                silent += [f"{name}.{one}" for one in dir(thing) if is_silent(thing, one)]
        drawings = inspect.getmembers(plots, inspect.isfunction)
        silent += [name for name, drawing in drawings if is_silent(plots, name) and drawing.__module__ == "coapt.plots"]
        self.assertEqual(silent, [])


def is_silent(kind, name):
    """Functions and properties of the package's own; its documents speak for themselves."""
    value = inspect.getattr_static(kind, name)
    function = getattr(value, "fget", None) or getattr(value, "__func__", value)
    known = name.startswith("_") or name in ("to_json", "from_json", "from_ply")
    ours = inspect.isfunction(function) and function.__module__.startswith("coapt")
    return ours and not known and ">>> " not in (function.__doc__ or "")


if __name__ == "__main__":
    unittest.main()
