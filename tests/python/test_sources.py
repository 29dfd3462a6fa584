"""Where valves and plans come from: files, documents, names; what the service keeps."""

import json
import pathlib
import unittest

import coapt
from client_runs import VALVE, ClientTest
from coapt import Client, NamedPlan, OwnRing, Plan, Ring
from programs import SOURCE, ProgramTest, coapt as coapt_command

PLANS = SOURCE / "examples/plans"
RINGS = [Plan(Ring("generic-classic", 32.0)), Plan(OwnRing(4))]


class Files(ProgramTest):
    def plans(self, content):
        return coapt.read_plans(self.write("plans.json", content))

    def test_plans_are_read_from_every_document_that_the_command_line_reads(self):
        first, second = (plan.to_json() for plan in RINGS)
        self.assertEqual(self.plans(first), [NamedPlan("plans", RINGS[0])])
        self.assertEqual(self.plans({"kept_plan": "1", "name": "big", "plan": first}), [NamedPlan("big", RINGS[0])])
        for name in ("plans", "kept_plans"):
            self.assertEqual(
                self.plans({name: [{"name": "big", "plan": first}, {"rank": 2, "plan": second}, first]}),
                [NamedPlan("big", RINGS[0]), NamedPlan("plan 2", RINGS[1]), NamedPlan("plan 3", RINGS[0])],
            )

    def test_the_first_of_several_plans_is_the_one(self):
        self.assertEqual(Plan.read(self.write("p.json", {"plans": [RINGS[1].to_json(), RINGS[0].to_json()]})), RINGS[1])

    def test_every_example_is_a_plan(self):
        for file in sorted(PLANS.glob("*.json")):
            self.assertEqual(Plan.read(file).to_json(), json.loads(file.read_text()), file)

    def test_a_file_without_an_end_is_read_no_further_than_the_command_line_reads(self):
        for read in (coapt.read_valve, coapt.read_plans, coapt.Mesh.read):
            with self.assertRaisesRegex(coapt.BadDocument, "/dev/zero: is larger than 64 MiB"):
                read(pathlib.Path("/dev/zero"))

    def test_what_holds_no_plan_is_refused_with_its_place(self):
        for content, wrong in (
            ("{", "plans.json: is no JSON: Expecting"),
            ([], "plans.json: must be an object"),
            ({"plans": []}, "/plans: must be a list of at least one"),
            ({"plans": [RINGS[0].to_json(), {"name": "none"}]}, "/plans/1: holds no plan"),
            ({"plans": [{"plan": {"schema": "coapt.plan/1"}}]}, 'plan 1: no coapt.plan/1: "schema" and "steps"'),
        ):
            with self.assertRaisesRegex(coapt.BadDocument, wrong):
                self.plans(content)
        with self.assertRaisesRegex(coapt.BadDocument, "cannot be read"):
            coapt.read_plans(self.folder)

    def test_a_file_that_is_not_there_is_told_with_its_neighbour(self):
        with self.assertRaisesRegex(coapt.NoSuchFile, 'rnig.json: there is no such file.*; did you mean "ring.json"'):
            Plan.read(PLANS / "rnig.json")
        with self.assertRaises(FileNotFoundError):
            Plan.read("nowhere/ring.json")

    def test_nothing_is_asked_of_the_service_for_a_file_that_is_not_there(self):
        client = Client("http://127.0.0.1:1", retries=0)
        for close in (
            lambda: client.close("nowhere.json"),
            lambda: client.put_valve("nowhere.json"),
            lambda: client.close(VALVE, "nowhere.json"),
            lambda: client.evaluate(VALVE, ["nowhere.json"]),
            lambda: client.search(pathlib.Path("nowhere")),
        ):
            self.assertRaises(coapt.NoSuchFile, close)
        with self.assertRaisesRegex(coapt.BadDocument, "'ring' is no plan"):
            client.close(VALVE, "ring")


