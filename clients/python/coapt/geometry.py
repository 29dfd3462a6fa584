"""Meshes and points in memory, as the files that they would be."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

_STRIP = 6  # VTK's number of a strip of triangles


class _Shape:
    """Points, and cells as indices of them: polygons, and lines."""

    def __init__(self, points: Iterable[Iterable[Any]]) -> None:
        self.points = [[float(x) for x in point] for point in points]
        self.polygons: list[list[int]] = []
        self.lines: list[list[int]] = []

    def add(self, cells: Iterable[Any], to: list[list[int]]) -> None:
        """Rows of corners, or PyVista's flat list of counts, each before its corners."""
        rows = list(cells)
        if rows and not hasattr(rows[0], "__len__"):
            at = 0
            while at < len(rows):
                to.append([int(i) for i in rows[at + 1 : at + 1 + int(rows[at])]])
                at += 1 + int(rows[at])
        else:
            to.extend([int(i) for i in row] for row in rows)

    def text(self) -> str:
        lines = ["v " + " ".join(map(repr, point)) for point in self.points]
        for key, cells in (("f", self.polygons), ("l", self.lines)):
            lines += [key + "".join(f" {i + 1 if i >= 0 else i}" for i in cell) for cell in cells]
        return "\n".join(lines) + "\n"


def _of_vtk(mesh: Any) -> _Shape:
    shape = _Shape(mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints()))
    for number in range(mesh.GetNumberOfCells()):
        cell = mesh.GetCell(number)
        corners = [int(cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints())]
        if cell.GetCellType() == _STRIP:
            for k in range(2, len(corners)):
                shape.polygons.append([corners[k - 2], corners[k - 1 + k % 2], corners[k - k % 2]])
        elif cell.GetCellDimension() == 2:
            shape.polygons.append(corners)
        elif cell.GetCellDimension() == 1:
            shape.lines.append(corners)
    return shape


def _of_meshio(mesh: Any) -> _Shape:
    shape = _Shape(mesh.points)
    for block in mesh.cells:
        if block.type in ("triangle", "quad", "polygon"):
            shape.add(block.data, shape.polygons)
        elif block.type == "line":
            shape.add(block.data, shape.lines)
    return shape


def _shape_of(what: Any) -> _Shape:
    if hasattr(what, "GetNumberOfCells") and hasattr(what, "GetPoint"):
        return _of_vtk(what)
    if hasattr(what, "points") and hasattr(what, "cells"):
        return _of_meshio(what)
    for points, faces in (
        ("vertices_mm", "faces"),
        ("points", "faces"),
        ("vertices", "faces"),
        ("vertices", "triangles"),
    ):
        if hasattr(what, points) and hasattr(what, faces):
            what = (getattr(what, points), getattr(what, faces))
            break
    if isinstance(what, tuple) and len(what) == 2:
        shape = _Shape(what[0])
        shape.add(what[1], shape.polygons)
        return shape
    return _Shape(what)


def packed_geometry(what: Any, name: str) -> dict[str, Any]:
    """As OBJ, or as a table of x, y, z where there are neither faces nor lines.

    :param what: a pair of points and faces, an object with both (meshio, PyVista, VTK, trimesh, coapt's own), points alone
        in their order, or of papillary tips a mapping of "AL" and "PM" to a point
    :raises TypeError: it is none of these
    """
    try:
        if isinstance(what, Mapping):
            rows = [f"{side},{','.join(repr(float(x)) for x in point)}" for side, point in what.items()]
            return {"name": f"{name}.csv", "text": "\n".join(["papillary,x,y,z", *rows]) + "\n"}
        shape = _shape_of(what)
    except (TypeError, ValueError) as error:
        kinds = "a path, points, a pair of points and faces, or an object with points and faces"
        raise TypeError(f"{name}: must be {kinds}: {error}") from error
    if shape.polygons or shape.lines:
        return {"name": f"{name}.obj", "text": shape.text()}
    rows = [",".join(map(repr, point)) for point in shape.points]
    return {"name": f"{name}.csv", "text": "\n".join(["x,y,z", *rows]) + "\n"}
