"""Series behind the figures of a closure or a plan: each a table (to_frame), too. None: not known."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from . import frames

if TYPE_CHECKING:
    import pandas

Muscle = Literal["both", "anterolateral", "posteromedial"]


@dataclass(frozen=True)
class Section:
    """A section across the line of coaptation, along: 0 anterolateral, 1 posteromedial commissure. height_mm of coaptation;
    distance_mm, the smallest between the leaflets."""

    along: float
    height_mm: float | None
    distance_mm: float | None
    contact: bool


@dataclass(frozen=True)
class Coaptation:
    """Nine sections from commissure to commissure."""

    sections: tuple[Section, ...]

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Coaptation:
        return cls(
            tuple(
                Section(one["along"], one["height_mm"], one["distance_mm"], one["contact"]) for one in json["sections"]
            )
        )

    def to_frame(self) -> pandas.DataFrame:
        """A row a section: along, height_mm, distance_mm, contact."""
        return frames.sections(self.sections)


@dataclass(frozen=True)
class LeakMap:
    """Leak when sutures and tips are off the plan. leak_mm2: a row for each error of suture_length_mm, a column for each angle
    outwards_deg; None: not closed. muscle "both": the same error on both sides. Without a suture suture_length_mm is the error
    of the distance between a tip and its trigone."""

    muscle: Muscle
    suture_length_mm: tuple[float, ...]
    outwards_deg: tuple[float, ...]
    leak_mm2: tuple[tuple[float | None, ...], ...]

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> LeakMap:
        return cls(
            json["muscle"],
            tuple(json["suture_length_mm"]),
            tuple(json["outwards_deg"]),
            tuple(map(tuple, json["leak_mm2"])),
        )


@dataclass(frozen=True)
class LeakMaps:
    """Of one plan: both muscles, then each suture alone. Empty: too little was closed."""

    maps: tuple[LeakMap, ...]

    def of(self, muscle: Muscle = "both") -> LeakMap:
        """:raises KeyError: there is none of it"""
        for one in self.maps:
            if one.muscle == muscle:
                return one
        raise KeyError(f"no map of {muscle!r}; there are: {[one.muscle for one in self.maps]}")

    def to_frame(self) -> pandas.DataFrame:
        """A row a node: muscle, suture_length_mm and outwards_deg (errors), leak_mm2."""
        return frames.leak_maps(self.maps)


@dataclass(frozen=True)
class Remodelling:
    """Leak if the ventricle remodels further after the repair. leak_mm2: by direction, at displacement_mm."""

    displacement_mm: tuple[int, ...]
    leak_mm2: Mapping[str, tuple[float | None, ...]]

    @classmethod
    def from_json(cls, json: Sequence[Mapping[str, Any]]) -> Remodelling:
        curves = {one["direction"]: tuple(one["leak_mm2"]) for one in json}
        return cls(tuple(range(max(map(len, curves.values()), default=0))), curves)

    def to_frame(self) -> pandas.DataFrame:
        """A row a step: direction, displacement_mm, leak_mm2."""
        return frames.remodelling(self)


@dataclass(frozen=True)
class Table:
    """CSV with a header line, units in the names of its columns; empty: not known."""

    csv: str = field(repr=False)

    def to_frame(self) -> pandas.DataFrame:
        return frames.csv(self.csv)

    def write(self, path: str | os.PathLike[str]) -> None:
        pathlib.Path(path).write_text(self.csv, encoding="utf-8")
