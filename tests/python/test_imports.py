"""Files of segmentation tools become stored valves."""

import json
import re
import subprocess
import unittest
from types import SimpleNamespace

import coapt
from client_runs import ClientTest
from coapt.geometry import packed_geometry
from programs import COAPT, OK, SOURCE

EXAMPLE = json.loads((SOURCE / "server/openapi.json").read_text())["components"]["examples"]["one_skirt"]["value"]


POINTS = [(0, 0, 0), (1.5, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 1, 2), (0, 2, 3)]
OBJECT = "v 0.0 0.0 0.0\nv 1.5 0.0 0.0\nv 0.0 1.0 0.0\nv 0.0 0.0 1.0\nf 1 2 3\nf 1 3 4\n"


class Cell:
    """Of VTK."""

    def __init__(self, kind, dimension, corners):
        self.GetCellType, self.GetCellDimension = (lambda: kind), (lambda: dimension)
        self.GetNumberOfPoints, self.GetPointId = (lambda: len(corners)), corners.__getitem__


class VtkMesh:
    """What is asked of one: two triangles and a line, or a strip."""

    cells = [Cell(5, 2, [0, 1, 2]), Cell(5, 2, [0, 2, 3]), Cell(3, 1, [1, 2])]

    def GetNumberOfPoints(self):
        return len(POINTS)

    def GetPoint(self, i):
        return POINTS[i]

    def GetNumberOfCells(self):
        return len(self.cells)

    def GetCell(self, i):
        return self.cells[i]


