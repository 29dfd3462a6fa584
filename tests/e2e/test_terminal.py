"""Nothing that strangers have written moves the terminal: names in valves, plans and files, and what services answer."""

import json
import re
import unittest

from programs import ProgramTest, coapt, small_valve

BAD = "\x1b[2J\x07\u009b31m\rx"
MOVES = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


class Terminal(ProgramTest):
    def check(self, *arguments):
        run = coapt(*arguments)
        for text in (run.stdout, run.stderr):
            found = MOVES.search(text)
            self.assertIsNone(found, f"{arguments}: {found and text[max(0, found.start() - 80) : found.end() + 40]!r}")
        return run

    def test_names_in_files_are_printed_without_control_characters(self):
        valve = json.loads(small_valve().read_text())
        valve["name"], valve["provenance"] = BAD, [BAD]
        valve["chordae"][0]["id"] = BAD
        named = self.write("named.json", valve)
        wrong = self.write("wrong.json", {**valve, BAD: 1, "chordae": [{**valve["chordae"][0], BAD: 2}]})
        cut = self.write("cut.json", {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": BAD}]})
        step = self.write("step.json", {"schema": "coapt.plan/1", "steps": [{"step": BAD}]})
        for command in (("close",), ("valve", "info"), ("valve", "check"), ("diagnose",), ("open",)):
            self.check(*command, named)
            self.check(*command, wrong)
        for plan in (cut, step):
            self.check("close", named, "--plan", plan)
            self.check("evaluate", named, plan)
        self.check("compare", named, small_valve())
        self.check("study", "physiology", named)
        self.check("plan", named, "--evaluations", 6, "--plans", 1, "--region-points", 2, "-o", self.folder / "x.html")

    def test_so_are_names_of_files_and_words_of_a_command(self):
        odd = self.write(BAD + ".json", "{")
        for command in (("close",), ("diagnose",), ("plan",), ("valve", "info"), ("valve", "check"), ("prefer",)):
            self.check(*command, odd)
        self.check("close", small_valve(), "--plan", odd)
        self.check("valve", "import", "--leaflet", odd, "-o", self.folder / "valve.json")
        self.check("export", small_valve(), "-o", f"/no/{BAD}.stl")
        for words in (
            (BAD,),
            ("--" + BAD,),
            ("close", BAD),
            ("valve", "make", BAD),
            ("plan", small_valve(), "--forbid", BAD),
        ):
            self.assertNotEqual(self.check(*words).returncode, 0)
        self.check("close", "human-normal", "--server", "http://" + BAD)


if __name__ == "__main__":
    unittest.main()
