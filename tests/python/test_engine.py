"""The engine in this process: arrays, errors, threads, Ctrl-C; what it answers is tested beside the client (client_runs.both)."""

import importlib.util
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import types
import unittest

import coapt
from client_runs import ENDLESS, SMALL, VALVE, EngineTest, has_engine
from coapt import OwnRing, Plan
from programs import OK, coapt as coapt_command, small_valve

ENGINE = has_engine()
if ENGINE:
    import numpy


@unittest.skipUnless(ENGINE, "no engine")
class Arrays(EngineTest):
    def setUp(self):
        super().setUp()
        self.valve = self.client.preset("porcine-1")

    def test_a_valve_is_arrays_that_are_not_copied_and_cannot_be_written_to(self):
        document = self.valve.to_json()
        for name, array in (("vertices_mm", self.valve.vertices_mm), ("faces", self.valve.faces)):
            self.assertEqual(array.tolist(), document[name])
            self.assertTrue(numpy.shares_memory(array, getattr(self.valve, name)))
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_a_closed_shape_outlives_its_closure(self):
        closure = self.valve.close()
        shape = closure.closed_mm
        self.assertTrue(numpy.shares_memory(shape, closure.leaflets().vertices_mm))
        self.assertEqual((shape.dtype, shape.shape), (numpy.float64, self.valve.vertices_mm.shape))
        kept = shape.copy()
        del closure
        self.assertTrue((shape == kept).all())
        with self.assertRaises(ValueError):
            shape[0, 0] = 1.0

    def test_a_closed_shape_has_the_numbers_of_the_command_line(self):
        file = self.folder / "closed.vtk"
        coapt_command("close", "porcine-1", "--closed", file)
        compared = self.client.compare(self.valve.close(), file)
        self.assertTrue(compared.node_to_node)
        self.assertLess(compared.max_mm, 1e-4)
        self.assertEqual(len(compared.signed_mm), len(compared.moved_mm))
        self.assertEqual(self.client.compare(self.valve.close(), self.valve.close()).max_mm, 0.0)

    def test_a_valve_of_other_arrays_is_another_valve(self):
        wider = self.valve.with_arrays(annulus_mm=1.05 * self.valve.annulus_mm)
        self.assertEqual(wider.faces.tolist(), self.valve.faces.tolist())
        self.assertGreater(wider.close().measure.annulus_ap_mm, 1.02 * self.valve.close().measure.annulus_ap_mm)
        self.assertEqual(self.client.close(wider.to_json()).measure, wider.close().measure)
        self.assertEqual(self.client.open(wider).name, wider.name)

    def refused_arrays(self, **arrays):
        error = self.refused(coapt.BadDocument, self.valve.with_arrays, **arrays)
        return [(problem.path, problem.code) for problem in error.problems], str(error)

    def test_arrays_and_lists_of_any_numbers_are_taken(self):
        points, faces = self.valve.vertices_mm, self.valve.faces
        for given in (points.tolist(), points.astype(object).astype(float).copy(order="F"), points[:, ::-1][:, ::-1]):
            self.assertEqual(self.valve.with_arrays(vertices_mm=given), self.valve)
        coarse = points.astype(numpy.float32)
        self.assertTrue((self.valve.with_arrays(vertices_mm=coarse).vertices_mm == coarse.astype(float)).all())
        for kind in ("int64", "uint16", "int32", ">i4"):
            self.assertEqual(self.valve.with_arrays(faces=faces.astype(kind)), self.valve)
        self.assertEqual(self.valve.with_arrays(faces=faces.tolist()), self.valve)

    def test_arrays_of_another_kind_or_shape_are_refused(self):
        points = numpy.array(self.valve.vertices_mm)
        for given, named in ((points.astype(complex), "is an array of complex128"), (points > 0, "is an array of bool"),
                             ("points", "is a str"), ([[1, 2, 3], [1, 2]], "is a list"), ([["a", "b", "c"]], "is a list")):  # fmt: skip
            problems, text = self.refused_arrays(vertices_mm=given)
            self.assertEqual(problems, [("/vertices_mm", "wrong_type")])
            self.assertIn(named + ", must be an array of numbers, shape (n, 3)", text)
        problems, text = self.refused_arrays(vertices_mm=points[:, :2])
        self.assertEqual(problems, [("/vertices_mm", "wrong_type")])
        self.assertIn(f"({len(points)}, 2), must have (n, 3)", text)
        self.assertEqual(self.refused_arrays(vertices_mm=numpy.float64(1))[0], [("/vertices_mm", "wrong_type")])
        self.assertEqual(self.refused_arrays(faces=self.valve.faces.astype(float))[0], [("/faces", "wrong_type")])
        far = self.valve.faces.astype(numpy.int64)
        far[4, 1] = 2**32
        self.assertEqual(self.refused_arrays(faces=far)[0], [("/faces/4", "out_of_range")])
        many = numpy.broadcast_to(points[0], (10**8, 3))  # a row's memory
        problems, text = self.refused_arrays(vertices_mm=many)
        self.assertEqual(problems, [("/vertices_mm", "out_of_range")])
        self.assertIn("100000000 rows, must have at most 3000000", text)
        points[7, 1] = numpy.nan
        self.assertEqual(self.refused_arrays(vertices_mm=points)[0], [("/vertices_mm/7", "out_of_range")])
        paths = [path for path, _ in self.refused_arrays(faces=self.valve.faces + numpy.int32(1000))[0]]
        self.assertEqual(paths[0], "/faces/0/0")

    def test_what_is_replaced_is_another_valve(self):
        valve = self.valve
        self.assertEqual(valve.replace(), valve)
        raised = valve.replace(pressure_mmhg=150, tissue={"radial_extension": 0.08})
        self.assertEqual(
            raised.close().measure, valve.close(pressure_mmhg=150, tissue={"radial_extension": 0.08}).measure
        )
        self.assertEqual((valve.replace(name="other").name, valve.name), ("other", "porcine-1"))
        side = "anterolateral"
        moved = valve.replace(papillary_mm={side: valve.papillary_mm[side] + numpy.array([0, 0, -3])})
        numpy.testing.assert_allclose(moved.papillary_mm[side] - valve.papillary_mm[side], [0, 0, -3], atol=1e-12)
        self.assertTrue((moved.papillary_mm["posteromedial"] == valve.papillary_mm["posteromedial"]).all())
        fewer = valve.replace(chordae=valve.chordae[1:])
        self.assertEqual(len(fewer.close().chordae), len(valve.chordae) - 1)
        self.assertEqual(
            self.problems(coapt.InvalidRequest, valve.replace, pressure_mmhg=1e6),
            [("/material/pressure_mmhg", "out_of_range")],
        )
        self.assertIn(
            "anterolateral, posteromedial",
            str(self.refused(coapt.BadDocument, valve.replace, papillary_mm={"left": [0, 0, 0]})),
        )
        self.refused(coapt.BadDocument, valve.replace, chordae=[{"id": "x"}])

    def test_what_was_saved_is_read_by_its_ending(self):
        closure, file = self.valve.close(Plan(OwnRing(1))), self.folder / "closed.vtk"
        closure.save(file)
        self.assertEqual(file.read_bytes(), self.client.export("porcine-1", "vtk", Plan(OwnRing(1))))
        numpy.testing.assert_allclose(coapt.Mesh.read(file).vertices_mm[:5], closure.closed_mm[:5], atol=1e-3)
        for ending in ("ply", "obj", "stl", "vtk"):
            file = self.folder / f"mesh.{ending}"
            closure.leaflets().save(file)
            self.assertEqual(len(coapt.Mesh.read(file).faces), len(self.valve.faces))
        self.valve.save(self.folder / "valve.json")
        self.assertEqual(coapt.read_valve(self.folder / "valve.json"), self.valve)
        closure.save(self.folder / "closed.json")
        self.assertEqual(json.loads((self.folder / "closed.json").read_text()), closure.json)
        self.assertIn("import_valve()", str(self.refused(coapt.BadDocument, coapt.read_valve, file)))
        self.assertIn("must end in one of glb", str(self.refused(coapt.BadDocument, closure.save, "x.nothing")))
        self.refused(coapt.BadDocument, closure.leaflets().save, "x.nothing")
        self.refused(coapt.BadDocument, coapt.Mesh.read, self.folder / "closed.json")
        self.refused(coapt.NoSuchFile, coapt.Mesh.read, self.folder / "none.ply")

    def test_a_mesh_of_a_closure_that_is_not_to_be_trusted_says_so(self):
        document = json.loads(small_valve().read_text())
        document["tissue"]["thickness_mm"] = 0.1  # its leaflets pass through each other
        valve = coapt.read_valve(self.write("thin.json", document))
        closure = valve.close()
        self.assertFalse(closure.trusted)
        doubt = b"UNRELIABLE: leaflets cross"
        exported = coapt.Mesh.from_ply(self.client.export(valve, "ply"))
        for mesh in (closure.leaflets(), pickle.loads(pickle.dumps(closure)).leaflets(), exported):
            for ending in ("ply", "obj", "stl", "vtk"):
                file = self.folder / f"mesh.{ending}"
                mesh.save(file)
                self.assertIn(doubt, file.read_bytes()[:200], ending)
        self.valve.close().leaflets().save(file)
        self.assertNotIn(b"UNRELIABLE", file.read_bytes())

    def test_fields_are_those_of_the_figures_and_of_the_scene(self):
        closure = self.valve.close()
        scene = self.client.scene("porcine-1")
        self.assertAlmostEqual(closure.tension_n.sum(), closure.measure.tension_sum_n)
        self.assertEqual(list(closure.chordae), [one["id"] for one in scene["chordae"]])
        self.assertEqual(closure.segments.tolist(), scene["segments"])
        numpy.testing.assert_allclose(closure.strain[:, 0], scene["strain"]["circumferential"], atol=6e-5)
        numpy.testing.assert_allclose(
            numpy.quantile(closure.strain[:, 1], 0.99), closure.measure.strain_radial_max, rtol=0.05
        )
        self.assertTrue(0 < closure.contact.sum() < len(closure.contact))
        for array in (closure.strain, closure.contact, closure.segments, closure.tension_n, closure.line_mm):
            with self.assertRaises(ValueError):
                array[0] = array[1]
        mesh = closure.leaflets()
        self.assertEqual(mesh.point_data["contact"].sum(), closure.contact.sum())
        self.assertEqual(mesh.cell_data["strain_radial"].tolist(), closure.strain[:, 1].tolist())
        self.assertEqual(coapt.Mesh(mesh.vertices_mm, mesh.faces).cell_data, {})
        with self.assertRaisesRegex(coapt.CoaptError, "read from a document"):
            coapt.Closure.from_json(closure.json).strain

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "needs meshio")
    def test_meshio_has_the_data_too(self):
        mesh = self.valve.close().leaflets()
        made = mesh.to_meshio()
        made.write(self.folder / "closed.vtu")
        import meshio

        read = meshio.read(self.folder / "closed.vtu")
        numpy.testing.assert_array_equal(read.cell_data["strain_radial"][0], mesh.cell_data["strain_radial"])
        self.assertEqual(set(read.point_data), {"contact"})

    def test_a_file_that_holds_no_valve_is_refused_with_the_place(self):
        other = self.write("other.json", self.valve.to_json() | {"schema": "coapt.valve/9"})
        error = self.refused(coapt.BadDocument, self.client.read_valve, other)
        self.assertEqual([problem.path for problem in error.problems], ["/schema"])
        self.assertIn("other.json", str(error))
        self.refused(coapt.BadDocument, self.client.read_valve, self.write("broken.json", "{"))
        self.refused(coapt.NoSuchFile, self.client.read_valve, self.folder / "none.json")
        self.assertIn(f'did you mean "{VALVE}"', str(self.refused(coapt.InvalidRequest, coapt.preset, VALVE[:-1])))

    def test_a_document_that_is_no_valve_is_refused_with_the_place(self):
        valve = self.valve.to_json()
        for schema in ("coapt.valve/2", "coapt.plan/1"):
            other = valve | {"schema": schema}
            for ask in (self.client.valve, self.client.close, lambda other: self.client.search(other, **SMALL)):
                self.assertEqual(self.problems(coapt.InvalidRequest, ask, other)[0][0], "/valve/schema")
        other = {name: part for name, part in valve.items() if name != "schema"}
        self.assertEqual(self.problems(coapt.InvalidRequest, self.client.valve, other)[0][0], "/valve/schema")

    def test_what_is_no_shape_is_not_compared(self):
        closed = self.valve.close()
        for given in ((closed,), self.valve.vertices_mm, None):
            self.assertIn(
                type(given).__name__, str(self.refused(coapt.BadDocument, self.client.compare, closed, given))
            )

    def test_anything_with_points_and_faces_is_a_shape(self):
        closed = self.valve.close()
        points, faces = closed.closed_mm, closed.leaflets().faces
        for given in (
            (points, faces), (points.tolist(), faces.astype("int64")), types.SimpleNamespace(points=points, faces=faces),
            coapt.Mesh(points.tolist(), faces.tolist()),
        ):  # fmt: skip
            compared = self.client.compare(closed, given)
            self.assertEqual((compared.max_mm, compared.node_to_node), (0.0, True))

    def test_geometry_is_no_valve_and_the_error_says_what_makes_one(self):
        for given in (self.valve.close().leaflets(), self.valve.vertices_mm, 3):
            error = self.refused(coapt.BadDocument, self.client.close, given)
            self.assertIn(f"{type(given).__name__} is no valve", str(error))

    def test_fewer_threads_than_none_are_refused(self):
        refused = self.problems(coapt.InvalidRequest, coapt.close_many, VALVE, threads=-1)
        self.assertEqual(refused, [("/threads", "out_of_range")])

    def test_points_of_another_kind_or_shape_are_not_fitted_to(self):
        points = numpy.array(self.valve.vertices_mm)
        broken = points.copy()
        broken[3, 2] = numpy.inf
        for given, problem in (
            (points > 0, ("/points_mm", "wrong_type")),
            (points[:, :2], ("/points_mm", "wrong_type")),
            (broken, ("/points_mm/3", "out_of_range")),
        ):
            self.assertEqual(self.problems(coapt.InvalidRequest, self.valve.fit, given), [problem])

    def test_a_fit_finds_a_closed_shape(self):
        points = numpy.array(self.valve.close().closed_mm)
        seen = []
        fitted, told = self.valve.fit(
            points, side="middle", points=200, rounds=1, progress=lambda *news: seen.append(news)
        )
        self.assertLess(told.rms_mm, 0.3)
        self.assertTrue(seen)
        self.assertEqual(fitted.faces.tolist(), self.valve.faces.tolist())
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.valve.fit, points, side="inner"), [("/side", "bad_reference")]
        )


