"""Pictures and meshes as notebooks and numpy take them."""

from __future__ import annotations

import os
import pathlib
from dataclasses import dataclass
from typing import Any

from .errors import MissingPackage

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


@dataclass(frozen=True)
class Picture:
    """A PNG; a notebook shows it."""

    png: bytes
    """The content of the file."""

    def write(self, path: str | os.PathLike[str]) -> None:
        """To a file."""
        pathlib.Path(path).write_bytes(self.png)

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        return f"Picture({len(self.png):,} bytes of PNG)"


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles: arrays of numpy where it is installed, lists of lists elsewhere.

    >>> coapt.preset("human-normal").close().leaflets()
    Mesh(378 vertices, 648 triangles)
    """

    vertices_mm: Any
    """V x 3, float64, frame of the valve: x posteromedial, y anterior, z to the atrium."""
    faces: Any
    """F x 3, numbers of vertices from 0; int32 of the engine in this process, else int64."""

    @classmethod
    def from_ply(cls, content: bytes) -> Mesh:
        """Of the service's PLY: ASCII, first the vertices' three coordinates, then triangles.

        :raises ValueError: it is another
        """
        head, end, body = content.decode("ascii").partition("end_header\n")
        counts = {words[1]: int(words[2]) for words in map(str.split, head.splitlines()) if words[:1] == ["element"]}
        if not end or "format ascii 1.0" not in head or list(counts) != ["vertex", "face"]:
            raise ValueError("no ASCII PLY of vertices and faces")
        lines = body.splitlines()
        vertices = [[float(word) for word in line.split()] for line in lines[: counts["vertex"]]]
        faces = [[int(word) for word in line.split()[1:]] for line in lines[counts["vertex"] :][: counts["face"]]]
        if len(faces) < counts["face"] or any(len(row) != 3 for row in vertices + faces):
            raise ValueError("a PLY that breaks off, or not of triangles")
        if numpy is None:
            return cls(vertices, faces)
        return cls(numpy.array(vertices, dtype=numpy.float64), numpy.array(faces, dtype=numpy.int64))

    def to_meshio(self) -> Any:
        """A meshio.Mesh of triangles: to_meshio().write("closed.vtu").

        :raises MissingPackage: meshio is not installed
        """
        try:
            import meshio
        except ImportError as error:
            raise MissingPackage("this needs meshio: pip install meshio, or apt install python3-meshio") from error
        return meshio.Mesh(self.vertices_mm, [("triangle", self.faces)])

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData.

        :raises MissingPackage: pyvista is not installed
        """
        try:
            import pyvista
        except ImportError as error:
            raise MissingPackage("this needs pyvista: pip install pyvista") from error
        return pyvista.PolyData.from_regular_faces(self.vertices_mm, self.faces)

    def __repr__(self) -> str:
        return f"Mesh({len(self.vertices_mm)} vertices, {len(self.faces)} triangles)"
