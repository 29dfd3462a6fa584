"""What is shown lies where it was segmented, has the numbers of coapt's own files, and follows the transform."""

import unittest

import numpy
import vtk
from slicer_runs import VOXEL_MM, SlicerTest, case, example, nearest_mm, probe_to_ras, service, voxel_places
from vtk.util.numpy_support import vtk_to_numpy

from CoaptLib import scene

PLAN = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": 30}]}


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def array_of(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


class Scenes(SlicerTest):
    taken = None  # imported by the first test: a document, which any service closes

    def setUp(self):
        super().setUp()
        self.given = example(probe_to_ras())
        if self.taken is None:
            Scenes.taken = case.Case()
            self.taken.take(self.given)
            service.waited(self.taken.importing(self.service))

    def shown(self, plan=None):
        return service.waited(self.taken.closing(self.service, plan))

    def test_the_example_comes_back_to_its_voxels(self):
        """Through world and LPS, import, the valve's own frame and back below ProbeToRAS."""
        shown = self.shown()
        leaflets = scene.leaflets(shown.scene, shown.matrix, shown.scene["rest_mm"])
        away = nearest_mm(points_of(leaflets), voxel_places(self.given, (0, 1, 2)))
        of_leaflets = nearest_mm(points_of(leaflets), voxel_places(self.given))
        print(
            f"vertices from the segmented voxels: {numpy.sqrt(numpy.mean(of_leaflets**2)):.2f} mm rms, "
            f"{of_leaflets.max():.2f} mm at most; with the annulus's {numpy.sqrt(numpy.mean(away**2)):.2f} mm rms"
        )
        self.assertLess(numpy.sqrt(numpy.mean(away**2)), VOXEL_MM)
        self.assertLess(away.max(), 3 * VOXEL_MM)

    def test_models_are_those_of_coapts_own_file(self):
        for plan in (None, PLAN):
            shown = self.shown(plan)
            request = {"valve": self.taken.valve, "format": "vtk", **({"plan": plan} if plan else {})}
            answer = service.waited(self.steps(self.service.ask("POST", "/v1/exports", request)))
            reader = vtk.vtkPolyDataReader()
            reader.ReadFromInputStringOn()
            reader.SetInputString(answer.body.decode())
            reader.ReadAllScalarsOn()
            reader.Update()
            file = reader.GetOutput()
            lps = case.FLIP @ probe_to_ras()
            drawn = scene.leaflets(shown.scene, shown.matrix)
            count, faces = drawn.GetNumberOfPoints(), drawn.GetNumberOfCells()
            there = case.moved(points_of(drawn), lps)
            numpy.testing.assert_allclose(there, points_of(file)[:count], atol=2e-3)  # a scene is rounded to 0.001 mm
            for name in ("segment", *scene.STRAINS):
                numpy.testing.assert_allclose(array_of(drawn, name), array_of(file, name)[-faces:], atol=1e-3)
            chordae = scene.chordae(shown.scene, shown.matrix)
            tensions = array_of(file, "tension_n")[:-faces]
            self.assertEqual(chordae.GetNumberOfCells(), len(tensions))
            numpy.testing.assert_allclose(sorted(array_of(chordae, "tension_n")), sorted(tensions), atol=1e-3)

    def test_markups_lie_on_the_models(self):
        shown = self.shown(PLAN)
        leaflets = points_of(scene.leaflets(shown.scene, shown.matrix))
        markups = {name: places for _, name, _, places in shown.markups}
        self.assertLess(nearest_mm(markups["annulus"], leaflets).max(), 0.01)
        self.assertLess(
            nearest_mm(markups["papillary muscle tips"], points_of(scene.chordae(shown.scene, shown.matrix))).max(),
            0.01,
        )
        self.assertTrue(any("ring" in name for name in markups), list(markups))

    def test_the_leak_is_drawn_with_its_area(self):
        shown = self.shown()
        drawn = scene.leak(shown.scene, shown.matrix)
        areas = sorted(set(array_of(drawn, "area_mm2")))
        self.assertAlmostEqual(sum(areas), shown.scene["closure"]["leak_mm2"], delta=0.05)
        leaflets = points_of(scene.leaflets(shown.scene, shown.matrix))
        self.assertLess(nearest_mm(points_of(drawn), leaflets).max(), 3.0)
        self.assertIsNone(scene.leak({"leak": []}, numpy.eye(4)))

    def test_a_closing_begins_open_and_ends_closed(self):
        shown = self.shown()
        states = scene.closing(shown.scene, shown.matrix)
        self.assertEqual(len(states), case.FRAMES)
        rest = scene.leaflets(shown.scene, shown.matrix, shown.scene["rest_mm"])
        closed = scene.leaflets(shown.scene, shown.matrix)
        numpy.testing.assert_allclose(points_of(states[-1]), points_of(closed), atol=2e-3)
        self.assertLess(numpy.abs(points_of(states[0]) - points_of(rest)).max(), 1.0)
        self.assertGreater(numpy.abs(points_of(rest) - points_of(closed)).max(), 5.0)

    @staticmethod
    def steps(exchange):
        return (yield exchange)


if __name__ == "__main__":
    unittest.main()
