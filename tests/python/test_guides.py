"""The examples that the documentation names run."""

import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import coapt
from client_runs import VALVE, ClientTest, has_engine
from programs import OK, SOURCE

EXAMPLES = SOURCE / "examples/python"
DRAWS = importlib.util.find_spec("pandas") and importlib.util.find_spec("matplotlib")


class Examples(ClientTest):
    def setUp(self):
        super().setUp()
        os.environ["MPLBACKEND"] = "Agg"

    @unittest.skipUnless(DRAWS, "pandas and matplotlib are not installed")
    def test_the_notebook_runs(self):
        notebook = EXAMPLES / "repair.ipynb"
        self.assertLess(notebook.stat().st_size, 20_000, "outputs are not kept")
        names = {}
        os.environ["COAPT_SERVER"] = self.url
        self.addCleanup(os.environ.pop, "COAPT_SERVER")
        for cell in json.loads(notebook.read_text())["cells"]:
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
        self.assertEqual(names["result"].plans[0].rank, 1)
        self.assert_practicable(names["by_hand"])

    def test_the_script_prints_plans_and_leaves_files(self):
        surroundings = os.environ | {"COAPT_SERVER": self.url}
        run = subprocess.run(
            [sys.executable, EXAMPLES / "first_plan.py", self.make(VALVE)],
            cwd=self.folder,
            text=True,
            capture_output=True,
            env=surroundings,
        )
        self.assertEqual(run.returncode, OK, run.stderr)
        self.assertIn("1. leak", run.stdout)
        self.assertIn("research software", run.stderr)
        for name in ("before-after.png", "best-plan.json", "closed.stl", "report.html"):
            self.assertGreater((self.folder / name).stat().st_size, 100)
        self.assertEqual(coapt.Plan.read(self.folder / "best-plan.json").to_json()["schema"], "coapt.plan/1")

    def run_blocks(self, document):
        """Runs the Python of a document, in a folder of its own that has the examples; the names it leaves."""
        code = "\n".join(re.findall("```python\n(.*?)```", document.read_text(), re.DOTALL))
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        self.addCleanup(os.chdir, pathlib.Path.cwd())
        os.chdir(self.folder)
        names = {}
        exec(compile(code.replace("http://127.0.0.1:8080", self.url), document.name, "exec"), names)
        return names

    def assert_practicable(self, plan):
        """No rule of practice rejects it."""
        gates = self.client.evaluate(VALVE, [plan]).plans[0].json["gates"]
        self.assertEqual([gate["finding"] for gate in gates if gate["severity"] == "reject"], [])

    @unittest.skipUnless(has_engine(), "no engine")
    def test_the_line_of_the_readme_runs(self):
        leak = eval(re.search(r"`(coapt\.preset\(.*?)`", (SOURCE / "README.md").read_text())[1])
        self.assertEqual(leak, self.client.close(VALVE).measure.leak_mm2)

    @unittest.skipUnless(has_engine(), "no engine")
    def test_the_package_says_what_the_readme_says(self):
        names = self.run_blocks(SOURCE / "clients/python/README.md")
        self.assertTrue((self.folder / "before-after.png").exists())
        self.assert_practicable(names["plan"])

    @unittest.skipUnless(has_engine(), "no engine")
    def test_the_sites_front_page_runs(self):
        names = self.run_blocks(SOURCE / "docs/site/index.md")
        self.assertLess(names["after"].measure.leak_mm2, names["before"].measure.leak_mm2)

    @unittest.skipUnless(DRAWS and has_engine(), "pandas, matplotlib and the engine are needed")
    def test_the_guide_runs(self):
        names = self.run_blocks(SOURCE / "docs/engineer/python.md")
        self.assert_practicable(names["plan"])
        self.assertGreater((self.folder / "map.pdf").stat().st_size, 1000)
        self.assertEqual(list(names["table"].valve), ["human-normal", "porcine-1"])
        leaks = [
            self.client.close(VALVE, SOURCE / f"examples/plans/{name}.json").measure.leak_mm2
            for name in ("ring", "mixed")
        ]
        self.assertEqual(
            names["asyncio"].run(names["leaks"](["examples/plans/ring.json", "examples/plans/mixed.json"])), leaks
        )


if __name__ == "__main__":
    unittest.main()
