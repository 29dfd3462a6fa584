"""Pictures and meshes as notebooks and numpy take them."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .drawn_meshes import OBLIQUE, Lines, axes_of, png_of
from .errors import MissingPackage, NoSuchFile
from .files import read_bounded
from .fields import SEGMENTS, Fields
from .local_transport import engine_module, reading

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class Picture:
    """A PNG; a notebook shows it.

    >>> coapt.preset("human-normal").picture().write("closed.png")
    """

    png: bytes
    """The content of the file."""

    def write(self, path: str | os.PathLike[str]) -> None:
        """To a file.

        >>> valve.picture(plan).write("repaired.png")
        """
        pathlib.Path(path).write_bytes(self.png)

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        return f"Picture({len(self.png):,} bytes of PNG)"


def read_only(numbers: Any) -> Any:
    """An array of them where numpy is installed."""
    if numpy is None:
        return numbers
    array = numpy.array(numbers, dtype=numpy.float64)
    array.setflags(write=False)
    return array


def same_arrays(a: Any, b: Any, *names: str) -> bool:
    """Whether the arrays of these names have the same shapes and numbers."""
    if numpy is None:
        return all(getattr(a, name) == getattr(b, name) for name in names)
    return all(numpy.array_equal(getattr(a, name), getattr(b, name)) for name in names)


_DOUBT = "comment UNRELIABLE"  # in the PLY of a closure that is not to be trusted


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
    _fields: Callable[[], Fields] | None = field(default=None, repr=False)
    _doubt: str = field(default="", repr=False)
    """What files say of a closure that is not to be trusted."""

    @property
    def point_data(self) -> dict[str, Any]:
        """Of the vertices of a closure of the engine in this process: "contact", 1 where leaflets touch; else empty.

        >>> int(closure.leaflets().point_data["contact"].max())
        1
        """
        contact = None if self._fields is None else self._fields().contact
        return {} if contact is None else {"contact": contact.astype("uint8")}

    @property
    def cell_data(self) -> dict[str, Any]:
        """Of the triangles of any closure: "strain_circumferential", "strain_radial", and "segment" by its number in fields.SEGMENTS.

        >>> sorted(coapt.preset("human-normal").close().leaflets().cell_data)
        ['segment', 'strain_circumferential', 'strain_radial']
        """
        if self._fields is None:
            return {}
        fields = self._fields()
        strain = fields.strain.T
        data = {"strain_circumferential": strain[0].copy(), "strain_radial": strain[1].copy()}
        if len(fields.segments):
            data["segment"] = numpy.array([SEGMENTS.index(one) for one in fields.segments], dtype="uint8")
        return data

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Mesh:
        """A file, by its ending: OBJ, PLY, STL, VTK, VTP or VTU.

        >>> coapt.Mesh.read("examples/valves/source/bodyparts3d/anterior_leaflet_sheet.obj").faces.shape[1]
        3

        :raises NoSuchFile, BadDocument: it is not there, or no mesh
        """
        file = pathlib.Path(path)
        try:
            content = read_bounded(file)
        except OSError as error:
            raise NoSuchFile(f"{path}: cannot be read: {error.strerror}") from error
        with reading(f"{path} is no mesh"):
            return cls(*engine_module().read_mesh(content, file.suffix.removeprefix(".").lower()))

    def save(self, path: str | os.PathLike[str]) -> None:
        """To a file, by its ending: OBJ, PLY, STL or VTK, without data; others with them by to_meshio().write(). Of a closure that is not
        to be trusted it says so in its first lines.

        >>> mesh = coapt.preset("human-normal").close().leaflets()
        >>> mesh.save("closed.ply")
        >>> bool((Mesh.read("closed.ply").vertices_mm == mesh.vertices_mm).all())
        True

        :raises BadDocument: another ending
        """
        file = pathlib.Path(path)
        with reading(f"{path} cannot be written"):
            ending = file.suffix.removeprefix(".").lower()
            content = engine_module().write_mesh(self.vertices_mm, self.faces, ending, self._doubt)
        file.write_bytes(content)

    @classmethod
    def from_ply(cls, content: bytes, fields: Callable[[], Fields] | None = None) -> Mesh:
        """Of the service's PLY: ASCII, first the vertices' three coordinates, then triangles.

        :param fields: what it bears
        :raises ValueError: it is another
        """
        head, end, body = content.decode("ascii").partition("end_header\n")
        counts = {words[1]: int(words[2]) for words in map(str.split, head.splitlines()) if words[:1] == ["element"]}
        doubt = "".join(line.removeprefix("comment ") for line in head.splitlines() if line.startswith(_DOUBT))
        if not end or "format ascii 1.0" not in head or list(counts) != ["vertex", "face"]:
            raise ValueError("no ASCII PLY of vertices and faces")
        lines = body.splitlines()
        vertices = [[float(word) for word in line.split()] for line in lines[: counts["vertex"]]]
        faces = [[int(word) for word in line.split()[1:]] for line in lines[counts["vertex"] :][: counts["face"]]]
        if len(faces) < counts["face"] or any(len(row) != 3 for row in vertices + faces):
            raise ValueError("a PLY that breaks off, or not of triangles")
        if numpy is None:
            return cls(vertices, faces, _doubt=doubt)
        return cls(numpy.array(vertices, dtype=numpy.float64), numpy.array(faces, dtype=numpy.int64), fields, doubt)

    def to_meshio(self) -> Any:
        """A meshio.Mesh of triangles with point_data and cell_data: to_meshio().write("closed.vtu").

        >>> closure.leaflets().to_meshio().write("closed.vtu")

        :raises MissingPackage: meshio is not installed
        """
        try:
            import meshio
        except ImportError as error:
            raise MissingPackage("this needs meshio: pip install meshio, or apt install python3-meshio") from error
        cell_data = {name: [values] for name, values in self.cell_data.items()}
        return meshio.Mesh(self.vertices_mm, [("triangle", self.faces)], self.point_data, cell_data)

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData with point_data and cell_data.

        >>> closure.leaflets().to_pyvista().plot()  # doctest: +SKIP

        :raises MissingPackage: pyvista is not installed
        """
        try:
            import pyvista
        except ImportError as error:
            raise MissingPackage("this needs pyvista: pip install pyvista") from error
        made = pyvista.PolyData.from_regular_faces(self.vertices_mm, self.faces)
        for name, values in self.point_data.items():
            made.point_data[name] = values
        for name, values in self.cell_data.items():
            made.cell_data[name] = values
        return made

    def plot(self, colour: str | None = None, *, ax: Axes | None = None) -> Axes:
        """Draws it in three dimensions with matplotlib, seen from the atrium.

        >>> coapt.preset("human-normal").close().leaflets().plot("strain_radial").figure.savefig("strain.png")

        :param colour: one of cell_data; None: grey
        :param ax: of projection "3d"; None: new ones
        :raises MissingPackage: matplotlib is not installed
        """
        return axes_of(self, colour, ax)

    def render(
        self,
        colour: str | None = None,
        *,
        seen_from: Sequence[float] = OBLIQUE,
        size_px: tuple[int, int] = (800, 600),
        lines: Sequence[Lines] = (),
    ) -> Picture:
        """A picture in three dimensions by VTK, which needs no display.

        >>> closure.leaflets().render("strain_radial").write("strain.png")

        :param colour: one of cell_data; None: that of tissue
        :param seen_from: a direction in the valve's frame; (0, 0, 1): from the atrium
        :param lines: drawn beside it
        :raises MissingPackage: VTK, or EGL for one that needs a display, is not installed
        """
        return Picture(png_of(self, colour, lines, seen_from, size_px))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mesh) and same_arrays(self, other, "vertices_mm", "faces")

    def __repr__(self) -> str:
        return f"Mesh({len(self.vertices_mm)} vertices, {len(self.faces)} triangles)"
