"""Everything public goes through pickle and deepcopy, and works in processes: forked, spawned, in pools."""

import copy
import dataclasses
import importlib.util
import multiprocessing
import os
import pickle
import subprocess
import sys
import unittest
from concurrent.futures import ProcessPoolExecutor

import coapt
import programs
from client_runs import SMALL, VALVE, EngineTest, has_engine
from coapt import OwnRing, Plan, Ring
from coapt.errors import Problem
from process_runs import HANGS_S

ENGINE = has_engine()
PROBLEMS = (Problem("out_of_range", "/plan", "is wrong"),)

# Classes, how to make one of each, and what of it must stay the same. None: not made here (below, or a type of typing).
ERRORS = {
    **{kind: (lambda kind=kind: kind("said", PROBLEMS)) for kind in (
        coapt.CoaptError, coapt.NoSuchFile, coapt.BadDocument, coapt.MissingPackage, coapt.Unreachable, coapt.NotEnded)},
    **{kind: (lambda kind=kind: kind(422, "Unprocessable content", PROBLEMS, 2.5)) for kind in (
        coapt.Refused, coapt.InvalidRequest, coapt.AccessDenied, coapt.NotFound, coapt.Conflict, coapt.Busy,
        coapt.ServiceFailed)},
    coapt.JobFailed: lambda: coapt.JobFailed("0123", PROBLEMS),
}  # fmt: skip

STEPS = (
    coapt.ChordalExcision("c1"), coapt.ChordalLengthChange("c1", 2.0), coapt.DesignedRing({"name": "mine"}, 30.0),
    coapt.ChordalTransfer("c1", coapt.LeafletPoint("anterior", 0.5)), coapt.EdgeToEdge(), coapt.LeafletPoint("anterior", 0.5),
    coapt.Neochorda("AL1", coapt.LeafletPoint("anterior", 0.5), 20.0), coapt.PapillaryApproximation("posteromedial", 24.0),
    coapt.QuadrangularResection(8.0), coapt.TriangularResection(8.0), Ring("generic-classic", 30.0), OwnRing(2),
)  # fmt: skip
ABSTRACT = {coapt.Service}
STATES = {
    coapt.Engine,
    coapt.Client,
    coapt.Job,
    coapt.Sweep,
    coapt.Searcher,
}  # connections and what goes on: each is itself


def pickled(value):
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        read = pickle.loads(pickle.dumps(value, protocol))
    return read


def leak_of(plan):
    """Of the example, in whatever process this is."""
    return coapt.preset(VALVE).close(plan).measure.leak_mm2


def leak_of_valve(valve, plan):
    return valve.close(plan).measure.leak_mm2


def search_here(job_options):
    job = coapt.preset(VALVE).search(**job_options)
    return job.result().json["before"]["leak_mm2"]


class Errors(unittest.TestCase):
    def test_every_error_is_made_again_with_all_that_it_says(self):
        kinds = {one for one in vars(coapt).values() if isinstance(one, type) and issubclass(one, BaseException)}
        self.assertEqual(kinds, set(ERRORS))
        for kind, make in ERRORS.items():
            for again in (pickled, copy.deepcopy, copy.copy):
                error, read = make(), again(make())
                self.assertEqual(read, error)
                self.assertIs(type(read), kind)
                self.assertEqual(
                    (str(read), read.args, vars(read)),
                    (str(error), error.args, vars(error)),
                )

    def test_a_client_that_was_pickled_has_no_token_in_it(self):
        client = coapt.Client("http://127.0.0.1:1", token="open-sesame")
        self.assertNotIn(b"sesame", pickle.dumps(client))
        self.assertEqual(pickled(client).url, client.url)
        self.assertEqual(copy.deepcopy(client)._transport.token, "open-sesame")


