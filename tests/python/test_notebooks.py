"""The notebooks of the engine in this process run from top to bottom."""

import importlib.util
import inspect
import json
import os
import unittest

import coapt
import coapt.plots
from client_runs import has_engine
from programs import SOURCE

NOTEBOOKS = SOURCE / "clients/python/notebooks"


def installed(*packages):
    return unittest.skipUnless(has_engine() and all(map(importlib.util.find_spec, packages)), f"needs {packages}")


class Notebooks(unittest.TestCase):
    def setUp(self):
        os.environ["MPLBACKEND"] = "Agg"

    def names_of(self, notebook):
        """What its cells leave."""
        names, path = {}, NOTEBOOKS / notebook
        self.assertLess(path.stat().st_size, 300_000)
        self.assertIn(coapt.NOTICE.split(";")[1].strip(" ."), path.read_text())
        for cell in json.loads(path.read_text())["cells"]:
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), f"{notebook} {cell['id']}", "exec"), names)
        return names

    @installed("pandas", "matplotlib")
    def test_a_first_repair_leaks_less(self):
        names = self.names_of("first_repair.ipynb")
        leaks = [names[name].measure.leak_mm2 for name in ("after", "before")]
        self.assertLess(*leaks)
        self.assertLess(names["result"].plans[0].leak_mm2.nominal, leaks[1])

    @installed("pandas", "matplotlib")
    def test_in_a_study_of_ones_own_a_ring_takes_leak_back(self):
        leaks = self.names_of("own_study.ipynb")["leaks"]
        self.assertGreater(leaks["no repair"].iloc[-1], leaks["no repair"].iloc[0])
        self.assertLess(leaks["ring, three sizes below"].iloc[-1], leaks["no repair"].iloc[-1])

    @installed("pandas", "matplotlib")
    def test_every_drawing_is_shown(self):
        shown = (NOTEBOOKS / "drawings.ipynb").read_text()
        for name, draw in vars(coapt.plots).items():
            if inspect.isfunction(draw) and not name.startswith("_"):
                self.assertIn(f"plots.{name}", shown)
        self.assertEqual(self.names_of("drawings.ipynb")["best"].rank, 1)

    @installed("nlopt", "scipy")
    def test_an_objective_of_ones_own_is_minimised(self):
        names = self.names_of("own_objective.ipynb")
        self.assertLessEqual(names["optimizer"].last_optimum_value(), names["first"])
        self.assertLessEqual(names["found"].fun, names["first"])
        self.assertLess(names["searcher"].best[1], names["whole"](names["whole"].start))
        self.assertTrue(names["whole"].evaluate(names["whole"].vector(names["evolved"])).reason == "")

    @installed("sklearn")
    def test_a_surrogate_tells_closures_better_than_their_mean(self):
        names = self.names_of("surrogate.ipynb")
        self.assertGreater(names["known"].mean(), 0.8)
        self.assertLess(names["share"], 0.7)


if __name__ == "__main__":
    unittest.main()