@unittest.skipUnless(ENGINE, "no engine")
class Threads(EngineTest):
    def test_closures_of_two_threads_overlap(self):
        """The interpreter goes on while one is made: a thread that counts gets its turns."""
        valve, counted, ended = self.client.preset(VALVE), [], threading.Event()

        def count():
            while not ended.wait(0.002):
                counted.append(time.perf_counter())

        counter = threading.Thread(target=count)
        counter.start()
        start = time.perf_counter()
        try:
            valve.native.close(b"{}")
        finally:
            end = time.perf_counter()
            ended.set()
            counter.join()
        self.assertTrue([one for one in counted if start < one < end])

    def test_any_number_of_threads_gives_the_same_bits(self):
        plans = [Plan(OwnRing(below)) for below in range(4)]
        one, four = (coapt.close_many(VALVE, plans, threads=threads) for threads in (1, 4))
        for a, b in zip(one, four):
            self.assertEqual(a.closure.json | {"seconds": 0}, b.closure.json | {"seconds": 0})
            self.assertTrue((a.closure.closed_mm == b.closure.closed_mm).all())

    def test_a_search_is_the_same_of_one_thread_and_of_two(self):
        found = []
        for threads in (1, 2):
            engine = coapt.Engine(threads=threads)
            found.append(engine.search(VALVE, **SMALL).result().plans[0].json)
            engine.end()
        self.assertEqual(*found)


