"""The module as far as it can be seen without Slicer: grammar, files, size; and run against names that take any call, with a
service that is real."""

import ast
import pathlib
import re
import time
import unittest
from unittest.mock import MagicMock

import numpy
import stand_in
import vtk
from programs import SOURCE
from slicer_runs import SMALL, SlicerTest, case, example, probe_to_ras
from vtk.util.numpy_support import numpy_to_vtk

slicer, qt, ctk = stand_in.install()

import Coapt  # noqa: E402
from CoaptLib import nodes, service  # noqa: E402

FOLDER = SOURCE / "clients/slicer"


class Files(unittest.TestCase):
    def test_sources_are_python_3_9(self):
        for path in FOLDER.rglob("*.py"):
            tree = ast.parse(path.read_text(), feature_version=(3, 9))
            later = [node for node in ast.walk(tree) if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr)]
            self.assertEqual(later, [], f"{path}: unions of types, or of dictionaries as well be written otherwise")

    def test_the_widget_has_fewer_than_200_lines(self):
        tree = ast.parse((FOLDER / "Coapt/Coapt.py").read_text())
        (widget,) = [node for node in tree.body if getattr(node, "name", "") == "CoaptWidget"]
        self.assertLess(widget.end_lineno - widget.lineno + 1, 200)

    def test_every_file_is_installed(self):
        listed = (FOLDER / "Coapt/CMakeLists.txt").read_text().split()
        for path in (FOLDER / "Coapt").rglob("*.*"):
            if path.name != "CMakeLists.txt" and "__pycache__" not in path.parts:
                self.assertIn(str(path.relative_to(FOLDER / "Coapt")), listed)

    def test_the_description_says_what_the_build_says(self):
        lines = [line for line in (FOLDER / "Coapt.s4ext").read_text().splitlines() if line and line[0] != "#"]
        described = dict(line.split(None, 1) for line in lines)
        built = dict(re.findall(r'set\(EXTENSION_(\w+) "(.*)"\)', (FOLDER / "CMakeLists.txt").read_text()))
        for name in ("homepage", "contributors", "category", "iconurl", "screenshoturls"):
            self.assertEqual(described[name], built[name.upper()])
        self.assertEqual((described["scm"], described["depends"], described["enabled"]), ("git", "NA", "1"))


class Nodes(unittest.TestCase):
    def setUp(self):
        slicer.mrmlScene.added.clear()

    def test_segments_of_any_extent_come_together_on_one_grid(self):
        given = segmentation_node(example(probe_to_ras()))
        read = nodes.read_segmentation(given)
        self.assertEqual(
            [segment.name for segment in read.segments], ["Anterior leaflet", "Posterior leaflet", "Annulus"]
        )
        numpy.testing.assert_allclose(read.to_world, probe_to_ras())
        expected = example().cropped()
        found = read.cropped()
        numpy.testing.assert_array_equal(found.layers[0], expected.layers[0])
        numpy.testing.assert_allclose(found.ijk_to_local, expected.ijk_to_local, atol=1e-9)

    def test_what_cannot_be_read_is_said(self):
        empty = segmentation_node(case.Segmentation([], numpy.eye(4)))
        with self.assertRaisesRegex(service.Trouble, "is empty"):
            nodes.read_segmentation(empty)
        bent = MagicMock()
        bent.GetParentTransformNode().GetMatrixTransformToWorld.return_value = 0
        with self.assertRaisesRegex(service.Trouble, "transform that bends"):
            nodes.matrix_of(bent)

    def test_slicerhearts_valve_tells_annulus_and_phase_and_is_mitral(self):
        segmentation, heart = MagicMock(), MagicMock()
        said = {"ModuleName": "HeartValve", "ValveType": "mitral", "CardiacCyclePhase": "mid-systole"}
        heart.GetAttribute.side_effect = lambda name: said.get(name)
        references = {"LeafletSegmentation": segmentation, "AnnulusContourPoints": "curve", "ValveVolume": "echo"}
        heart.GetNodeReference.side_effect = references.get
        slicer.util.getNodesByClass.return_value = [MagicMock(), heart]
        self.assertEqual(nodes.heart_valve(segmentation), ("curve", "echo", True))
        said["CardiacCyclePhase"] = "mid-diastole"
        self.assertIs(nodes.heart_valve(segmentation)[2], False)
        self.assertEqual(nodes.heart_valve(MagicMock()), (None, None, None))
        said["ValveType"] = "tricuspid"
        with self.assertRaisesRegex(service.Trouble, "calls this valve tricuspid"):
            nodes.heart_valve(segmentation)


