#!/usr/bin/env python3
"""slicer_pictures.py SERVER FOLDER: the pictures of docs/engineer/slicer.md and the module's icon, by VTK from what the module for
3D Slicer shows. SERVER is a coapt-server; the segmentation is that of label_map.py. Needs python3-vtk9, python3-numpy and a display (xvfb-run).
"""

import gzip
import pathlib
import subprocess
import sys
import tempfile

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "clients/slicer/Coapt"))

from CoaptLib import case, scene, service  # noqa: E402

TINTS = ((0.85, 0.45, 0.35), (0.35, 0.55, 0.8), (0.95, 0.8, 0.3))  # anterior, posterior, annulus
WHITE, DARK = (1.0, 1.0, 1.0), (0.15, 0.15, 0.18)


def segmentation():
    """That of label_map.py as Slicer has it."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "map.seg.nrrd"
        subprocess.run([sys.executable, ROOT / "examples/scripts/label_map.py", "-o", path], check=True)
        head, voxels = path.read_bytes().split(b"\n\n", 1)
    lines = dict(line.split(": ", 1) for line in head.decode().split("\n") if ": " in line)
    size = [int(number) for number in lines["sizes"].split()]
    labels = numpy.frombuffer(gzip.decompress(voxels), numpy.uint8).reshape(size[::-1])
    to_lps = numpy.eye(4)
    for k, vector in enumerate((lines["space directions"] + " " + lines["space origin"]).split()):
        to_lps[:3, k] = [float(number) for number in vector.strip("()").split(",")]
    names = ("Anterior leaflet", "Posterior leaflet", "Annulus")
    segments = [case.Segment(name, labels == i, id=name) for i, name in enumerate(names, 1)]
    return case.Segmentation(segments, case.FLIP @ to_lps)


def surface(mask, ijk_to_ras):
    """The outside of voxels, as Slicer shows segments."""
    image = vtk.vtkImageData()
    image.SetDimensions(mask.shape[::-1])
    image.GetPointData().SetScalars(numpy_to_vtk(mask.astype(numpy.float32).ravel(), deep=True))
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.5)
    smooth = vtk.vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(contour.GetOutputPort())
    place = vtk.vtkTransform()
    place.SetMatrix(ijk_to_ras.ravel())
    placed = vtk.vtkTransformPolyDataFilter()
    placed.SetInputConnection(smooth.GetOutputPort())
    placed.SetTransform(place)
    placed.Update()
    return placed.GetOutput()


def tube(data, radius):
    filtered = vtk.vtkTubeFilter()
    filtered.SetInputData(data)
    filtered.SetRadius(radius)
    filtered.SetNumberOfSides(12)
    filtered.Update()
    return filtered.GetOutput()


def line(places, closed):
    data, cells = vtk.vtkPolyData(), vtk.vtkCellArray()
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    ids = [*range(len(places)), *([0] if closed else [])]
    cells.InsertNextCell(len(ids), ids)
    data.SetPoints(points)
    data.SetLines(cells)
    return data


def actor(data, color, opacity=1.0, wire=False, array=None, limits=None):
    mapper = vtk.vtkPolyDataMapper()
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    if array:
        table = vtk.vtkLookupTable()
        table.SetHueRange(0.66, 0.0)
        table.SetSaturationRange(0.75, 0.75)
        table.Build()
        smooth = vtk.vtkCellDataToPointData()
        smooth.SetInputConnection(normals.GetOutputPort())
        mapper.SetInputConnection(smooth.GetOutputPort())
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(array)
        mapper.SetScalarRange(*limits)
        mapper.SetLookupTable(table)
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    made.GetProperty().SetColor(*color)
    made.GetProperty().SetOpacity(opacity)
    if wire:
        made.GetProperty().SetRepresentationToWireframe()
        made.GetProperty().LightingOff()
    return made


def valve(shown):
    closed = scene.leaflets(shown.scene, shown.matrix)
    parts = [
        actor(closed, WHITE, array="strain_radial", limits=(0.1, 0.8)),
        actor(tube(scene.chordae(shown.scene, shown.matrix), 0.25), (0.9, 0.88, 0.8)),
    ]
    if (leak := scene.leak(shown.scene, shown.matrix)) is not None:
        parts.append(actor(leak, (0.1, 0.2, 0.95)))
    for kind, name, _, places in shown.markups:
        if kind != "Fiducial":
            ring = name != "annulus"
            parts.append(
                actor(tube(line(places, kind == "ClosedCurve"), 0.9 if ring else 0.4), TINTS[1 if ring else 2])
            )
    return parts


def draw(path, panels, normal, up, size=(560, 460)):
    """Panels are (title, actors), side by side, seen from the atrium."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(size[0] * len(panels), size[1])
    for i, (title, actors) in enumerate(panels):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(i / len(panels), 0, (i + 1) / len(panels), 1)
        renderer.SetBackground(*DARK)
        for one in actors:
            renderer.AddActor(one)
        if title:
            text = vtk.vtkTextActor()
            text.SetInput(title)
            text.GetTextProperty().SetFontSize(17)
            text.SetPosition(12, 12)
            renderer.AddActor2D(text)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(*(normal * 0.8 - up * 0.6) * 100)
        camera.SetViewUp(*up)
        renderer.ResetCamera()
        camera.Zoom(1.35)
        window.AddRenderer(renderer)
    window.Render()
    grab, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    grab.SetInput(window)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def main():
    server, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    finder, taken, given = service.Finder({"server": server}), case.Case(), segmentation()
    try:
        found = service.waited(finder.found())
        taken.take(given)
        service.waited(taken.importing(found))
        before = service.waited(taken.closing(found))
        plans = service.waited(taken.planning(found, evaluations=60, plans=3, region_points=5, evidence=False))
        plan = next(one for one in plans if one["description"])
        after = service.waited(taken.closing(found, plan["plan"]))
    finally:
        finder.stop()
    axes = before.matrix[:3, :3]
    seen = (axes @ before.scene["plane"]["normal"], axes @ before.scene["plane"]["y"])
    drawn = [surface(one.mask, given.ijk_to_local) for one in given.segments]
    made = scene.leaflets(before.scene, before.matrix, before.scene["rest_mm"])
    panels = [
        ("the segmentation", [actor(data, tint) for data, tint in zip(drawn, TINTS)]),
        (
            "the valve made of it, in the segmentation",
            [*(actor(data, tint, 0.35) for data, tint in zip(drawn, TINTS)), actor(made, WHITE, wire=True)],
        ),
    ]
    draw(folder / "slicer-import.png", panels, *seen)
    steps = "; ".join(plan["description"])
    panels = [
        (f"closed: {before.words().replace('mm²', 'mm2').lower()}", valve(before)),
        (f"plan {plan['rank']}: {after.words().replace('mm²', 'mm2').lower()}\n{steps}", valve(after)),
    ]
    draw(folder / "slicer-plan.png", panels, *seen)
    draw(ROOT / "clients/slicer/Coapt/Resources/Icons/Coapt.png", [("", valve(after))], *seen, size=(128, 128))


if __name__ == "__main__":
    main()
