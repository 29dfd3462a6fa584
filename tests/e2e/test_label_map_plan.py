"""From a label map to a closed valve, its files in the patient's frame and a plan's report; the same by the service.

The map is that of examples/scripts/label_map.py: the real valve of BodyParts3D as 1.5 mm thick leaflets on voxels of 0.8 mm,
turned and moved to where the images of a patient might have it.
"""

import base64
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

from plan_runs import options
from programs import NO_COMPETENT_PLAN, OK, SOURCE, ProgramTest, coapt
from server_runs import ServerTest

SCRIPT = SOURCE / "examples/scripts/label_map.py"
sys.path.insert(0, str(SCRIPT.parent))

from label_map import SOURCE as SHEETS, loop_points, points_on, read_obj  # noqa: E402

VOXEL_MM, THICKNESS_MM = 0.8, 1.5
SEED = 1  # of the drawn chordae, as the command line has it
SIDES = ("anterior", "posterior")
MOVED_MM = numpy.array([41.0, -57.0, 123.0])
# With its own chordae the valve leaks 4.2 mm2 through both commissures; with those of seed 1 these maps give 8.7 and 5.6 mm2 (a
# slow reference: 9.1 and 6.0).
MOST_MM2 = 10.0


def turned():
    """By 140 degrees about an axis that is none of the images'."""
    x, y, z = numpy.array([1.0, -2.0, 0.7]) / numpy.linalg.norm([1.0, -2.0, 0.7])
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = numpy.radians(140)
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def placed(points):
    return points @ turned().T + MOVED_MM


def line(letter, entries):
    return " ".join([letter, *map(str, entries)])


def setUpModule():
    """The sheets where the patient has them, and two maps of them."""
    global maps, sheets, annulus
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    maps = pathlib.Path(folder.name)
    sheets = []
    for side in SIDES:
        points, faces = read_obj(SHEETS / f"{side}_leaflet_sheet.obj")
        sheets.append((placed(points), faces))
        lines = [line("v", point) for point in placed(points)] + [line("f", face + 1) for face in faces]
        (maps / f"{side}_leaflet_sheet.obj").write_text("\n".join(lines))
    annulus = placed(numpy.loadtxt(SHEETS / "annulus_centerline.csv", delimiter=",", usecols=(0, 1, 2)))
    numpy.savetxt(maps / "annulus_centerline.csv", annulus, delimiter=",")
    for more in (["-o", maps / "named.seg.nrrd"], ["-o", maps / "bare.nrrd", "--bare"]):
        command = [sys.executable, SCRIPT, maps, "--voxel", str(VOXEL_MM), "--thickness", str(THICKNESS_MM), *more]
        subprocess.run(command, check=True, capture_output=True)


def distances_mm(points, others):
    """Of each point from the nearest of the others."""
    return numpy.array([numpy.linalg.norm(others - point, axis=1).min() for point in points])


def rms(values):
    return numpy.sqrt(numpy.mean(values**2))


def assert_report(test, page):
    """A page with pictures that says where the valve comes from."""
    wanted = (
        "<!DOCTYPE html>",
        "data:image/png;base64,iVBOR",
        f"not imaged; synthesised from anatomical data with seed {SEED}",
    )
    test.assertEqual([words for words in wanted if words not in page], [])


