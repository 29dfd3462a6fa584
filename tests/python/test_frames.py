"""Results as tables of pandas."""

import importlib.util
import json
import sys
import unittest
from unittest import mock

import coapt
from client_runs import SMALL, ClientTest
from coapt import LeafletPoint, Neochorda, OwnRing, PapillaryApproximation, Plan, Ring, frames
from programs import SOURCE, small_valve

if importlib.util.find_spec("pandas"):
    import pandas

RING = SOURCE / "examples/plans/ring.json"
UNITS = ("_mm", "_mm2", "_n", "_deg")
COUNTS = {"rank", "nodes", "failed_nodes", "valve_number", "plan_number", "number"}
OF_STEPS = ("_along", "_height", "_sizes_below", "_around", "_rows", "_percent")  # their own units, as in coapt.plan/1
SHARES = {"along", "strain_circumferential_max", "strain_radial_max"}


@unittest.skipUnless(importlib.util.find_spec("pandas"), "pandas is not installed")
class Frames(ClientTest):
    def assert_units(self, frame):
        """Every number says what it is in; booleans are none."""
        for name, kind in frame.dtypes.items():
            if kind.kind in "if":
                self.assertTrue(name.endswith(UNITS + OF_STEPS) or name in COUNTS | SHARES, name)

    def test_ranked_plans_are_a_row_each(self):
        result = self.client.evaluate(small_valve(), [RING, Plan()], region_points=2, evidence=True)
        frame = result.to_frame()
        self.assert_units(frame)
        self.assertEqual(list(frame["rank"]), [plan.rank for plan in result.plans])
        self.assertEqual(list(frame.cost_mm2), [plan.cost for plan in result.plans])
        self.assertEqual(list(frame.ranked_cost_mm2), [plan.json["ranked_cost"] for plan in result.plans])
        self.assertEqual(list(frame.leak_mm2), [plan.leak_mm2.nominal for plan in result.plans])
        self.assertEqual(list(frame.p95_leak_mm2), [plan.leak_mm2.p95 for plan in result.plans])
        self.assertEqual(list(frame.description), ["; ".join(plan.description) for plan in result.plans])
        self.assertEqual(list(frame.closes_robustly), [plan.closes_robustly for plan in result.plans])
        self.assertEqual(Plan.from_json(json.loads(frame.plan[0])), result.plans[0].plan)

    def test_a_table_of_no_plans_has_the_same_columns(self):
        some = self.client.evaluate(small_valve(), [RING])
        none = coapt.Evaluations(some.before, (), 0, 0.0, {})
        columns = list(some.to_frame().columns)
        self.assertEqual(
            columns, [*none.to_frame().columns, *(one for one in columns if one.startswith("annuloplasty_"))]
        )

    def test_numbers_and_words_of_steps_are_columns(self):
        plans = [
            Plan(OwnRing(2)),
            Plan(
                Ring("generic-classic", 30),
                PapillaryApproximation("posteromedial", 24),
                *(Neochorda("AL1", LeafletPoint("posterior", along), 20) for along in (0.4, 0.6)),
            ),
        ]
        frame = self.client.map([small_valve()], [*plans, Plan()]).to_frame()
        self.assert_units(frame)
        told = frame[[name for name in frame.columns if name.startswith(("annuloplasty", "papillary", "neochorda"))]]
        self.assertEqual(list(told.iloc[1].dropna().drop(["annuloplasty_shape"]).index)[:3], [
            "annuloplasty_size_mm", "papillary_approximation_posteromedial_anchor",
            "papillary_approximation_posteromedial_suture_length_mm",
        ])  # fmt: skip
        self.assertEqual(list(told.annuloplasty_sizes_below.isna()), [False, True, True])
        self.assertEqual((told.neochorda_2_length_mm[1], told.neochorda_2_along[1]), (20, 0.6))
        self.assertTrue(told.iloc[2].isna().all())

    def test_what_is_not_known_is_a_number_that_is_none(self):
        plan = self.client.evaluate(small_valve(), [RING]).plans[0]
        self.assertIsNone(plan.leak_mm2.sd)
        frame = coapt.Evaluations(None, (plan,), 1, 0.0, {}).to_frame()
        self.assertEqual((frame.sd_leak_mm2.dtype.kind, frame.sd_leak_mm2.isna()[0]), ("f", True))

    def test_a_leak_map_is_a_row_a_node(self):
        plan = self.client.evaluate(small_valve(), [SOURCE / "examples/plans/mixed.json"], 17, evidence=True).plans[0]
        both = plan.leak_maps.of("both")
        self.assertEqual([one.muscle for one in plan.leak_maps.maps], ["both", "posteromedial"])
        frame = plan.leak_maps.to_frame()
        self.assert_units(frame)
        self.assertEqual(len(frame), 2 * len(both.suture_length_mm) * len(both.outwards_deg))
        planned = frame.query("muscle == 'both' and suture_length_mm == 0 and outwards_deg == 0")
        middle = both.leak_mm2[both.suture_length_mm.index(0)][both.outwards_deg.index(0)]
        self.assertEqual(list(planned.leak_mm2), [middle])
        first = frame.iloc[0]
        self.assertEqual((first.suture_length_mm, first.outwards_deg), (both.suture_length_mm[0], both.outwards_deg[0]))
        with self.assertRaisesRegex(KeyError, "no map of 'anterolateral'"):
            plan.leak_maps.of("anterolateral")

    def test_remodelling_begins_with_the_plan_as_planned(self):
        plan = self.client.evaluate(small_valve(), [RING], evidence=True).plans[0]
        frame = plan.remodelling.to_frame()
        self.assertEqual(len(set(frame[frame.displacement_mm == 0].leak_mm2)), 1)
        self.assertEqual(set(frame.displacement_mm), set(range(7)))
        self.assertEqual(
            list(self.client.evaluate(small_valve(), [RING]).plans[0].remodelling.to_frame().direction), []
        )

    def test_sections_run_from_commissure_to_commissure(self):
        measure = self.client.close(small_valve()).measure
        frame = measure.coaptation.to_frame()
        self.assert_units(frame)
        self.assertEqual(len(frame), 9)
        self.assertTrue(frame.along.is_monotonic_increasing)
        self.assertEqual(frame.height_mm.min(), measure.coaptation_height_min_mm)
        self.assertEqual(frame.distance_mm.max(), measure.json["coaptation"]["distance_max_mm"])

    def test_every_plan_that_a_search_tried_is_a_row(self):
        job = self.client.search(small_valve(), **SMALL)
        best = job.result().plans[0]
        frame = job.evaluations().to_frame()
        self.assert_units(frame)
        row = frame[frame["rank"] == 1].iloc[0]
        self.assertEqual(Plan.from_json(json.loads(row.plan)), best.plan)
        ranked = job.result().to_frame()
        shared = set(ranked.columns) & set(frame.columns)
        self.assertLessEqual({"cost_mm2", "leak_mm2", "tension_max_n", "nodes"}, shared)
        for name in shared - {"leak_mm2"}:  # which is estimated of all that were tried
            if frame[name].dtype.kind in "if":
                self.assertAlmostEqual(row[name], ranked[name][0], delta=1e-5 * abs(ranked[name][0]), msg=name)
        job.evaluations().write(self.folder / "tried.csv")
        self.assertEqual((self.folder / "tried.csv").read_text(), job.evaluations().csv)

    def test_a_study_has_its_findings_and_tables(self):
        job = self.client.study(small_valve("porcine-3"), "annulus")
        result = job.result()
        self.assertEqual(int(result.to_frame().agrees.sum()), result.json["agree"])
        frame = job.table("annulus.csv").to_frame()
        self.assertEqual(list(frame.columns), ["annular_height_percent", "ap_dilation_percent", "orifice_mm2"])
        self.refused(coapt.NotFound, job.evaluations)

    def test_a_sweep_has_its_errors_beside_its_figures(self):
        frame = self.client.map([small_valve(), "nowhere.json"], [RING, Plan(Ring("generic-classic", 31))]).to_frame()
        self.assert_units(frame)
        self.assertEqual(list(frame.trusted), [True, False, False, False])
        self.assertEqual(frame.leak_mm2[0], self.client.close(small_valve(), RING).measure.leak_mm2)
        self.assertEqual(list(frame.error == ""), list(frame.trusted))
        self.assertEqual(list(frame.leak_mm2.isna()), [False, True, True, True])
        self.assertEqual(frame.leak_error_mm2[0], self.client.close(small_valve(), RING).measure.leak.error_mm2)
        known = frame[frame.trusted].drop(columns=[one for one in frame if one.startswith("annuloplasty_")])
        self.assertEqual(list(known.columns[known.isna().any()]), [])