class Geometry(unittest.TestCase):
    def test_meshes_in_memory_are_the_same_file(self):
        blocks = [SimpleNamespace(type="triangle", data=FACES), SimpleNamespace(type="vertex", data=[[0]])]
        flat = [3, 0, 1, 2, 3, 0, 2, 3]
        for mesh in (
            (POINTS, FACES),
            (POINTS, flat),
            SimpleNamespace(points=POINTS, cells=blocks),
            SimpleNamespace(points=POINTS, faces=flat),
            SimpleNamespace(vertices=POINTS, faces=FACES),
            SimpleNamespace(vertices_mm=POINTS, faces=FACES),
        ):
            self.assertEqual(packed_geometry(mesh, "leaflet-1"), {"name": "leaflet-1.obj", "text": OBJECT})
        self.assertEqual(packed_geometry(VtkMesh(), "a")["text"], OBJECT + "l 2 3\n")
        strip = VtkMesh()
        strip.cells = [Cell(6, 2, [1, 2, 0, 3])]
        self.assertEqual(packed_geometry(strip, "a")["text"].splitlines()[4:], ["f 2 3 1", "f 3 4 1"])

    def test_arrays_of_any_type_are_taken(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("numpy is not installed")
        for real, whole in ((numpy.float32, numpy.uint16), (numpy.float64, numpy.int64)):
            mesh = (numpy.array(POINTS, real), numpy.array(FACES, whole))
            self.assertEqual(packed_geometry(mesh, "a")["text"], OBJECT)

    def test_points_and_tips_are_tables(self):
        table = packed_geometry(POINTS[:2], "annulus")
        self.assertEqual(table, {"name": "annulus.csv", "text": "x,y,z\n0.0,0.0,0.0\n1.5,0.0,0.0\n"})
        tips = packed_geometry({"AL": (1, 2, 3), "PM": (4, 5, 6)}, "tips")
        self.assertEqual(tips["text"], "papillary,x,y,z\nAL,1.0,2.0,3.0\nPM,4.0,5.0,6.0\n")

    def test_what_is_no_geometry_is_named(self):
        for wrong in (3, [1, 2, 3], [("a", "b", "c")], SimpleNamespace(points=POINTS)):
            with self.assertRaisesRegex(TypeError, "leaflet-2: must be a path"):
                packed_geometry(wrong, "leaflet-2")


class Imports(ClientTest):
    def files(self):
        """Those of the example in the service's document."""
        return [
            self.write(one["name"], one["text"])
            for one in (*EXAMPLE["leaflets"], EXAMPLE["annulus"], EXAMPLE["chordae"])
        ]

    def test_meshes_become_a_valve_that_closes(self):
        skirt, annulus, chordae = self.files()
        stored = self.client.import_valve([skirt], annulus, chordae, name="mine", triangles=100)
        self.assertEqual((stored.name, stored.chordae), ("mine", 10))
        self.assertEqual(self.client.close(stored.id).status, "converged")
        self.assertIn("mine", [valve.name for valve in self.client.valves()])

    def test_meshes_in_memory_become_the_same_valve(self):
        skirt, annulus, chordae = self.files()
        rows = [line.split() for line in skirt.read_text().splitlines()]
        points = [[float(x) for x in row[1:4]] for row in rows if row and row[0] == "v"]
        faces = [[int(x.split("/")[0]) - 1 for x in row[1:]] for row in rows if row and row[0] == "f"]
        numbers = re.compile(r"^[-0-9]")
        loop = [[float(x) for x in line.split(",")] for line in annulus.read_text().splitlines() if numbers.match(line)]
        stored = [
            self.client.import_valve([skirt], annulus, chordae, triangles=100),
            self.client.import_valve([(points, faces)], loop, chordae, triangles=100),
        ]
        self.assertEqual(stored[0].id, stored[1].id)

    def test_binary_meshes_and_folders_do_too(self):
        valve = self.folder / "valve.json"
        valve.write_text(json.dumps(self.client.get_valve("human-normal")))
        for target in ("skirt.stl", "exported/"):
            run = subprocess.run(
                [COAPT, "export", valve, "--open", "-o", f"{self.folder}/{target}"], capture_output=True
            )
            self.assertEqual(run.returncode, OK, run.stderr)
        _, annulus, chordae = self.files()
        self.assertGreater(self.client.import_valve([self.folder / "skirt.stl"], annulus, chordae).triangles, 600)
        stored = self.client.import_slicerheart(self.folder / "exported", name="from a folder", triangles=300)
        self.assertEqual((stored.name, stored.triangles < 400), ("from a folder", True))

    def test_parts_of_files_are_detected(self):
        skirt, annulus, chordae = self.files()
        named = self.client.import_valve([skirt], annulus, chordae, triangles=100)
        detected = self.client.import_files([annulus, chordae, skirt], triangles=100)
        self.assertEqual(detected.triangles, named.triangles)
        self.assertEqual(detected.decisions[0].value, "file 1 of 3 (.csv) is the annulus")
        folder = self.folder / "one"
        folder.mkdir()
        (folder / "notes.md").write_text("not a part")
        for file in (skirt, annulus, chordae):
            (folder / file.name).write_bytes(file.read_bytes())
        job = self.client.import_job(files=folder, triangles=100)
        self.assertEqual(job.result().chordae, named.chordae)
        paths = self.problems(coapt.InvalidRequest, self.client.import_files, [annulus, annulus, skirt])
        self.assertEqual([path for path, _ in paths], ["/files/1"])

    def test_chordae_that_were_not_seen_are_drawn(self):
        valve = self.folder / "valve.json"
        valve.write_text(json.dumps(self.client.get_valve("human-normal")))
        folder = self.folder / "open"
        run = subprocess.run([COAPT, "export", valve, "--open", "-o", f"{folder}/"], capture_output=True)
        self.assertEqual(run.returncode, OK, run.stderr)
        leaflets = [folder / "anterior_leaflet.vtk", folder / "posterior_leaflet.vtk"]
        stored = self.client.import_valve(leaflets, folder / "annulus.mrk.json", 1, name="drawn", triangles=300)
        self.assertEqual(self.client.get_valve(stored.id)["drawn_chordae"], {"seed": 1, "tips_given": False})
        self.assertIn("units", [decision.subject for decision in stored.decisions])
        self.assertEqual(stored.decisions[-1].subject, "chordae")

    def test_what_is_wrong_is_said_of_the_file(self):
        skirt, annulus, chordae = self.files()
        annulus.write_text("1;2;3\n")
        paths = self.problems(coapt.InvalidRequest, self.client.import_valve, [skirt], annulus, chordae)
        self.assertTrue(paths and all(path.startswith("/annulus") for path, _ in paths), paths)
        with self.assertRaisesRegex(coapt.NoSuchFile, "nowhere.obj"):
            self.client.import_valve([self.folder / "nowhere.obj"], annulus, chordae)
        with self.assertRaisesRegex(coapt.NoSuchFile, "is no folder"):
            self.client.import_slicerheart(self.folder / "nowhere")

    def test_an_import_is_a_job_with_a_picture_and_a_fit(self):
        skirt, annulus, chordae = self.files()
        landmarks = {"saddle_peak": [0, 13.8, 3.6]}
        job = self.client.import_job([skirt], annulus, chordae, name="mine", triangles=300, landmarks=landmarks)
        self.assertEqual(job.kind, "import")
        plain = job.result()
        self.assertEqual((plain.name, plain.chordae, plain.fit), ("mine", 10, None))
        self.assertEqual((plain.valve, plain.imported), (job.json["made"], job.json["valve"]))
        self.assertIn("saddle peak as given", [decision.value for decision in plain.decisions])
        self.assertTrue(plain.picture().png.startswith(b"\x89PNG"))

        surface = self.folder / "closed.stl"
        surface.write_bytes(self.client.export(plain.valve, "stl"))
        fit = coapt.Fit(surface, side="middle", known=["slack", "prestretch", "stiffness", "hidden"], rounds=2)
        job = self.client.import_job([skirt], annulus, chordae, triangles=300, fit=fit)
        seen = []
        fitted = job.wait(seen.append).result()
        self.assertTrue(any("mm rms" in str(progress) for progress in (*seen, job.progress)))
        self.assertLess(fitted.fit.rms_mm, 0.5)
        self.assertEqual(fitted.fit.parameters[0].name, "tip_AL_x")
        self.assertNotEqual(fitted.valve, fitted.imported)
        self.assertEqual(fitted.decisions[-1].subject, "fit")
        self.assertEqual(self.client.job(job.id).result(), fitted)

    def test_what_is_wrong_with_a_job_is_said_at_once(self):
        skirt, annulus, chordae = self.files()
        refused = self.problems(
            coapt.InvalidRequest, self.client.import_job, [skirt], annulus, chordae, fit=coapt.Fit()
        )
        self.assertEqual(refused, [("/fit/surface", "missing_field")])
        with self.assertRaises(TypeError):
            self.client.import_job([skirt])


if __name__ == "__main__":
    unittest.main()
