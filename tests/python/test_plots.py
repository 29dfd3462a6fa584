"""Drawings with matplotlib."""

import importlib.util
import os
import sys
import unittest
from unittest import mock

import coapt
from client_runs import SMALL, ClientTest
from coapt import plots
from programs import SOURCE, small_valve

PLANS = SOURCE / "examples/plans"
UNITS = ("mm", "mm²", "N", "degrees", "closures", "steps")


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
class Plots(ClientTest):
    def setUp(self):
        super().setUp()
        os.environ["MPLBACKEND"] = "Agg"
        from matplotlib import pyplot

        self.addCleanup(pyplot.close, "all")

    def drawn(self, draw, *arguments, **named):
        """Axes of their own, which draw() takes, returns and labels."""
        from matplotlib import pyplot

        axes = pyplot.figure().subplots()
        self.assertIs(draw(*arguments, **named, ax=axes), axes)
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            words = label.replace(",", "").replace("(", " ").split()
            self.assertTrue(not label or set(words) & set(UNITS), label)
        axes.figure.savefig(self.folder / "drawing.png")
        self.assertGreater((self.folder / "drawing.png").stat().st_size, 1000)
        return axes

    def scored(self, *plans, **options):
        return self.client.evaluate(small_valve(), plans, **options)

    def test_a_leak_map_has_a_cell_a_node_and_frames_the_plan(self):
        plan = self.scored(PLANS / "mixed.json", region_points=17, evidence=True).plans[0]
        for muscle in ("both", "posteromedial"):
            axes, one = self.drawn(plots.leak_map, plan, muscle), plan.leak_maps.of(muscle)
            cells, frame = axes.collections[0], axes.patches[0]
            self.assertEqual(cells.get_array().size, len(one.suture_length_mm) * len(one.outwards_deg))
            self.assertEqual(cells.get_array().mask.sum(), sum(row.count(None) for row in one.leak_mm2))
            self.assertEqual((frame.get_x() + frame.get_width() / 2, frame.get_y() + frame.get_height() / 2), (0, 0))
            most = max(leak for row in one.leak_mm2 for leak in row if leak is not None)
            self.assertEqual(cells.get_clim(), (0.0, max(1.0, most)))
        self.assertEqual(self.drawn(plots.leak_map, plan, most_mm2=7.0).collections[0].get_clim(), (0.0, 7.0))

    def test_a_map_without_sutures_says_what_its_lengths_are(self):
        plans = self.scored(PLANS / "ring.json", PLANS / "mixed.json", region_points=17).plans
        labels = [self.drawn(plots.leak_map, plan).get_ylabel() for plan in plans]
        self.assertEqual(labels, ["tip to trigone error, mm", "suture length error, mm"])

    def test_coaptation_is_a_bar_a_section_down_where_leaflets_are_apart(self):
        closure = self.client.close(small_valve())
        heights = [bar.get_height() for bar in self.drawn(plots.coaptation, closure).patches]
        sections = closure.measure.coaptation.sections
        self.assertEqual(
            sorted(heights), sorted(one.height_mm if one.contact else -one.distance_mm for one in sections)
        )

    def test_the_atrial_view_has_every_triangle_and_the_section_lies_within_it(self):
        closure = self.client.close(small_valve())
        leaflets, axes = closure.leaflets(), self.drawn(plots.atrial_view, closure)
        self.assertEqual(len(axes.collections[0].get_facecolors()), len(leaflets.faces))
        outlines = [opening.outline_mm for opening in closure.measure.leak.openings if opening.outline_mm]
        rims = [[list(point[:2]) for point in outline] for outline in outlines]
        drawn = [patch.get_xy()[: len(rim)].tolist() for patch, rim in zip(axes.patches, rims, strict=True)]
        self.assertEqual(drawn, rims)
        pieces = self.drawn(plots.section, closure).collections[0].get_segments()
        self.assertTrue(all(len(piece) == 2 for piece in pieces))
        y = [vertex[1] for vertex in leaflets.vertices_mm]
        self.assertTrue(all(min(y) <= point[0] <= max(y) for piece in pieces for point in piece) and len(pieces) > 10)

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "meshio is not installed")
    def test_leaflets_are_meshes_of_meshio(self):
        leaflets = self.client.close(small_valve()).leaflets()
        leaflets.to_meshio().write(self.folder / "closed.vtk")
        self.assertEqual(self.client.close(small_valve()).closed_mm.shape, leaflets.vertices_mm.shape)
        self.assertGreater((self.folder / "closed.vtk").stat().st_size, 1000)
        with mock.patch.dict(sys.modules, {"pyvista": None}):
            with self.assertRaisesRegex(coapt.MissingPackage, "pyvista"):
                leaflets.to_pyvista()

    @unittest.skipUnless(importlib.util.find_spec("vtkmodules"), "VTK is not installed")
    def test_a_picture_in_three_dimensions_needs_no_display(self):
        from matplotlib.image import imread

        closure, file = self.client.close(small_valve()), self.folder / "closed.png"
        with mock.patch.dict(os.environ):
            os.environ.pop("DISPLAY", None)
            closure.render(seen_from=(0, 0, 1), size_px=(320, 240)).write(file)
            grey, strained = closure.leaflets().render(size_px=(80, 60)), closure.leaflets().render("strain_radial")
        pixels = imread(file)[:, :, :3]
        self.assertEqual(pixels.shape, (240, 320, 3))
        self.assertEqual(pixels[0, 0].tolist(), [1, 1, 1])
        self.assertLess(pixels[120, 160].min(), 1)  # leaflets in the middle
        self.assertGreater(len(set(map(tuple, pixels.reshape(-1, 3).tolist()))), 100)  # and shades of their strain
        self.assertNotEqual(grey, strained)
        with mock.patch.dict(sys.modules, {"vtkmodules.all": None}):
            self.assertRaisesRegex(coapt.MissingPackage, "python3-vtk9", closure.render)
        import vtkmodules.all

        if not hasattr(vtkmodules.all, "vtkEGLRenderWindow"):  # which needs no help
            with mock.patch("ctypes.CDLL", side_effect=OSError):
                self.assertRaisesRegex(coapt.MissingPackage, "libegl1", closure.render)

    def test_plans_are_points_with_their_ranks(self):
        result = self.scored(PLANS / "ring.json", PLANS / "own-ring.json", region_points=2)
        axes = self.drawn(plots.plans, result)
        self.assertEqual(
            {(text.get_text(), text.xy) for text in axes.texts},
            {(str(one.rank), (one.leak.value, one.measure.tension_max_n)) for one in result.plans},
        )
        widest = {one.leak.widest for one in result.plans}
        self.assertLessEqual(widest, {tuple(line.get_xdata()) for line in axes.lines})

    def test_progress_ends_where_the_search_did(self):
        result = self.client.search(small_valve(), **SMALL | {"evaluations": 20}).result()
        line = self.drawn(plots.progress, result).lines[0]
        self.assertEqual(line.get_xydata()[-1].tolist(), list(result.json["progress"][-1].values()))

    def test_remodelling_is_a_line_a_direction(self):
        plan = self.scored(PLANS / "ring.json", evidence=True).plans[0]
        labels = [text.get_text() for text in self.drawn(plots.remodelling, plan).get_legend().get_texts()]
        self.assertEqual(labels, list(plan.remodelling.leak_mm2))

    def test_axes_are_made_where_none_are_given(self):
        closure = self.client.close(small_valve())
        self.assertIsNot(plots.coaptation(closure).figure, plots.coaptation(closure).figure)


class WithoutMatplotlib(unittest.TestCase):
    def test_the_package_that_is_missing_is_named(self):
        with mock.patch.dict(sys.modules, {"matplotlib": None}):
            with self.assertRaisesRegex(coapt.MissingPackage, "pip install matplotlib"):
                plots.coaptation(None)


if __name__ == "__main__":
    unittest.main()