@unittest.skipUnless(ENGINE, "no engine")
class Objects(EngineTest):
    def every_object(self):
        """One of each public class, by the class."""
        engine = self.client
        valve = engine.preset(VALVE)
        closure = valve.close(Plan(OwnRing(2)))
        job = valve.search(**SMALL)
        found = job.result()
        stored = engine.put_valve(valve.to_json())
        kept = engine.keep_plan(VALVE, Plan(OwnRing(2)), "mine")
        items = engine.close_many([VALVE, "no-such-valve"], [Plan()])
        events = list(job.events())
        made = [
            engine,
            valve,
            closure,
            closure.measure,
            closure.measure.leak,
            closure.measure.coaptation,
            *items,
        ]
        made += [
            *closure.measure.leak.openings,
            *closure.measure.coaptation.sections,
            valve.open(),
            valve.picture(),
        ]
        made += [
            job,
            found,
            found.before,
            *found.plans,
            *events,
            job.progress,
            stored,
            kept,
            *engine.rings(),
        ]
        made += [plan for one in found.plans for plan in (one.plan, one.leak_mm2, one.leak_maps, one.remodelling)]
        made += [
            closure.leaflets(),
            valve.compare(closure),
            engine.map([VALVE]),
            valve.evaluate([Plan()], 2),
            *PROBLEMS,
        ]
        made += [coapt.Client("http://127.0.0.1:1")]
        made += [event.progress.best for event in events if event.progress and event.progress.best]
        space = valve.space()
        made += [space, space.evaluate(space.start), space.searcher(), coapt.Merits(), coapt.Ordered(0, 1), *STEPS]
        return {type(one): one for one in made}

    def test_every_public_object_is_pickled_copied_compared_and_printed_short(self):
        objects = self.every_object()
        classes = {one for one in map(vars(coapt).get, coapt.__all__) if isinstance(one, type)} - set(ERRORS)
        # What only studies, imports and fits leave, and what may be given for a valve: data, of whatever values.
        for kind in classes - set(objects) - ABSTRACT:
            objects[kind] = kind(*(f"{one.name} of it" for one in dataclasses.fields(kind) if one.init))
        self.assertLessEqual(classes - ABSTRACT, set(objects))
        for kind, value in objects.items():
            for again in (pickled, copy.deepcopy, copy.copy):
                with self.subTest(kind=kind.__name__, again=again.__name__):
                    self.assertIs(type(again(value)), kind)
                    if kind not in STATES:
                        self.assertEqual(again(value), value)
                        self.assertNotEqual(value, object())
            with self.subTest(kind=kind.__name__):
                self.assertTrue(repr(value).startswith(kind.__name__ + "("), repr(value))
                self.assertLess(len(repr(value)), 600, repr(value))

    def test_what_was_pickled_says_the_same(self):
        valve = self.client.preset(VALVE)
        closure = valve.close(Plan(OwnRing(2)))
        read = pickled(closure)
        self.assertEqual((read, read.json, read.measure.json), (closure, closure.json, closure.json))
        self.assertTrue((read.closed_mm == closure.closed_mm).all())
        again = pickled(valve)
        self.assertTrue((again.vertices_mm == valve.vertices_mm).all())
        self.assertEqual(again.close(Plan(OwnRing(2))).measure, closure.measure)
        self.assertEqual(again.compare(read).max_mm, valve.compare(closure).max_mm)
        job = valve.search(**SMALL)
        plan, other = job.result().plans[0], pickled(job.result()).plans[0]
        self.assertEqual(other, plan)
        self.assertIsInstance(copy.deepcopy(plan).picture(), coapt.Picture)
        with self.assertRaisesRegex(coapt.Unreachable, "another process"):
            other.picture()
        self.assertIs(copy.deepcopy(valve), valve)

    def test_threads_are_checked_alike_everywhere(self):
        valve = self.client.preset(VALVE)
        space = valve.space()
        calls = (
            lambda threads: coapt.Engine(threads=threads).end(),
            lambda threads: self.client.close_many(VALVE, threads=threads),
            lambda threads: coapt.close_many(VALVE, threads=threads),
            lambda threads: self.client.map(VALVE, threads=threads),
            lambda threads: valve.search(**SMALL, threads=threads).cancel(),
            lambda threads: space.evaluate_many([space.start], threads=threads),
        )
        for call in calls:
            for threads in (-1, 1025, 1.5, True, "2"):
                with self.assertRaises(coapt.InvalidRequest) as raised:
                    call(threads)
                self.assertEqual(
                    [problem.path for problem in raised.exception.problems],
                    ["/threads"],
                )
            call(0)
            call(2)