def segmentation_node(given):
    """Each segment on an image just as large as itself, as Slicer keeps them."""
    node, images = MagicMock(), {}
    for segment in given.segments:
        filled = numpy.argwhere(segment.mask)
        low, high = filled.min(axis=0), filled.max(axis=0) + 1
        values = segment.mask[tuple(slice(*ends) for ends in zip(low, high))].astype(numpy.uint8)
        images[segment.id] = (numpy.ravel([low[::-1], high[::-1] - 1], order="F").tolist(), values)

    def represent(id, image):
        extent, values = images[id]
        image.to_world = given.ijk_to_local
        image.SetExtent(*extent)
        image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))

    def matrix(target):
        for i in range(4):
            for j in range(4):
                target.SetElement(i, j, given.to_world[i, j])
        return 1

    segmentation = node.GetSegmentation()
    segmentation.GetNumberOfSegments.return_value = len(images)
    segmentation.GetNthSegmentID.side_effect = lambda i: list(images)[i]
    names = {segment.id: segment.name for segment in given.segments}
    segmentation.GetSegment.side_effect = lambda id: MagicMock(**{"GetName.return_value": names[id]})
    node.GetBinaryLabelmapRepresentation.side_effect = represent
    node.GetParentTransformNode().GetMatrixTransformToWorld.side_effect = matrix
    return node


class Panel(SlicerTest):
    def setUp(self):
        super().setUp()
        slicer.mrmlScene.added.clear()
        slicer.util.getNodesByClass.return_value = []
        slicer.app.temporaryPath = str(self.folder)
        self.widget = Coapt.CoaptWidget()
        self.widget.setup()
        self.widget.settings["url"].text = self.url
        self.widget.settingsChanged()
        self.addCleanup(self.widget.cleanup)
        for box in (self.widget.annulus, self.widget.tips, self.widget.image):
            box.currentNode.return_value = None

    def until_done(self):
        while self.widget.task:
            self.widget.poll()
            time.sleep(0.01)
        return self.widget.said.text

    def test_from_a_segmentation_to_a_plan_and_its_report(self):
        widget, given = self.widget, segmentation_node(example(probe_to_ras()))
        widget.segmentation.currentNode.return_value = given
        widget.importValve()
        self.assertRegex(self.until_done(), r"^720 triangles, \d+ chordae; decisions to check: 0\.$")
        widget.close()
        self.assertRegex(self.until_done(), "^Leak ")
        widget.run(widget.logic.case.planning(widget.logic.finder.service, **SMALL), lambda plans: "found")
        self.assertEqual(self.until_done(), "found")
        widget.close(widget.logic.case.plans[0])
        self.assertRegex(self.until_done(), "^Leak ")
        widget.report()
        self.assertIn("<!DOCTYPE html>", pathlib.Path(self.until_done()).read_text())

        added = slicer.mrmlScene.added
        models = {name: node for kind, name, node in added if kind == "vtkMRMLModelNode" and name != "state"}
        self.assertEqual({"coapt: leaflets", "coapt: chordae", "coapt plan 1: leaflets"} - set(models), set())
        leaflets = models["coapt: leaflets"].SetAndObservePolyData.call_args[0][0]
        self.assertIsInstance(leaflets, vtk.vtkPolyData)
        transform = given.GetParentTransformNode()
        models["coapt: leaflets"].SetAndObserveTransformNodeID.assert_called_with(transform.GetID())
        self.assertEqual(sum(name == "state" for _, name, _ in added), 2 * case.FRAMES)
        self.assertIn("vtkMRMLMarkupsClosedCurveNode", [kind for kind, *_ in added])
        self.assertEqual(slicer.util.loadSegmentation.call_count, 2)

    def test_a_correction_imports_again_and_what_is_under_way_is_not_replaced(self):
        widget = self.widget
        widget.segmentation.currentNode.return_value = segmentation_node(example())
        widget.importValve()
        task = widget.task
        widget.plan()
        self.assertIs(widget.task, task)
        self.assertTrue(widget.stop.enabled and not widget.buttons[0].enabled)
        task.cancel()
        self.assertIn("ancelled", self.until_done())
        widget.correct("flip", True)
        self.assertEqual(qt.QTimer.singleShot.call_args[0], (0, widget.importValve))
        widget.importValve()
        self.assertRegex(self.until_done(), "chordae")
        self.assertTrue(widget.logic.case.says["flip"])

    def test_what_goes_wrong_is_said_in_the_panel(self):
        self.widget.segmentation.currentNode.return_value = None
        self.widget.importValve()
        self.assertIn("Choose a segmentation", self.widget.said.text)
        self.widget.plan()
        self.assertIn("There is no valve yet", self.until_done())
        self.server.stop()
        self.widget.logic.finder.stop()
        self.widget.close()
        self.assertIn("No service answers", self.until_done())
        self.assertTrue(all(button.enabled for button in self.widget.buttons))

    def test_a_file_of_a_valve_opens(self):
        path = self.folder / "valve.json"
        path.write_bytes(self.server.ask("GET", "/v1/presets/human-normal").body)
        qt.QFileDialog.getOpenFileName.return_value = str(path)
        self.widget.openValve()
        self.widget.close()
        self.assertRegex(self.until_done(), "^Leak ")
        path.write_text("{")
        self.widget.openValve()
        self.assertIn("valve.json cannot be read", self.widget.said.text)


if __name__ == "__main__":
    unittest.main()
