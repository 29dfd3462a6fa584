"""Plans from parts."""

import json
import unittest

import jsonschema
from coapt import (
    BadDocument,
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    DesignedRing,
    EdgeToEdge,
    LeafletPoint,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    Plan,
    QuadrangularResection,
    Ring,
    TriangularResection,
)
from coapt.step_documents import step_from_json
from programs import SOURCE, ProgramTest

SHAPE = {
    "ap_over_transverse": 0.7,
    "flattening": 0.0,
    "p3_inset": 0.05,
    "saddle": 0.1,
    "elevation": 0.0,
    "p3_elevation": 0.0,
}

SCHEMA = json.loads((SOURCE / "io/schema/plan.schema.json").read_text())
P2 = LeafletPoint("posterior", along=0.5, height=1.0)
EVERY_STEP = Plan(
    OwnRing(sizes_below=2),
    DesignedRing({**SHAPE, "name": "mine"}, size_mm=30.0),
    Ring("generic-classic", size_mm=30),
    Neochorda("PM1", P2, length_mm=20),
    ChordalLengthChange("AL1-A2-marginal-1", change_mm=-3.5),
    ChordalExcision("PM1-P2-marginal-1"),
    ChordalTransfer("PM1-A2-strut-1", LeafletPoint("anterior", 0.25, 0.75)),
    PapillaryApproximation("posteromedial", suture_length_mm=22),
    PapillaryApproximation("anterolateral", 24.5, "annulus_point", annulus_around=0.75),
    EdgeToEdge("clip", along=0.4, width_mm=6),
    TriangularResection(width_mm=8, leaflet="anterior"),
    QuadrangularResection(width_mm=12, sliding=False),
)


class Plans(ProgramTest):
    def test_every_step_is_as_the_schema_says(self):
        jsonschema.validate(EVERY_STEP.to_json(), SCHEMA)
        self.assertEqual(len({step["step"] for step in EVERY_STEP.to_json()["steps"]}), 8)

    def test_there_is_a_part_for_every_step_of_the_schema(self):
        made = {step["step"] for step in EVERY_STEP.to_json()["steps"]}
        parts = [part.get("properties", {}) for part in SCHEMA["$defs"].values()]
        known = {part["step"]["const"] for part in parts if "step" in part}
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
        for step in [{}, {"step": 7}, {"step": "clip"}, {"step": "annuloplasty"}, {"step": "leaflet_resection"}]:
            with self.assertRaisesRegex(ValueError, "no step"):
                Plan.from_json({"schema": "coapt.plan/1", "steps": [step]})

    def test_a_mistyped_step_or_field_is_told_with_the_right_one(self):
        excision, neochorda = ChordalExcision("PM1-P2-marginal-1").to_json(), Neochorda("PM1", P2, 20).to_json()
        for step, said in (
            (excision | {"step": "chordal_excission"}, 'did you mean "chordal_excision"'),
            (excision | {"cord": "PM1-P2-marginal-1"}, 'ChordalExcision has no field "cord"; did you mean "chorda"'),
            (
                neochorda | {"insertion": P2.to_json() | {"hight": 1}},
                'LeafletPoint has no field "hight"; did you mean "height"',
            ),
            ({"step": "annuloplasty", "shape": "own"}, 'OwnRing needs "sizes_below"'),
            ({"step": "annuloplasty"}, 'Ring needs "shape", needs "size_mm"'),
            (neochorda | {"insertion": 0.5}, "LeafletPoint cannot be 0.5"),
            (7, "7 is no object"),
            (None, "None is no object"),
            ({"step": ["annuloplasty"]}, '"step" is \\[.annuloplasty.\\], must be one of'),
            ({"step": "leaflet_resection", "shape": []}, '"shape" is \\[\\], must be triangular or quadrangular'),
        ):
            with self.assertRaisesRegex(BadDocument, said):
                step_from_json(step)

    def test_equal_plans_have_one_hash(self):
        for one, other in (
            (Ring("generic-flat", 32), Ring("generic-flat", 32.0)),
            (DesignedRing(SHAPE, 32), DesignedRing(dict(SHAPE), 32.0)),
        ):
            self.assertEqual(Plan(one), Plan(other))
            self.assertEqual(hash(Plan(one)), hash(Plan(other)))


if __name__ == "__main__":
    unittest.main()
