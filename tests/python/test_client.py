"""What the service answers at once: valves, closures, evaluations; and what it refuses."""

import functools
import inspect
import json
import unittest

import coapt
from client_runs import VALVE, ClientTest, both
from coapt import Client, OwnRing, PapillaryApproximation, Plan, Ring
from plan_runs import BARE
from programs import SOURCE, coapt as coapt_command, small_valve


@both
class Valves(ClientTest):
    def test_presets_and_rings_are_listed(self):
        self.assertIn(VALVE, self.client.presets())
        self.assertEqual({ring.name: ring.ap_over_transverse for ring in self.client.rings()}["generic-classic"], 0.75)
        self.assertEqual(self.client.version(), coapt.__version__)

    def test_a_valve_is_stored_read_and_removed(self):
        file = self.make("human-normal")
        stored = self.client.put_valve(file)
        self.assertEqual(self.client.put_valve(json.loads(file.read_text())), stored)
        valve = self.client.get_valve(stored.id)
        self.assertEqual((len(valve["vertices_mm"]), len(valve["faces"])), (stored.vertices, stored.triangles))
        self.client.delete_valve(stored.id)
        self.assertEqual(self.refused(coapt.NotFound, self.client.get_valve, stored.id).status, 404)

    def test_every_problem_of_a_valve_is_told_with_its_place(self):
        self.assertEqual(self.client.validate_valve(self.client.get_valve("porcine-1")), ())
        wrong = self.client.get_valve("porcine-1") | {"pressure_kpa": -1, "faces": "none"}
        self.assertEqual(
            {problem.path for problem in self.client.validate_valve(wrong)} & {"/pressure_kpa", "/faces"},
            {"/pressure_kpa", "/faces"},
        )
        error = self.refused(coapt.InvalidRequest, self.client.put_valve, wrong)
        self.assertEqual(error.status, 422)
        self.assertIn("/pressure_kpa: ", str(error))

    def test_a_valve_that_jobs_refer_to_stays(self):
        job = self.client.search(VALVE, evaluations=6, plans=1, region_points=2, evidence=False, **BARE).wait()
        self.assertEqual(self.refused(coapt.Conflict, self.client.delete_valve, job.json["valve"]).status, 409)
        job.delete()
        self.client.delete_valve(job.json["valve"])