class Sources(ClientTest):
    def test_text_that_ends_in_json_is_a_file(self):
        file = self.make(VALVE)
        ring = PLANS / "ring.json"
        closure = self.client.close(VALVE, Plan.read(ring))
        for valve, plan in ((str(file), str(ring)), (file, ring), (VALVE, json.loads(ring.read_text()))):
            self.assertEqual(self.client.close(valve, plan).measure, closure.measure)

    def test_plans_of_a_file_are_scored_as_the_command_line_scores_them(self):
        file = self.write("mine.json", {"plans": [{"name": "big", "plan": RINGS[0].to_json()}, RINGS[1].to_json()]})
        printed = json.loads(coapt_command("evaluate", VALVE, file, "--region-points", 2, "--json").stdout)
        scored = self.client.evaluate(VALVE, file, region_points=2)
        self.assertEqual([plan.plan for plan in scored.plans], RINGS)
        self.assertEqual([plan.json["cost"] for plan in scored.plans], [plan["cost"] for plan in printed["plans"]])
        again = self.client.evaluate(VALVE, [str(file), NamedPlan("once more", RINGS[0])], region_points=2)
        self.assertEqual([plan.plan for plan in again.plans], [*RINGS, RINGS[0]])

    def test_a_mistyped_preset_is_told_with_the_right_one(self):
        for ask in (self.client.close, self.client.search, lambda name: self.client.keep_plan(name, RINGS[0], "ring")):
            error = self.refused(coapt.InvalidRequest, ask, "human-functionl-mr")
            self.assertIn(f'; did you mean "{VALVE}"?', str(error))
            self.assertEqual([(one.path, one.code) for one in error.problems], [("/valve", "bad_reference")])
        self.assertIn(VALVE, str(self.refused(coapt.NotFound, self.client.get_valve, "human-functionl-mr")))
        self.assertNotIn("mean", str(self.refused(coapt.InvalidRequest, self.client.close, "x")))

    def test_what_is_no_json_is_refused(self):
        valve = self.client.get_valve(VALVE)
        for wrong in (float("nan"), {1}):
            self.refused(coapt.BadDocument, self.client.close, valve | {"pressure_kpa": wrong})


class Kept(ClientTest):
    def test_stored_valves_are_listed_newest_first(self):
        self.assertEqual(list(self.client.valves()), [])
        stored = [self.client.put_valve(self.make(name)) for name in ("human-normal", "porcine-1")]
        listed = list(self.client.valves())
        self.assertEqual([(one.id, one.name) for one in listed], [(one.id, one.name) for one in stored[::-1]])
        self.assertEqual([one.name for one in listed], ["porcine-1", "human-normal"])
        self.assertEqual((listed[0].vertices, listed[0].triangles), (stored[1].vertices, stored[1].triangles))
        self.assertEqual(self.client.close(listed[0]).valve, "porcine-1")

    def test_a_plan_is_kept_found_renamed_and_removed(self):
        kept = self.client.keep_plan(VALVE, PLANS / "ring.json", "a ring")
        self.assertEqual((kept.name, kept.valve, kept.plan), ("a ring", VALVE, RINGS[0]))
        self.assertEqual(list(self.client.kept_plans()), [kept])
        self.assertEqual(list(self.client.kept_plans("human-normal")), [])
        renamed = self.client.rename_kept_plan(kept.id, "the ring")
        self.assertEqual(list(self.client.kept_plans(VALVE)), [renamed])
        self.assertEqual((renamed.name, renamed.plan), ("the ring", kept.plan))
        self.assertEqual(self.client.close(kept.valve, kept).measure, self.client.close(VALVE, RINGS[0]).measure)
        self.client.delete_kept_plan(kept.id)
        self.assertEqual(list(self.client.kept_plans()), [])
        self.refused(coapt.NotFound, self.client.rename_kept_plan, kept.id, "gone")

    def test_a_plan_for_a_file_of_a_valve_stores_the_valve(self):
        kept = self.client.keep_plan(self.make("human-normal"), RINGS[1], "own ring")
        stored = next(self.client.valves())
        self.assertEqual((kept.valve, stored.name), (stored.id, "human-normal"))
        self.assertEqual(list(self.client.kept_plans(stored)), [kept])
        self.refused(coapt.Conflict, self.client.delete_valve, stored.id)

    def test_lists_of_several_pages_are_read_to_the_end(self):
        for i in range(101):
            self.client.keep_plan(VALVE, RINGS[0], f"plan {i}")
        self.assertEqual([kept.name for kept in self.client.kept_plans()], [f"plan {i}" for i in range(100, -1, -1)])


if __name__ == "__main__":
    unittest.main()
