"""Pictures and meshes as notebooks and numpy take them."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .errors import MissingPackage, NoSuchFile
from .local_transport import engine_module, reading

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

SEGMENTS = ("A1", "A2", "A3", "P1", "P2", "P3", "AC", "PC")
"""The numbers of cell data "segment", in their order: six scallops and the two commissures."""


@dataclass(frozen=True, eq=False)
class Fields:
    """What a closed valve bears, in read-only arrays."""

    strain: NDArray[numpy.float64]
    contact: NDArray[numpy.bool_]
    segments: NDArray[numpy.str_]
    chordae: tuple[str, ...]
    tension_n: NDArray[numpy.float64]

    @classmethod
    def of_engine(cls, told: Mapping[str, Any]) -> Fields:
        arrays = {
            "strain": told["strain"],
            "contact": numpy.array(told["contact"], dtype=bool),
            "segments": numpy.array(told["segments"], dtype="U2"),
            "tension_n": numpy.array(told["tension_n"], dtype=numpy.float64),
        }
        for array in arrays.values():
            array.setflags(write=False)
        return cls(chordae=tuple(told["chordae"]), **arrays)


@dataclass(frozen=True)
class Picture:
    """A PNG; a notebook shows it.

    >>> coapt.preset("human-normal").picture().write("closed.png")
    """

    png: bytes
    """The content of the file."""

    def write(self, path: str | os.PathLike[str]) -> None:
        """To a file."""
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


def drawn(mesh: Mesh, colour: str | None, ax: Axes | None) -> Axes:
    """See Mesh.plot()."""
    try:
        from matplotlib import pyplot
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    except ImportError as error:
        raise MissingPackage(
            "a drawing needs matplotlib: pip install matplotlib, or apt install python3-matplotlib"
        ) from error
    axes: Any = pyplot.figure().add_subplot(projection="3d") if ax is None else ax
    triangles = mesh.vertices_mm[mesh.faces]
    drawing = Poly3DCollection(triangles, edgecolor="#ffffff60", linewidth=0.2, facecolor="#9aa3ad")
    if colour is not None:
        drawing.set_array(mesh.cell_data[colour])
        axes.figure.colorbar(drawing, ax=axes, label=colour.replace("_", " "))
    axes.add_collection3d(drawing)
    lower, upper = mesh.vertices_mm.min(axis=0), mesh.vertices_mm.max(axis=0)
    axes.set(**{f"{name}lim": (lower[k], upper[k]) for k, name in enumerate("xyz")})
    axes.set(xlabel="posteromedial, mm", ylabel="anterior, mm", zlabel="to the atrium, mm")
    axes.set_box_aspect(upper - lower)
    axes.view_init(elev=50, azim=-90)
    return axes


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

    @property
    def point_data(self) -> dict[str, Any]:
        """Of the vertices of a closure of the engine in this process: "contact", 1 where leaflets touch; else empty."""
        return {} if self._fields is None else {"contact": self._fields().contact.astype("uint8")}

    @property
    def cell_data(self) -> dict[str, Any]:
        """Of the triangles, likewise: "strain_circumferential", "strain_radial", and "segment" by its number in meshes.SEGMENTS.

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

        :raises NoSuchFile, BadDocument: it is not there, or no mesh
        """
        file = pathlib.Path(path)
        try:
            content = file.read_bytes()
        except OSError as error:
            raise NoSuchFile(f"{path}: cannot be read: {error.strerror}") from error
        with reading(f"{path} is no mesh"):
            return cls(*engine_module().read_mesh(content, file.suffix.removeprefix(".").lower()))

    def save(self, path: str | os.PathLike[str]) -> None:
        """To a file, by its ending: OBJ, PLY, STL or VTK, without data; others with them by to_meshio().write().

        >>> mesh = coapt.preset("human-normal").close().leaflets()
        >>> mesh.save("closed.ply")
        >>> bool((Mesh.read("closed.ply").vertices_mm == mesh.vertices_mm).all())
        True

        :raises BadDocument: another ending
        """
        file = pathlib.Path(path)
        with reading(f"{path} cannot be written"):
            content = engine_module().write_mesh(self.vertices_mm, self.faces, file.suffix.removeprefix(".").lower())
        file.write_bytes(content)

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
        """A meshio.Mesh of triangles with point_data and cell_data: to_meshio().write("closed.vtu").

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
        return drawn(self, colour, ax)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mesh) and same_arrays(self, other, "vertices_mm", "faces")

    def __repr__(self) -> str:
        return f"Mesh({len(self.vertices_mm)} vertices, {len(self.faces)} triangles)"