@both
class Closures(ClientTest):
    def test_a_closure_is_the_one_of_the_command_line(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        plan.write(self.folder / "plan.json")
        printed = json.loads(coapt_command("close", VALVE, "--plan", self.folder / "plan.json", "--json").stdout)
        closure = self.client.close(VALVE, plan)
        self.assertEqual(closure.json | {"seconds": 0}, printed | {"seconds": 0})
        self.assertEqual(closure.measure.leak_mm2, printed["leak_mm2"])
        leak = closure.measure.leak
        self.assertEqual((leak.area_mm2, leak.error_mm2), (printed["leak"]["area_mm2"], printed["leak"]["error_mm2"]))
        self.assertEqual(
            [one.width_mm for one in leak.openings], [one["width_mm"] for one in printed["leak"]["openings"]]
        )
        self.assertTrue(leak.between_mm2[0] <= leak.area_mm2 <= leak.between_mm2[1])
        self.assertTrue(closure.trusted)
        self.assertEqual(self.client.close(VALVE, plan.to_json()).measure, closure.measure)

    def test_pressure_and_tissue_take_the_place_of_the_valves_own(self):
        options = ("--pressure", 60, "--radial-extension", 0.08, "--json")
        printed = json.loads(coapt_command("close", VALVE, *options).stdout)
        closure = self.client.close(VALVE, pressure_mmhg=60, tissue={"radial_extension": 0.08})
        self.assertEqual(closure.json | {"seconds": 0}, printed | {"seconds": 0})
        wrong = {"thickness_mm": 99, "stiffness": 1}
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.client.close, VALVE, tissue=wrong),
            [("/material/thickness_mm", "out_of_range"), ("/material/stiffness", "unknown_field")],
        )

    def test_a_closure_has_its_leaflets(self):
        leaflets, valve = self.client.close(VALVE).leaflets(), self.client.get_valve(VALVE)
        self.assertEqual([list(face) for face in leaflets.faces], valve["faces"])
        self.assertEqual(len(leaflets.vertices_mm), len(valve["vertices_mm"]))

    def test_what_a_closure_bears_is_that_of_the_scene(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        closure, scene = self.client.close(VALVE, plan), self.client.scene(VALVE, plan)
        self.assertEqual(list(closure.segments), scene["segments"])
        self.assertEqual(closure.chordae, tuple(chorda["id"] for chorda in scene["chordae"]))
        for k, way in enumerate(("circumferential", "radial")):
            self.assertLess(abs(closure.strain[:, k] - scene["strain"][way]).max(), 6e-5)
        lines = [one for chorda in scene["chordae"] for one in chorda["segments"]]
        self.assertEqual(closure.line_mm.shape, (len(lines), 2, 3))
        self.assertLess(abs(closure.line_mm[:, 1] - [one["end_mm"] for one in lines]).max(), 6e-4)
        self.assertAlmostEqual(closure.line_tension_n.max(), closure.measure.tension_max_n, places=3)
        self.assertAlmostEqual(closure.tension_n.sum(), closure.measure.tension_sum_n, places=2)
        self.assertLessEqual({"strain_radial", "segment"}, set(closure.leaflets().cell_data))
        closure.save(self.folder / "closed.stl")
        self.assertEqual((self.folder / "closed.stl").read_bytes(), self.client.export(VALVE, "stl", plan))

    def test_options_are_those_of_the_command_line(self):
        valve = small_valve()
        for options, flags in (
            ({"accuracy_mm2": 20}, ("--accuracy", 20)),
            ({"membrane": "springs"}, ("--membrane", "springs")),
            ({"certainty": "sure"}, ("--certainty", "sure")),
        ):
            printed = json.loads(coapt_command("close", valve, *flags, "--json").stdout)
            closure = self.client.close(valve, **options)
            self.assertEqual(closure.measure.leak_mm2, printed["leak_mm2"])
            self.assertEqual(closure.json["steps"], printed["steps"])
        refused = self.refused(coapt.InvalidRequest, self.client.close, valve, accuracy_mm2=1, certainty="sure")
        self.assertEqual([problem.path for problem in refused.problems], ["/certainty"])

    def test_an_opening_is_the_one_of_the_command_line(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        plan.write(self.folder / "plan.json")
        arguments = ("--plan", self.folder / "plan.json", "--flow", 200, "--json")
        printed = json.loads(coapt_command("open", VALVE, *arguments).stdout)
        opening = self.client.open(VALVE, plan, flow_ml_s=200, frames=2)
        told = {key: value for key, value in opening.json.items() if key != "scene"}
        self.assertEqual(told | {"seconds": 0}, printed | {"seconds": 0})
        self.assertEqual(opening.gradient_mmhg, printed["gradient_mmhg"])
        self.assertEqual((opening.leak.area_mm2, opening.leak.error_mm2), (opening.opening_area_mm2, None))
        self.assertTrue(opening.trusted)
        self.assertEqual(opening.scene["motion_mm"][-1][: len(opening.scene["open_mm"])], opening.scene["open_mm"])
        self.assertIn(f"{0.01 * printed['opening_area_mm2']:.1f} cm²", opening._repr_html_())
        refused = self.refused(coapt.InvalidRequest, self.client.open, VALVE, exercise=9)
        self.assertEqual([problem.path for problem in refused.problems], ["/exercise"])

    def test_a_comparison_with_hearts_is_the_one_of_the_command_line(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        plan.write(self.folder / "plan.json")
        valve = small_valve()
        arguments = ("--plan", self.folder / "plan.json", "--kind", "healthy", "--json")
        printed = json.loads(coapt_command("study", "physiology", valve, *arguments).stdout)
        self.assertEqual(self.client.physiology(valve, plan, kind="healthy"), printed)
        call = functools.partial(self.client.physiology, valve, kind="sick", species="feline")
        refused = self.refused(coapt.InvalidRequest, call)
        self.assertEqual([problem.path for problem in refused.problems], ["/kind", "/species"])

    def test_files_for_other_programs_are_those_of_the_command_line(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        plan.write(self.folder / "plan.json")
        file = self.folder / "valve.stl"
        coapt_command("export", VALVE, "--plan", self.folder / "plan.json", "-o", file)
        self.assertEqual(self.client.export(VALVE, "stl", plan), file.read_bytes())
        self.assertNotEqual(self.client.export(VALVE, "stl", plan, open=True), file.read_bytes())

    def test_a_picture_is_the_one_of_the_command_line(self):
        plan = Plan(Ring("generic-classic", size_mm=30))
        plan.write(self.folder / "plan.json")
        valve = small_valve()
        coapt_command("close", valve, "--plan", self.folder / "plan.json", "--render", self.folder / "closed.png")
        picture = self.client.picture(valve, plan)
        self.assertEqual(picture._repr_png_(), (self.folder / "closed.png").read_bytes())
        self.assertNotEqual(self.client.picture(valve), picture)

    def test_a_scene_has_the_points_and_the_way_there(self):
        scene = self.client.scene(VALVE, frames=3)
        self.assertEqual((scene["schema"], scene["closure"]["status"]), ("coapt.scene/2", "converged"))
        self.assertLessEqual(len(scene["motion_mm"]), 3)
        self.assertEqual(scene["motion_mm"][-1][: len(scene["closed_mm"])], scene["closed_mm"])
        self.assertEqual(self.client.scene(VALVE)["motion_mm"], [])

    def test_own_plans_have_a_report(self):
        valve = small_valve()
        page = self.client.report(valve, [Plan(Ring("generic-classic", size_mm=30))], region_points=2)
        self.assertIn("How the plans were scored", page)
        self.assertNotIn("With further remodelling", page)
        self.assertIn("With further remodelling", self.client.report(valve, [Plan(OwnRing(1))], evidence=True))
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.client.report, valve, 11 * [Plan(OwnRing(1))]),
            [("/plans", "out_of_range")],
        )

    def test_an_impossible_plan_is_refused_with_the_place_of_the_step(self):
        plan = Plan(OwnRing(1), PapillaryApproximation("posteromedial", suture_length_mm=99))
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.client.close, VALVE, plan),
            [("/plan/steps/1/suture_length_mm", "impossible_step")],
        )

    def test_own_plans_are_scored_in_the_order_given(self):
        plans = [Plan(), Plan(Ring("generic-classic", 28)), Plan(OwnRing(1))]
        scored = self.client.evaluate(VALVE, plans, region_points=2)
        self.assertEqual([plan.plan for plan in scored.plans], plans)
        self.assertEqual(sorted(plan.rank for plan in scored.plans), [1, 2, 3])
        self.assertEqual(scored.plans[0].measure, scored.before.measure)
        self.assertEqual(self.client.evaluate(VALVE, scored.plans[1:2]).plans[0].plan, plans[1])
        with self.assertRaisesRegex(coapt.CoaptError, "search"):
            scored.plans[0].picture()


class Limits(ClientTest):
    def test_a_service_scores_so_many_plans_at_once(self):
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.client.evaluate, VALVE, [Plan()] * 2, 1000),
            [("/plans", "out_of_range")],
        )


class Options(unittest.TestCase):
    def options(self, function):
        return {
            name
            for name, parameter in inspect.signature(function).parameters.items()
            if parameter.kind == inspect.Parameter.KEYWORD_ONLY
        } - {"idempotency_key"}

    def test_a_search_has_every_option_of_the_schema(self):
        schema = json.loads((SOURCE / "io/schema/search.schema.json").read_text())
        self.assertEqual(self.options(Client.search), set(schema["properties"]) | {"fixed", "forbidden"})

    def test_a_study_has_every_option_of_the_document(self):
        schemas = json.loads((SOURCE / "server/openapi.json").read_text())["components"]["schemas"]
        fields = {name for kind in ("GeometryStudy", "AnchorStudy") for name in schemas[kind]["properties"]}
        self.assertEqual(self.options(Client.study), fields - {"name"})


if __name__ == "__main__":
    unittest.main()
