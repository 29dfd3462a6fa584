"""The leak of a closed valve or the opening of an open one: the area of the smallest surface that separates atrium from
ventricle, with half the leaflet thickness on either face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from . import tables
from .estimates import interval

Vector: TypeAlias = tuple[float, float, float]


def _vector(json: Sequence[float]) -> Vector:
    x, y, z = json
    return x, y, z


@dataclass(frozen=True, repr=False)
class LeakOpening(tables.Short):
    """A connected part of that surface, in the valve's frame.

    >>> opening = coapt.preset("human-functional-mr").close().measure.leak.openings[0]
    >>> opening.width_mm < opening.area_mm2, len(opening.outline_mm) > 10
    (True, True)
    """

    area_mm2: float
    centroid_mm: Vector
    normal: Vector
    """Unit, towards the atrium."""
    segments: tuple[str, ...]
    """Of the leaflets around it, such as "P2", the longest part of its rim first; empty of a valve that is not mitral."""
    width_mm: float
    """Of the largest ball that passes."""
    outline_mm: tuple[Vector, ...] = field(repr=False)
    """Its longest rim, closed."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> LeakOpening:
        return cls(
            json["area_mm2"],
            _vector(json["centroid_mm"]),
            _vector(json["normal"]),
            tuple(json["segments"]),
            json["width_mm"],
            tuple(map(_vector, json["outline_mm"])),
        )


@dataclass(frozen=True, repr=False)
class Leak(tables.Short):
    """None: not known, because too little was closed or a closure diverged.

    >>> leak = coapt.preset("human-functional-mr").close().measure.leak
    >>> low, high = leak.between_mm2
    >>> low <= leak.area_mm2 <= high, leak.openings[0].area_mm2 <= leak.area_mm2
    (True, True)
    """

    area_mm2: float | None
    error_mm2: float | None
    """Numerical error, which held in nine of ten test valves; None for an open valve and an unreliable closure."""
    between_mm2: tuple[float, float] | None
    """Bounds of the area on the voxels that it was found on."""
    openings: tuple[LeakOpening, ...]
    """Largest first."""
    numerical: tuple[float, float] | None = None
    """Interval from 5 to 95 % of the area due to the numerical error."""
    tissue: tuple[float, float] | None = None
    """The same for the tissue error; None: no variants were closed, or the observations contradict the model."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Leak:
        return cls(
            json["area_mm2"],
            json["error_mm2"],
            interval(json["between_mm2"]),
            tuple(map(LeakOpening.from_json, json["openings"])),
            interval(json.get("numerical")),
            interval(json.get("tissue")),
        )
