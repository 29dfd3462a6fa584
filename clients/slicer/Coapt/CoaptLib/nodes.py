"""What is read from MRML nodes and written into them: the only part besides the widget that needs Slicer."""

import os
import tempfile

import numpy
import slicer
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from . import scene
from .case import Segment, Segmentation
from .service import Trouble

_MARKUPS = {
    "ClosedCurve": "vtkMRMLMarkupsClosedCurveNode",
    "Curve": "vtkMRMLMarkupsCurveNode",
    "Line": "vtkMRMLMarkupsLineNode",
}


def matrix_of(node):
    """4 x 4, from what is below the node's transform to the world."""
    matrix, transform = vtk.vtkMatrix4x4(), node.GetParentTransformNode()
    if transform and not transform.GetMatrixTransformToWorld(matrix):
        raise Trouble(
            f'"{node.GetName()}" is below a transform that bends. Harden it first (Data module, right click).'
        )
    return _array(matrix)


def read_segmentation(node):
    if not node.CreateBinaryLabelmapRepresentation():
        raise Trouble(f'Segments of "{node.GetName()}" cannot be made label maps.')
    segmentation, found = node.GetSegmentation(), []
    for id in (segmentation.GetNthSegmentID(i) for i in range(segmentation.GetNumberOfSegments())):
        image = slicer.vtkOrientedImageData()
        node.GetBinaryLabelmapRepresentation(id, image)
        extent = image.GetExtent()
        if all(extent[2 * k] <= extent[2 * k + 1] for k in range(3)) and image.GetPointData().GetScalars():
            found.append((id, segmentation.GetSegment(id), image, extent))
    if not found:
        raise Trouble(f'"{node.GetName()}" is empty: draw the anterior and the posterior leaflet as segments.')
    grids = [_image_matrix(image) for _, _, image, _ in found]
    if not all(numpy.allclose(grid, grids[0], atol=1e-6) for grid in grids):
        raise Trouble(
            f'Segments of "{node.GetName()}" have voxels of different places; specify one geometry in Segment Editor.'
        )
    extents = numpy.array([extent for _, _, _, extent in found]).reshape(-1, 3, 2)
    low = extents[:, :, 0].min(axis=0)
    size = extents[:, :, 1].max(axis=0) + 1 - low
    segments = []
    for id, segment, image, extent in found:
        values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
        first = numpy.array(extent[::2]) - low
        mask = numpy.zeros(tuple(size[::-1]), bool)
        mask[tuple(slice(f, f + n) for f, n in zip(first[::-1], values.shape))] = values != 0
        entry = vtk.reference("")
        segment.GetTag("TerminologyEntry", entry)
        segments.append(Segment(segment.GetName(), mask, str(entry.get()), id))
    shift = numpy.eye(4)
    shift[:3, 3] = low
    return Segmentation(segments, grids[0] @ shift, matrix_of(node))


def read_curve(node):
    """N x 3 in the world's RAS: the line as Slicer draws it."""
    points = node.GetCurvePointsWorld()
    return numpy.array([points.GetPoint(i) for i in range(points.GetNumberOfPoints() if points else 0)]).reshape(-1, 3)


def read_points(node):
    """Labels, and N x 3 in the world's RAS."""
    count, place = node.GetNumberOfControlPoints(), [0.0, 0.0, 0.0]
    labels, places = [], []
    for i in range(count):
        node.GetNthControlPointPositionWorld(i, place)
        labels.append(node.GetNthControlPointLabel(i))
        places.append(list(place))
    return labels, numpy.array(places).reshape(-1, 3)


def heart_valve(segmentation):
    """SlicerHeart's valve whose leaflets these are: (annulus curve, volume, imaged closed), each None if it is not known.

    :raises Trouble: it is no mitral valve
    """
    for node in slicer.util.getNodesByClass("vtkMRMLScriptedModuleNode"):
        if (
            node.GetAttribute("ModuleName") != "HeartValve"
            or node.GetNodeReference("LeafletSegmentation") is not segmentation
        ):
            continue
        kind = node.GetAttribute("ValveType")
        if kind not in (None, "", "unknown", "mitral"):
            raise Trouble(f"SlicerHeart calls this valve {kind}; coapt plans for mitral valves.")
        phase = node.GetAttribute("CardiacCyclePhase") or ""
        closed = True if "systol" in phase else False if "diastol" in phase else None
        if phase.startswith("end-"):  # near opening or closing
            closed = None
        return node.GetNodeReference("AnnulusContourPoints"), node.GetNodeReference("ValveVolume"), closed
    return None, None, None