@unittest.skipUnless(ENGINE, "no engine")
class Jobs(EngineTest):
    def test_interrupted_a_search_has_its_best_so_far(self):
        job = self.client.search(VALVE, **ENDLESS)

        def interrupt(progress):
            if progress.closures > 5 and not interrupted:
                interrupted.append(progress)
                os.kill(os.getpid(), signal.SIGINT)

        interrupted = []
        result = job.wait(progress=interrupt).result()
        self.assertEqual((job.state, result.stop, result.plans[0].rank), ("CANCELLED", "cancelled", 1))

    def test_a_database_keeps_what_was_found(self):
        file = self.folder / "found.sqlite"
        engine = coapt.Engine(file)
        job = engine.search(VALVE, **SMALL)
        found = job.result()
        self.refused(coapt.BadDocument, coapt.Engine, file)  # another has it open
        engine.end()
        again = coapt.Engine(file)
        self.addCleanup(again.end)
        self.assertEqual(again.job(job.id).result().plans[0].json, found.plans[0].json)

    def test_a_script_of_one_line_leaves_nothing_behind(self):
        line = "import coapt; print(coapt.preset('human-normal').close().measure.leak_mm2)"
        run = subprocess.run(
            [sys.executable, "-c", line],
            env=os.environ | {"TMPDIR": str(self.folder)},
            text=True,
            capture_output=True,
        )
        self.assertEqual(run.returncode, OK, run.stderr)
        printed = json.loads(coapt_command("close", "human-normal", "--json").stdout)
        self.assertEqual(float(run.stdout), printed["leak_mm2"])
        self.assertEqual(list(self.folder.iterdir()), [])


class WithoutEngine(unittest.TestCase):
    def test_the_client_works_and_the_engine_says_what_is_missing(self):
        line = (
            "import sys; sys.modules['coapt._engine'] = None\n"
            "import coapt; coapt.Client('http://127.0.0.1:1')\n"
            "try: coapt.preset('human-normal')\nexcept coapt.MissingPackage as error: print(error)"
        )
        run = subprocess.run([sys.executable, "-c", line], text=True, capture_output=True)
        self.assertIn("coapt_python", run.stdout, run.stderr)


if __name__ == "__main__":
    unittest.main()
