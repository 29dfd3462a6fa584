"""What a scene of coapt (coapt.scene/2) shows, as VTK polydata. matrix: 4 x 4, from the scene's coordinates to those of the result."""

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

from .case import moved

SEGMENTS = ("A1", "A2", "A3", "P1", "P2", "P3", "AC", "PC")
STRAINS = ("strain_circumferential", "strain_radial")


def leaflets(scene, matrix, flat=None):
    """Cells have segment (a number in SEGMENTS) and Green-Lagrange strains; points have around and height, their place on the
    leaflets.

    :param flat: vertices instead of the closed ones, and then without strains
    """
    closed = flat is None
    faces = numpy.asarray(scene["faces"]).reshape(-1, 3)
    data = _polydata(_points(scene["closed_mm"] if closed else flat, matrix), faces, "polys")
    _add(data.GetCellData(), "segment", [SEGMENTS.index(name) for name in scene["segments"]])
    for name in STRAINS if closed and scene["strain"] else ():
        _add(data.GetCellData(), name, scene["strain"][name.split("_")[1]])
    for name in ("around", "height"):
        _add(data.GetPointData(), name, scene["leaflet_coordinates"][name])
    return data


def closing(scene, matrix):
    """The leaflets on their way from open to closed."""
    count = 3 * len(scene["leaflet_coordinates"]["around"])
    return [leaflets(scene, matrix, frame[:count]) for frame in scene["motion_mm"]]


def chordae(scene, matrix):
    """Lines with tension_n, and neochorda: 1 of artificial ones. Ruptured chordae are left out."""
    points, lines, tensions, new = [], [], [], []
    for chorda in scene["chordae"]:
        if chorda["ruptured"]:
            continue
        first = len(points)
        points.append(scene["heads"][chorda["head"]]["tip_mm"])
        for i, segment in enumerate(chorda["segments"], 1):
            points.append(segment["end_mm"])
            lines.append((first + segment["parent"] + 1, first + i))
            tensions.append(numpy.nan if segment["tension_n"] is None else segment["tension_n"])
            new.append(int(chorda["kind"] == "neochorda"))
    data = _polydata(_points(points, matrix), numpy.array(lines).reshape(-1, 2), "lines")
    _add(data.GetCellData(), "tension_n", tensions)
    _add(data.GetCellData(), "neochorda", new)
    return data


def leak(scene, matrix):
    """The surfaces whose area is the leak, each with area_mm2; None where nothing leaks."""
    if not scene["leak"]:
        return None
    points, faces, areas = [], [], []
    for surface in scene["leak"]:
        faces.append(numpy.asarray(surface["faces"]).reshape(-1, 3) + sum(map(len, points)))
        points.append(numpy.asarray(surface["points_mm"]).reshape(-1, 3))
        areas += [surface["area_mm2"]] * len(faces[-1])
    data = _polydata(_points(numpy.concatenate(points), matrix), numpy.concatenate(faces), "polys")
    _add(data.GetCellData(), "area_mm2", areas)
    return data


def _points(flat, matrix):
    return moved(numpy.asarray(flat, float), matrix)


def _polydata(points, cells, kind):
    data, array = vtk.vtkPolyData(), vtk.vtkCellArray()
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    sized = numpy.insert(cells, 0, cells.shape[1], axis=1).astype(numpy.int64)
    array.SetCells(len(cells), numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(sized).ravel(), deep=True))
    data.SetPoints(places)
    (data.SetPolys if kind == "polys" else data.SetLines)(array)
    return data


def _add(attributes, name, values):
    array = numpy_to_vtk(numpy.asarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)