class Folder:
    """What is shown of one closure, in a folder of the subject hierarchy; shown again, it takes the place of what was there."""

    def __init__(self, name, transform):
        self.tree = slicer.mrmlScene.GetSubjectHierarchyNode()
        self.transform = transform
        root = self.tree.GetSceneItemID()
        old = self.tree.GetItemChildWithName(root, name)
        if old:
            self.tree.RemoveItem(old)  # with its children
        self.item, self.name = self.tree.CreateFolderItem(root, name), name

    def _take(self, node):
        if self.transform:
            node.SetAndObserveTransformNodeID(self.transform.GetID())
        self.tree.SetItemParent(self.tree.GetItemByDataNode(node), self.item)
        return node

    def model(self, name, data, array=None, color=(0.86, 0.55, 0.5)):
        node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLModelNode", f"{self.name}: {name}")
        node.SetAndObservePolyData(data)
        node.CreateDefaultDisplayNodes()
        display = node.GetDisplayNode()
        display.SetColor(*color)
        display.SetVisibility2D(True)
        display.SetBackfaceCulling(False)
        if array:
            display.SetActiveScalar(array, vtk.vtkAssignAttribute.CELL_DATA)
            display.SetAndObserveColorNodeID("vtkMRMLColorTableNodeFileViridis.txt")
            display.SetScalarVisibility(True)
        return self._take(node)

    def markup(self, kind, name, labels, places):
        node_class = _MARKUPS.get(kind, "vtkMRMLMarkupsFiducialNode")
        node = slicer.mrmlScene.AddNewNodeByClass(node_class, f"{self.name}: {name}")
        for label, place in zip(labels, places):
            node.AddControlPoint(vtk.vtkVector3d(*place), label)
        node.SetLocked(True)
        node.CreateDefaultDisplayNodes()
        node.GetDisplayNode().SetPointLabelsVisibility(kind == "Fiducial")
        return self._take(node)

    def label_map(self, content):
        path = os.path.join(tempfile.mkdtemp(dir=slicer.app.temporaryPath), "repaired.seg.nrrd")
        with open(path, "wb") as file:
            file.write(content)
        node = slicer.util.loadSegmentation(path)
        os.remove(path)
        os.rmdir(os.path.dirname(path))
        node.SetName(f"{self.name}: label map")
        node.SetAndObserveStorageNodeID(None)
        return self._take(node)

    def sequence(self, frames):
        """A browser that plays them; it is the path of the solver to rest, not motion in time."""
        sequence = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLSequenceNode", f"{self.name}: closing")
        sequence.SetIndexName("state")
        sequence.SetIndexUnit("")
        for i, data in enumerate(frames):
            node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLModelNode", "state")
            node.SetAndObservePolyData(data)
            sequence.SetDataNodeAtValue(node, str(i))  # a copy
            slicer.mrmlScene.RemoveNode(node)
        browser = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLSequenceBrowserNode", f"{self.name}: closing browser")
        browser.SetAndObserveMasterSequenceNodeID(sequence.GetID())
        slicer.modules.sequences.logic().UpdateProxyNodesFromSequences(browser)
        proxy = browser.GetProxyNode(sequence)
        proxy.CreateDefaultDisplayNodes()
        proxy.GetDisplayNode().SetVisibility(False)  # besides the closed valve until somebody wants it
        for node in (sequence, browser):
            self.tree.SetItemParent(self.tree.GetItemByDataNode(node), self.item)
        self._take(proxy)
        return browser


def show(shown, name, transform):
    """A case.Shown as nodes below a transform (None: in the world)."""
    folder, drawn, matrix = Folder(name, transform), shown.scene, shown.matrix
    if drawn["motion_mm"]:
        folder.sequence(scene.closing(drawn, matrix))
    if drawn["closed_mm"] is None:
        return folder
    folder.model("leaflets", scene.leaflets(drawn, matrix), "strain_circumferential" if drawn["strain"] else None)
    folder.model("chordae", scene.chordae(drawn, matrix), "tension_n")
    leak = scene.leak(drawn, matrix)
    if leak is not None:
        folder.model("leak", leak, color=(0.1, 0.3, 0.9))
    for markup in shown.markups or ():
        folder.markup(*markup)
    if shown.labels:
        folder.label_map(shown.labels)
    return folder


def _image_matrix(image):
    matrix = vtk.vtkMatrix4x4()
    image.GetImageToWorldMatrix(matrix)
    return _array(matrix)


def _array(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
