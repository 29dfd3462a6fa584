"""What a closed valve bears, in read-only arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from numpy.typing import NDArray

SEGMENTS = ("A1", "A2", "A3", "P1", "P2", "P3", "AC", "PC")
"""The numbers of cell data "segment", in their order: six scallops and the two commissures."""


@dataclass(frozen=True, eq=False)
class Fields:
    """See Closure, whose properties they are."""

    strain: NDArray[numpy.float64]
    contact: NDArray[numpy.bool_] | None
    segments: NDArray[numpy.str_]
    chordae: tuple[str, ...]
    tension_n: NDArray[numpy.float64]
    line_mm: NDArray[numpy.float64]
    line_chorda: NDArray[numpy.int32]
    line_tension_n: NDArray[numpy.float64]

    @classmethod
    def of_engine(cls, told: Mapping[str, Any]) -> Fields:
        """:param told: by _engine.Closure.fields()"""
        arrays = {
            "strain": numpy.asarray(told["strain"]),
            "segments": numpy.array(told["segments"], dtype="U2"),
            "tension_n": numpy.array(told["tension_n"], dtype=numpy.float64),
            "line_mm": numpy.asarray(told["line_mm"]),
            "line_chorda": numpy.array(told["line_chorda"], dtype=numpy.int32),
            "line_tension_n": numpy.array(told["line_tension_n"], dtype=numpy.float64),
        }
        contact = None if told["contact"] is None else numpy.array(told["contact"], dtype=bool)
        for array in (*arrays.values(), *(() if contact is None else (contact,))):
            array.setflags(write=False)
        return cls(chordae=tuple(told["chordae"]), contact=contact, **arrays)

    @classmethod
    def of_scene(cls, scene: Mapping[str, Any]) -> Fields:
        """:param scene: a coapt.scene/2, which does not say what touches"""
        strain, chordae = scene["strain"], scene["chordae"]
        lines = [(c, *line) for c, chorda in enumerate(chordae) for line in _lines(chorda, scene["heads"])]
        return cls.of_engine(
            {
                "strain": numpy.array([strain["circumferential"], strain["radial"]]).T,
                "contact": None,
                "segments": scene["segments"],
                "chordae": [chorda["id"] for chorda in chordae],
                "tension_n": [
                    sum(one["tension_n"] for one in chorda["segments"] if one["parent"] < 0) for chorda in chordae
                ],
                "line_mm": numpy.array([(start, end) for _, start, end, _ in lines]).reshape(-1, 2, 3),
                "line_chorda": [c for c, *_ in lines],
                "line_tension_n": [tension for *_, tension in lines],
            }
        )


def _lines(chorda: Mapping[str, Any], heads: Any) -> Iterator[tuple[Any, Any, float]]:
    """Start, end and tension of each segment."""
    for one in chorda["segments"]:
        start = heads[chorda["head"]]["tip_mm"] if one["parent"] < 0 else chorda["segments"][one["parent"]]["end_mm"]
        yield start, one["end_mm"], one["tension_n"]
