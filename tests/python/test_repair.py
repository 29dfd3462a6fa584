"""Plans from parts."""

import json
import unittest

import jsonschema
from coapt import (
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    LeafletPoint,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    Plan,
    Ring,
)
from programs import SOURCE, ProgramTest

SCHEMA = json.loads((SOURCE / "io/schema/plan.schema.json").read_text())
P2 = LeafletPoint("posterior", along=0.5, height=1.0)
EVERY_STEP = Plan(
    OwnRing(sizes_below=2),
    Ring("generic-classic", size_mm=30),
    Neochorda("PM1", P2, length_mm=20),
    ChordalLengthChange("AL1-A2-marginal-1", change_mm=-3.5),
    ChordalExcision("PM1-P2-marginal-1"),
    ChordalTransfer("PM1-A2-strut-1", LeafletPoint("anterior", 0.25, 0.75)),
    PapillaryApproximation("posteromedial", suture_length_mm=22),
    PapillaryApproximation("anterolateral", 24.5, "annulus_point", annulus_around=0.75),
)


class Plans(ProgramTest):
    def test_every_step_is_as_the_schema_says(self):
        jsonschema.validate(EVERY_STEP.to_json(), SCHEMA)
        self.assertEqual(len({step["step"] for step in EVERY_STEP.to_json()["steps"]}), 6)

    def test_there_is_a_part_for_every_step_of_the_schema(self):
        made = {step["step"] for step in EVERY_STEP.to_json()["steps"]}
        known = {
            part["properties"]["step"]["const"] for part in SCHEMA["$defs"].values() if "step" in part["properties"]
        }
        self.assertEqual(made, known)

    def test_a_plan_reads_back_as_it_was_written(self):
        EVERY_STEP.write(self.folder / "plan.json")
        self.assertEqual(Plan.read(self.folder / "plan.json"), EVERY_STEP)
        self.assertEqual(eval(repr(EVERY_STEP)), EVERY_STEP)

    def test_a_step_more_leaves_the_plan_as_it_was(self):
        nothing = Plan()
        self.assertEqual(nothing.with_step(OwnRing(1)), Plan(OwnRing(1)))
        self.assertEqual(nothing.to_json(), {"schema": "coapt.plan/1", "steps": []})

    def test_what_is_no_plan_is_refused(self):
        for wrong in [{}, {"schema": "coapt.plan/1"}, {"schema": "coapt.plan/2", "steps": []}]:
            with self.assertRaisesRegex(ValueError, "schema"):
                Plan.from_json(wrong)
        for step in [{}, {"step": "clip"}, {"step": "annuloplasty"}, {"step": "neochorda", "head": "PM1"}]:
            with self.assertRaisesRegex(ValueError, "no step"):
                Plan.from_json({"schema": "coapt.plan/1", "steps": [step]})


if __name__ == "__main__":
    unittest.main()