@unittest.skipUnless(ENGINE, "no engine")
class Processes(EngineTest):
    def setUp(self):
        super().setUp()
        # Children read this file anew, and where the programs are with it.
        for name, program in (
            ("COAPT", programs.COAPT),
            ("COAPT_SERVER", programs.SERVER),
        ):
            os.environ[name] = program
            self.addCleanup(os.environ.pop, name)

    def test_one_refused_plan_leaves_the_others_their_results(self):
        plans = [Plan(), Plan(Ring("generic-classic", size_mm=36.3)), Plan(OwnRing(2))]
        for way in ("fork", "spawn"):
            with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(way)) as pool:
                waiting = [pool.submit(leak_of, plan) for plan in plans]
                self.assertEqual(waiting[0].result(60), leak_of(plans[0]))
                refused = waiting[1].exception(60)
                self.assertIsInstance(refused, coapt.InvalidRequest)
                self.assertTrue(refused.problems[0].path.startswith("/plan/steps/0"))
                self.assertEqual(waiting[2].result(60), leak_of(plans[2]))

    @unittest.skipUnless(importlib.util.find_spec("joblib"), "needs joblib")
    def test_joblib_has_refusals_beside_results(self):
        from joblib import Parallel, delayed

        space = self.client.preset(VALVE).space()
        outside = [*space.start[:-1], 99]
        trials = Parallel(2)(delayed(space.evaluate)(x) for x in (space.start, outside, space.upper))
        self.assertEqual([trial.reason == "" for trial in trials], [True, False, True])
        self.assertEqual(trials[2].value, space(space.upper))
        with self.assertRaises(coapt.InvalidRequest):
            Parallel(2)(delayed(leak_of)(plan) for plan in (Plan(), Plan(Ring("generic-classic", size_mm=36.3))))

    @unittest.skipUnless(importlib.util.find_spec("dask"), "needs dask")
    def test_dask_has_refusals_beside_results(self):
        import dask

        def computed(*tasks):
            return dask.compute(*tasks, scheduler="processes", num_workers=2)

        valve, leak = self.client.preset(VALVE), dask.delayed(leak_of)
        plans = (Plan(), Plan(OwnRing(2)))
        self.assertEqual(computed(*map(leak, plans)), tuple(map(leak_of, plans)))
        (closure,) = computed(dask.delayed(coapt.LocalValve.close)(valve))
        self.assertEqual(closure.strain.tolist(), valve.close().strain.tolist())
        with self.assertRaises(coapt.InvalidRequest):
            computed(leak(Plan()), leak(Plan(Ring("generic-classic", size_mm=36.3))))

    def test_valves_and_closures_travel(self):
        valve = self.client.preset(VALVE)
        wider = valve.with_arrays(annulus_mm=valve.annulus_mm * 1.02)
        with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
            self.assertEqual(
                pool.submit(leak_of_valve, wider, None).result(60),
                wider.close().measure.leak_mm2,
            )
            sent = pool.submit(coapt.LocalValve.close, valve).result(60)
        self.assertEqual(sent.measure, valve.close().measure)
        self.assertEqual(sent.strain.tolist(), valve.close().strain.tolist())
        self.assertEqual(sent.leaflets(), valve.close().leaflets())

    def test_a_forked_child_searches_and_evaluates_after_its_parent_did(self):
        code = (
            "import coapt, os, sys; from client_runs import SMALL\n"
            "valve = coapt.preset('human-functional-mr')\n"
            "plans = [coapt.Plan(coapt.OwnRing(2))]\n"
            "def asked():\n"
            "    score = valve.evaluate(plans, region_points=4).plans[0].cost\n"
            "    return valve.search(**SMALL).result().json['before']['leak_mm2'], score\n"
            "stored = valve.with_arrays(annulus_mm=1.01 * valve.annulus_mm)\n"
            "stored.search(**SMALL).result()\n"
            "here = asked()\n"
            "child = os.fork()\n"
            "if child == 0:\n"
            "    there = asked()\n"
            "    stored.search(**SMALL).result()\n"
            "    sys.exit(0 if there == here else 1)\n"
            "sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) or (asked() != here))\n"
        )
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=HANGS_S,
                             env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})  # fmt: skip
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_a_database_stays_with_the_process_that_opened_it(self):
        code = (
            "import coapt, os, sys\n"
            "engine = coapt.Engine(sys.argv[1])\n"
            "if os.fork() == 0:\n"
            "    try:\n"
            "        engine.presets()\n"
            "    except coapt.Unreachable as error:\n"
            "        os._exit(7 if 'forked' in str(error) else 1)\n"
            "sys.exit(os.waitstatus_to_exitcode(os.wait()[1]))\n"
        )
        run = subprocess.run([sys.executable, "-c", code, self.folder / "x.sqlite"], capture_output=True, text=True,
                             timeout=HANGS_S, env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})  # fmt: skip
        self.assertEqual((run.returncode, run.stderr), (7, ""))


if __name__ == "__main__":
    unittest.main()