@unittest.skipUnless(importlib.util.find_spec("pandas"), "pandas is not installed")
class Strangers(unittest.TestCase):
    def test_no_table_moves_the_terminal(self):
        bad = "\x1b[2J\x07\x9b31m\u202e"
        table = coapt.Table(f"name{bad},leak_mm2\r\na{bad},1.5\r\n").to_frame()
        self.assertEqual(table.leak_mm2.tolist(), [1.5])
        steps = frames.step_columns({"steps": [{"step": "annuloplasty", f"shape{bad}": f"own{bad}", "size_mm": 30}]})
        self.assertEqual(steps["annuloplasty_size_mm"], 30)
        finding = coapt.Remodelling((0, 1), {bad: (0.4, None)}).to_frame()
        named = frames.table([coapt.Progress(bad, 1, 2, None, None, 3.0)], {"stage": "stage"})
        for shown in (table, finding, named, pandas.DataFrame([steps])):
            self.assertNotRegex(shown.to_string(), "[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")


class WithoutPandas(unittest.TestCase):
    def test_the_package_that_is_missing_is_named(self):
        with mock.patch.dict(sys.modules, {"pandas": None}):
            with self.assertRaisesRegex(coapt.MissingPackage, "pip install pandas"):
                coapt.Table("a,b\n1,2\n").to_frame()


if __name__ == "__main__":
    unittest.main()
