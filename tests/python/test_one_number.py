"""One quantity has one word and one value: what command line, JSON, CSV, Python, report and page say of a valve and a plan."""

import csv
import html
import json
import os
import re
import subprocess
import unittest

from client_runs import EngineTest, has_engine
from programs import NO_COMPETENT_PLAN, OK, SOURCE, coapt, small_valve


def plan_of(shape, size_mm, *steps):
    return {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": shape, "size_mm": size_mm}, *steps]}


RING = plan_of("generic-etlogix-like", 30)
SUTURE = plan_of(
    "generic-etlogix-like",
    32,
    {
        "step": "papillary_approximation",
        "side": "posteromedial",
        "anchor": "ipsilateral_trigone",
        "suture_length_mm": 26,
    },
)
NEOCHORDA = plan_of(
    "generic-classic",
    34,
    {
        "step": "neochorda",
        "head": "PM1",
        "length_mm": 17,
        "insertion": {"leaflet": "posterior", "along": 0.5, "height": 1},
    },
)
SIZE = {"region_points": 9, "model_draws": 8}
NUMBER = r"-?\d+(?:\.\d+)?"
WEB = SOURCE / "clients/web"


def flags(options):
    return [part for name, value in options.items() for part in (f"--{name.replace('_', '-')}", value)]


class OneNumber:
    """Of one valve with one plan."""

    preset, repair, said = "", None, None  # said: asked for once

    def setUp(self):
        super().setUp()
        self.valve = small_valve(self.preset)
        self.plan = self.write("plan.json", self.repair)
        if self.said is None:
            type(self).said = self.ask()
        self.__dict__.update(self.said)

    def ask(self):
        scoring = ("evaluate", self.valve, self.plan, "--no-evidence", *flags(SIZE))
        page, table = self.folder / "report.html", self.folder / "measures.csv"
        repaired = (self.valve, "--plan", self.plan)
        self.answer("export", *repaired, "-o", table)
        with open(table, encoding="utf-8") as file:
            measures = {row["Metric"]: row["Value"] for row in csv.DictReader(file)}
        return {
            "scored": json.loads(self.answer(*scoring, "--json", "-o", page)),
            "report": self.text_of(page.read_text()),
            "words": " ".join(self.answer(*scoring).split()),
            "closed": json.loads(self.answer("close", *repaired, "--open", "--json")),
            "closed_words": self.answer("close", *repaired, "--open"),
            "python": self.client.evaluate(self.valve, [self.plan], **SIZE),
            "python_closed": self.client.close(self.valve, self.plan),
            "csv": measures,
        }

    def answer(self, *arguments):
        result = coapt(*arguments)
        self.assertIn(result.returncode, (OK, NO_COMPETENT_PLAN), result.stderr)
        return result.stdout

    def text_of(self, page):
        """Without tags and pictures, spaces single."""
        return " ".join(html.unescape(re.sub(r"<(style|svg)\b.*?</\1>|<[^>]*>", " ", page, flags=re.S)).split())

    def assert_value(self, value, *others):
        """The same bits."""
        for other in others:
            self.assertEqual(other, value)

    def assert_printed(self, value, *texts, before, after=""):
        """In each text what stands between `before` and `after` is the value to the digits that are printed."""
        for text in texts:
            found = re.search(f"{before} *({NUMBER}){after}", text)
            self.assertIsNotNone(found, f"{before!r} in {text[:2000]}")
            decimals = len(found[1].partition(".")[2])
            self.assertEqual(found[1], f"{value + 0.0:.{decimals}f}", before)

    def ranked(self):
        return self.scored["plans"][0]

    def test_leak(self):
        plan, python = self.ranked(), self.python.plans[0]
        leak = plan["leak"]["area_mm2"]
        self.assert_value(
            leak,
            plan["measure"]["leak_mm2"],
            plan["leak_mm2"]["nominal"],
            self.closed["leak_mm2"],
            self.closed["leak"]["area_mm2"],
            python.measure.leak_mm2,
            python.leak_mm2.nominal,
            self.python_closed.measure.leak_mm2,
        )
        self.assertEqual(plan["leak"], python.json["leak"])
        self.assert_printed(leak, self.words, before="leak as planned:")
        self.assert_printed(leak, self.closed_words, before=r"\n  leak")
        self.assert_printed(leak, self.report, before="Leak as planned")
        self.assert_printed(float(leak), self.csv["Regurgitant orifice area"], before="")
        # Digits and interval of either text are of the widest error.
        said = re.search(rf"leak as planned: ({NUMBER}.*?) mm2", self.words)[1]
        self.assertIn(f"Leak as planned {said}", self.report.replace(" mm²", "").replace(" (", "; "))

    def test_leak_of_the_valve_as_it_is(self):
        before = self.scored["before"]
        as_it_is = json.loads(self.answer("close", self.valve, "--json"))
        leak = before["leak"]["area_mm2"]
        self.assert_value(
            leak, before["leak_mm2"], as_it_is["leak_mm2"], self.client.close(self.valve).measure.leak_mm2
        )
        self.assert_printed(leak, self.words, before="Before: leak")
        low, high = before["leak"]["tissue"]
        for text, words in (
            (self.words, rf"; ({NUMBER}) to ({NUMBER}) mm2 with tissue error"),
            (self.report, rf"before {NUMBER} \(({NUMBER}) to ({NUMBER})\)"),
        ):
            found = re.search(words, text)
            self.assertIsNotNone(found, words)
            self.assertEqual((found[1], found[2]), (f"{low:.0f}", f"{high:.0f}"))

    def test_tissue_of_the_valve_as_it_is(self):
        """The same draws, closed from other starts: one of a flail valve ends 5 % elsewhere."""
        draws = str(SIZE["model_draws"])
        alone = json.loads(self.answer("close", self.valve, "--draws", draws, "--json"))["leak"]["tissue"]
        for here, there in zip(self.scored["before"]["leak"]["tissue"], alone):
            self.assertAlmostEqual(here, there, delta=1.0 + 0.1 * there)

    def test_opening_and_gradient(self):
        plan, python = self.ranked(), self.python.plans[0]
        opened = json.loads(self.answer("open", self.valve, "--plan", self.plan, "--json"))
        for name, words, unit in (
            ("opening_area_mm2", "Opening in diastole", 0.01),
            ("gradient_mmhg", "mean gradient", 1),
        ):
            value = plan[name]
            self.assert_value(
                value,
                plan["estimates"][name]["value"],
                self.closed["opening"][name],
                opened[name],
                getattr(python, name),
                getattr(self.client.open(self.valve, self.plan), name),
            )
            self.assert_printed(unit * value, self.report, before=words)
        self.assert_printed(0.01 * plan["opening_area_mm2"], self.closed_words, before="opening")
        self.assert_printed(plan["gradient_mmhg"], self.closed_words, before="mean gradient")
        row = plan["row"]
        self.assert_printed(0.01 * plan["opening_area_mm2"], row["opening"], before="", after=" cm²")
        self.assert_printed(plan["gradient_mmhg"], row["opening"], before="cm²,", after=" mmHg")

    @unittest.skipUnless((WEB / "node_modules").is_dir(), "the page's packages are not installed")
    def test_page(self):
        printed = {"scored": self.scored, "words": self.words, "closed": self.closed, "closed_words": self.closed_words}
        run = subprocess.run(
            ["npx", "--no-install", "vitest", "run", "test/unit/one_number.test.ts"],
            cwd=WEB,
            env={**os.environ, "VITE_PRINTED": str(self.write("printed.json", printed))},
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_row(self):
        row, python = self.ranked()["row"], self.python.plans[0]
        self.assert_value(row, python.json["row"])
        self.assertRegex(self.words, r"\b1 +" + " +".join(re.escape(cell) for cell in row.values()))

    def test_coaptation(self):
        plan, python = self.ranked(), self.python.plans[0]
        for name, words in (("mean", "Coaptation height, mean"), ("min", "minimum")):
            height = plan["measure"]["coaptation"][f"height_{name}_mm"]
            self.assert_value(
                height,
                self.closed["coaptation"][f"height_{name}_mm"],
                getattr(python.measure, f"coaptation_height_{name}_mm"),
                getattr(self.python_closed.measure, f"coaptation_height_{name}_mm"),
            )
            self.assert_printed(height, self.report, before=words)
            self.assert_printed(height, self.csv[f"Coaptation anterior - posterior height ({name})"], before="")
            self.assert_printed(height, self.closed_words, before=f"(?:height|,) {name}")
        of_rule = plan["estimates"]["coaptation_a2_p2_mm"]["value"]
        finding = next(gate["finding"] for gate in plan["gates"] if gate["rule"] == "coaptation_height")
        self.assert_printed(of_rule, finding, self.words, self.report, before="coaptation height of A2 with P2 is")
        sections = plan["measure"]["coaptation"]["sections"]
        self.assertAlmostEqual(of_rule, sum(section["height_mm"] for section in sections[3:6]) / 3, places=9)

    def test_tension(self):
        plan, python = self.ranked(), self.python.plans[0]
        tension = plan["measure"]["tension_max_n"]
        self.assert_value(
            tension,
            plan["estimates"]["tension_max_n"]["value"],
            self.closed["tension_max_n"],
            python.measure.tension_max_n,
            self.python_closed.measure.tension_max_n,
        )
        self.assert_printed(tension, self.report, before="Highest chordal tension")
        self.assert_printed(tension, self.closed_words, before="highest tension")
        self.assertIn(f"highest chordal tension: {python.estimates['tension_max_n'].words('N')}", self.words)
        finding = next(gate["finding"] for gate in plan["gates"] if gate["rule"] == "chordal_tension")
        self.assert_printed(tension, finding, before=f"highest chordal tension changes from {NUMBER} to")

    def test_probability(self):
        plan, python = self.ranked(), self.python.plans[0]
        likely = plan["acceptable_probability"]
        self.assert_value(likely, python.acceptable_probability)
        self.assert_value(self.scored["verdict"], self.python.json["verdict"])
        bound, number = re.search(rf"\(([<>] )?({NUMBER}) %\)", plan["row"]["leak"]).groups()
        said = re.findall(
            rf"less than 5 mm² with a probability of (?:only )?(more than |less than |)({NUMBER}) %",
            self.words + self.report,
        )
        bounds = {"> ": "more than ", "< ": "less than ", None: ""}
        self.assertEqual(set(said), {(bounds[bound], number)})
        if bound is None:
            self.assert_printed(100 * likely, number, before="")
        else:
            self.assertEqual(100 * likely > float(number), bound == "> ")

    def test_every_figure_of_a_rule_has_an_interval(self):
        for estimates in (self.ranked()["estimates"], self.scored["before"]["estimates"]):
            measured = ("strain_circumferential_max", "strain_radial_max")
            for name in ("coaptation_a2_p2_mm", "tension_max_n", "opening_area_mm2", "gradient_mmhg", *measured):
                low, high = estimates[name]["numerical"]
                self.assertLessEqual(0, low)
                self.assertLess(low, high)
        for name in ("coaptation_a2_p2_mm", "tension_max_n"):
            for part in ("tissue", "execution"):
                low, high = self.ranked()["estimates"][name][part]
                self.assertLessEqual(low, high)
        ratio = self.ranked()["estimates"]["leaflet_ratio"]
        self.assertEqual(ratio["value"] is None, ratio["numerical"] is None)
        # Without evidence only that of a plan that leaks is known.
        leaks = self.ranked()["leak_mm2"]["nominal"] > 5
        self.assertEqual(self.ranked()["estimates"]["durability_mm"]["value"], 0 if leaks else None)

    def test_what_is_a_percentile_says_so(self):
        self.assertRegex(self.closed_words, r"leaflet strain +99th percentiles: circumferential")


def test_of(preset, repair):
    name = "".join(part.title() for part in preset.split("-"))
    made = type(name, (OneNumber, EngineTest), {"preset": preset, "repair": repair, "__module__": __name__})
    return unittest.skipUnless(has_engine(), "no engine")(made)


HumanFunctionalMr = test_of("human-functional-mr", RING)
SecondaryMr = test_of("secondary-mr", SUTURE)
Barlow = test_of("barlow", RING)
HumanP2Prolapse = test_of("human-p2-prolapse", NEOCHORDA)
FibroelasticFlail = test_of("fibroelastic-flail", NEOCHORDA)
Marfan = test_of("marfan", SUTURE)


if __name__ == "__main__":
    unittest.main()