class CommandLine(ProgramTest):
    def imported(self, name):
        """File of the valve that a map becomes, and the decisions: subject, value, look."""
        valve = self.folder / "valve.json"
        printed = json.loads(self.run_ok("valve", "import", maps / name, "-o", valve, "--json").stdout)
        for leaflet in printed["thickness"]:
            self.assertAlmostEqual(leaflet["mean_mm"], THICKNESS_MM, delta=VOXEL_MM / 4)
        return valve, [(d["subject"], d["value"], d["look"]) for d in printed["decisions"]]

    def assert_closes(self, valve):
        closed = json.loads(self.run_ok("close", valve, "--json").stdout)
        self.assertEqual((closed["status"], closed["crossing"]), ("converged", False))
        self.assertLess(closed["leak_mm2"], MOST_MM2)
        return closed

    def assert_decided(self, decisions, subject, words, look=False):
        found = [value for about, value, looked in decisions if (about, looked) == (subject, look)]
        self.assertTrue(any(words in value for value in found), f"{subject}: {found}")

    def test_a_map_with_names_becomes_a_valve_that_closes(self):
        valve, decisions = self.imported("named.seg.nrrd")
        self.assert_decided(decisions, "leaflets", "label 1 is the anterior leaflet, label 2 the posterior one")
        self.assert_decided(decisions, "labels", "label 3 is the annulus")
        self.assert_decided(decisions, "labels", "voxels of 0.8 x 0.8 x 0.8 mm, in the patient's frame, LPS")
        self.assert_decided(decisions, "units", "mm")
        for side in SIDES:
            self.assert_decided(
                decisions, f"{side} leaflet", "thick shell (closed surface) replaced by its mid-surface"
            )
        self.assert_decided(decisions, "state", "imaged open")
        self.assert_decided(decisions, "thickness", "the tissue thickness remains 1 mm; the shells measure 1.")
        self.assert_decided(decisions, "chordae", f"not imaged; synthesised from anatomical data with seed {SEED}")
        self.assert_decided(decisions, "frame", "a mirror image cannot be detected", look=True)  # no heart lies so
        self.assertEqual([about for about, _, look in decisions if look], ["frame"])
        self.assert_closes(valve)

    def test_a_map_of_leaflets_alone_has_its_annulus_found_and_looked_at(self):
        valve, decisions = self.imported("bare.nrrd")
        self.assert_decided(decisions, "annulus", "not given; detected along the leaflet outlines", look=True)
        self.assertEqual([about for about, _, look in decisions if look], ["frame", "annulus"])
        self.assert_closes(valve)

    def test_what_is_exported_lies_where_the_map_was_drawn(self):
        valve, _ = self.imported("named.seg.nrrd")
        shape, markups = self.folder / "open.obj", self.folder / "closed.mrk.json"
        self.run_ok("export", valve, "--open", "-o", shape)
        self.run_ok("export", valve, "-o", markups)
        points, faces = read_obj(shape)
        of_sheets = numpy.concatenate([sheet for sheet, _ in sheets])
        ring = loop_points(annulus, VOXEL_MM / 2)
        self.assertLess(rms(distances_mm(of_sheets, points_on(points, faces, VOXEL_MM))), VOXEL_MM / 2)
        # The skirt goes on to the annulus and across the commissures, where there is no sheet.
        self.assertLess(rms(distances_mm(points, numpy.concatenate([of_sheets, ring]))), VOXEL_MM)
        curve = json.loads(markups.read_text())["markups"][0]
        self.assertEqual((curve["type"], curve["coordinateSystem"]), ("ClosedCurve", "LPS"))
        positions = numpy.array([point["position"] for point in curve["controlPoints"]])
        self.assertLess(distances_mm(positions, ring).max(), 1.5 * VOXEL_MM)
        # Its own axes are elsewhere.
        self.run_ok("export", valve, "--open", "--frame", "valve", "-o", shape)
        self.assertGreater(distances_mm(read_obj(shape)[0], of_sheets).min(), 50)

    def test_a_search_reports_a_plan_and_what_unseen_chordae_leave_open(self):
        valve, _ = self.imported("named.seg.nrrd")
        report = self.folder / "report.html"
        few = options(evaluations=40, plans=1, region_points=5, model_draws=2)
        result = coapt("plan", valve, *few, "-o", report, "--json")
        self.assertIn(result.returncode, (OK, NO_COMPETENT_PLAN), result.stderr)
        found = json.loads(result.stdout)
        before, (best,) = found["before"], found["plans"]
        self.assertEqual(before["leak_mm2"], self.assert_closes(valve)["leak_mm2"])
        self.assertEqual((best["status"], best["crossing"]), ("converged", False))
        self.assertLessEqual(best["leak_mm2"]["mean"], before["leak_mm2"])
        self.assertTrue(found["model_draws"]["chordae_drawn"])
        assert_report(self, report.read_text())


class Service(ServerTest):
    def end_of(self, job):
        ended = self.server.wait_for_end(job["id"])
        self.assertEqual(ended["state"], "SUCCEEDED", ended["problems"])
        return ended

    def test_a_map_becomes_the_valve_of_the_command_line_and_a_report(self):
        name = "named.seg.nrrd"
        labels = {"name": name, "base64": base64.b64encode((maps / name).read_bytes()).decode()}
        job = self.server.submit({"labels": labels, "chordae_seed": SEED}, "/v1/imports")
        imported = self.server.get(self.end_of(job)["links"]["result"])
        valve = self.folder / "valve.json"
        printed = json.loads(self.run_ok("valve", "import", maps / name, "-o", valve, "--json").stdout)
        # Bare files are guessed first, and their chordae need no seed.
        decisions = [decision for decision in printed["decisions"] if decision["subject"] != "files"]
        self.assertEqual(imported["decisions"], decisions)
        stored, written = self.server.get(f"/v1/valves/{imported['valve']}"), json.loads(valve.read_text())
        for part in ("vertices_mm", "faces", "chordae", "patient_frame"):
            self.assertEqual(stored[part], written[part])

        search = {"evaluations": 12, "plans": 1, "region_points": 2, "model_draws": 0, "evidence": False}
        ended = self.end_of(self.submit(search, imported["valve"]))
        status, _, page = self.curl_with_headers(ended["links"]["report"])
        self.assertEqual(status, 200)
        assert_report(self, page)


if __name__ == "__main__":
    unittest.main()
