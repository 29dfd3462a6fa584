"""Two closed shapes beside each other."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

from .closures import Closure, Measure
from .errors import BadDocument, CoaptError
from .geometry import packed_geometry
from .imports import packed
from .local_transport import reading, refusing
from .meshes import Fields, Mesh, read_only, same_arrays

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    from . import _engine

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

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Comparison:
        """Of an answer with nodes."""
        told = {name: value for name, value in document.items() if name != "nodes"}
        nodes = document["nodes"]
        return cls(
            told["rms_mm"],
            told["p95_mm"],
            told["max_mm"],
            told["pairing"] == "node_to_node",
            told["alignment"]["rigid"],
            read_only(nodes["signed_mm"]),
            read_only(nodes["moved_mm"]),
            told,
        )

    def __eq__(self, other: object) -> bool:
        alike = isinstance(other, Comparison) and self.json == other.json
        return alike and same_arrays(self, other, "signed_mm", "moved_mm")


def local_closure(native: _engine.Closure) -> Closure:
    """Its figures as they are; its document is written when it is asked for."""
    valve, status, crossing, residual, steps, seconds, figures, warnings = native.told()

    @cache
    def document() -> Any:
        return json.loads(native.document())

    measure = Measure(*(*figures, document))
    return Closure(
        valve, status, crossing, residual, steps, seconds, measure, warnings, document, LocalLeaflets(native)
    )


class LocalLeaflets:
    """Of a closure in this process."""

    def __init__(self, native: _engine.Closure) -> None:
        self.native = native

    @cached_property
    def _told(self) -> Fields | None:
        told = self.native.fields()
        return Fields.of_engine(told) if told else None

    def fields(self) -> Fields:
        """:raises CoaptError: the closure diverged"""
        return known_fields_of(self._told)

    def file(self, path: str, open: bool) -> bytes:
        """:raises BadDocument: another ending than of formats that are known"""
        with reading("the closure cannot be written"):
            return self.native.file(path, open)

    def __call__(self) -> Mesh:
        return Mesh(self.native.closed_mm, self.native.faces, self.fields)

    def __reduce__(self) -> tuple[Any, ...]:
        # Its numbers: elsewhere there is no engine that has them.
        return KeptLeaflets, (self.native.closed_mm, self.native.faces, self._told)


@dataclass(frozen=True, eq=False)
class KeptLeaflets:
    """Of a closure that was pickled."""

    closed_mm: NDArray[numpy.float64]
    faces: NDArray[numpy.int32]
    told: Fields | None

    def fields(self) -> Fields:
        """:raises CoaptError: the closure diverged"""
        return known_fields_of(self.told)

    def __call__(self) -> Mesh:
        return Mesh(self.closed_mm, self.faces, self.fields)


def known_fields_of(told: Fields | None) -> Fields:
    if told is None:
        raise CoaptError("this closure diverged, so it has no strain, contact and tension")
    return told


def shape_document(source: ShapeSource) -> dict[str, Any]:
    """As requests take it.

    :raises NoSuchFile, BadDocument: of what is no shape
    """
    if isinstance(source, Closure):
        if isinstance(source._leaflets, LocalLeaflets):
            with refusing():
                return {"mesh": json.loads(source._leaflets.native.shape()), "source": source.valve}
        source = source.leaflets()
    if isinstance(source, (str, os.PathLike)):
        return {"file": packed(source)}
    try:
        file = packed_geometry(source, "arrays")
    except TypeError:
        file = {"name": "none"}
    if not file["name"].endswith(".obj"):
        raise BadDocument(
            f"no shape: {type(source).__name__}; a closure, what has points and faces, or a file is needed"
        )
    return {"file": file, "source": "arrays"}
