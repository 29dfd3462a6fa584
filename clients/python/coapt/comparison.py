"""Two closed shapes beside each other."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from .closures import Closure
from .errors import BadDocument
from .geometry import packed_geometry
from .imports import packed
from .leaflets import LocalLeaflets
from .local_transport import refusing
from .meshes import read_only, same_arrays

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
