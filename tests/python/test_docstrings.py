"""The examples in the package's docstrings run and answer what they say."""

import doctest
import importlib.util
import os
import pkgutil
import unittest

import coapt
from client_runs import has_engine
from programs import SOURCE, ProgramTest

DRAWS = importlib.util.find_spec("pandas") and importlib.util.find_spec("matplotlib")
MODULES = [one.name for one in pkgutil.iter_modules(coapt.__path__, "coapt.") if one.name != "coapt._engine"]


@unittest.skipUnless(has_engine() and DRAWS, "the engine, pandas and matplotlib are needed")
class Docstrings(ProgramTest):
    """Beside the public names an example has client, an engine in this process; it runs where examples/ is."""

    def setUp(self):
        super().setUp()
        os.environ["MPLBACKEND"] = "Agg"
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def test_every_example_answers_what_it_says(self):
        names = {name: getattr(coapt, name) for name in coapt.__all__} | {"coapt": coapt, "client": coapt.engine()}
        finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
        failures = []
        for module in ["coapt", *MODULES]:
            for test in finder.find(importlib.import_module(module), globs=names):
                runner.run(test, out=failures.append, clear_globs=False)
        self.assertEqual("".join(failures), "")
        self.assertGreater(runner.tries, 50)

    def test_every_public_name_has_an_example_and_every_function_says_what_it_is(self):
        silent = []
        for name in coapt.__all__:
            thing = getattr(coapt, name)
            if isinstance(thing, type) or callable(thing):
                silent += [] if ">>> " in (thing.__doc__ or "") else [name]
            if isinstance(thing, type):
                silent += [f"{name}.{one}" for one, value in vars(thing).items() if is_silent(one, value)]
        self.assertEqual(silent, [])


def is_silent(name, value):
    function = getattr(value, "func", None) or getattr(value, "fget", None) or getattr(value, "__func__", value)
    known = name.startswith("_") or name in ("to_json", "from_json") or not callable(function)
    return not known and not (function.__doc__ or "").strip()


if __name__ == "__main__":
    unittest.main()
