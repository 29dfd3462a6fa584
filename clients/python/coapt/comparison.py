"""Two closed shapes beside each other."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from .closures import Closure
from .errors import BadDocument, NoSuchFile
from .geometry import packed_geometry
from .leaflets import LocalLeaflets
from .local_transport import engine_module, refusing
from .meshes import Mesh, same_arrays

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

ShapeSource: TypeAlias = Any
"""A closure; a mesh: coapt's, a pair of points and faces, or one of meshio, PyVista, VTK or trimesh; or a file: OBJ, PLY, STL, VTK, VTP or
VTU; in mm."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """Distances of a closed shape from a reference (coapt.comparison/1): node by node if both have the same nodes, otherwise from
    its nodes to the reference's surface.

    >>> valve = coapt.preset("human-normal")
    >>> comparison = valve.compare(valve.close())
    >>> comparison.rms_mm, comparison.node_to_node, comparison.moved_mm.shape == valve.vertices_mm.shape
    (0.0, True, True)
    """

    rms_mm: float
    """Root mean square."""
    p95_mm: float
    """95th percentile."""
    max_mm: float
    node_to_node: bool
    """False: from nodes to the reference's surface."""
    aligned: bool
    """The closed shape was moved rigidly onto the reference before."""
    signed_mm: NDArray[numpy.float64] = field(repr=False)
    """N: of each node; positive on the side to which the reference's normals point, the atrium's."""
    moved_mm: NDArray[numpy.float64] = field(repr=False)
    """N x 3: where the nodes lie after the alignment."""
    json: Mapping[str, Any] = field(repr=False)
    """The coapt.comparison/1."""

    def __eq__(self, other: object) -> bool:
        alike = isinstance(other, Comparison) and self.json == other.json
        return alike and same_arrays(self, other, "signed_mm", "moved_mm")


def _obj(source: Any) -> bytes:
    """:raises BadDocument: it has no points and faces"""
    try:
        packed = packed_geometry(source, "shape")
    except TypeError:
        packed = {"name": "none"}
    if not packed["name"].endswith(".obj"):
        raise BadDocument(
            f"no shape: {type(source).__name__}; a closure, what has points and faces, or a file is needed"
        )
    return str(packed["text"]).encode()


def native_shape(source: ShapeSource) -> Any:
    shapes = engine_module().Shape
    if isinstance(source, Closure) and isinstance(source._leaflets, LocalLeaflets):
        with refusing():
            return shapes.of_closure(source._leaflets.native)
    if isinstance(source, (Closure, Mesh)):
        mesh = source.leaflets() if isinstance(source, Closure) else source
        with refusing():
            return shapes.of_arrays("arrays", mesh.vertices_mm, mesh.faces)
    if not isinstance(source, (str, os.PathLike)):
        with refusing():
            return shapes.of_file("arrays", _obj(source), "obj")
    file = pathlib.Path(source)
    try:
        content = file.read_bytes()
    except OSError as error:
        raise NoSuchFile(f"{source}: cannot be read: {error.strerror}") from error
    with refusing():
        return shapes.of_file(file.name, content, file.suffix.removeprefix(".").lower())
