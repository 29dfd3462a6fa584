"""Series behind the figures of a closure or a plan: each a table (to_frame), too. None: not known."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from . import frames, tables

if TYPE_CHECKING:
    import pandas

Muscle = Literal["both", "anterolateral", "posteromedial"]


@dataclass(frozen=True, repr=False)
class Section(tables.Short):
    """A section across the line of coaptation.

    >>> section = coapt.preset("human-normal").close().measure.coaptation.sections[4]
    >>> section.contact, section.height_mm > 2
    (True, True)
    """

    along: float
    """0: anterolateral, 1: posteromedial commissure."""
    height_mm: float | None
    """Of coaptation; 0 where leaflets do not touch."""
    distance_mm: float | None
    """The smallest between the leaflets."""
    contact: bool
    """Whether the leaflets are in contact."""


@dataclass(frozen=True, repr=False)
class Coaptation(tables.Short):
    """Nine sections from commissure to commissure.

    >>> len(coapt.preset("human-normal").close().measure.coaptation.to_frame())
    9
    """

    sections: tuple[Section, ...]
    """In order from the anterolateral commissure."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Coaptation:
        return cls(
            tuple(
                Section(one["along"], one["height_mm"], one["distance_mm"], one["contact"]) for one in json["sections"]
            )
        )

    def to_frame(self) -> pandas.DataFrame:
        """A row a section: along, height_mm, distance_mm, contact.

        >>> list(closure.measure.coaptation.to_frame())
        ['along', 'height_mm', 'distance_mm', 'contact']
        """
        return frames.records(Section, self.sections)


@dataclass(frozen=True, repr=False)
class LeakMap(tables.Short):
    """Leak with errors of suture length and tip position.

    >>> coapt.LeakMap("both", suture_length_mm=(0.0, 0.5), outwards_deg=(0.0,), leak_mm2=((1.2,), (None,)))
    LeakMap(muscle='both', suture_length_mm=(0, 0.5), outwards_deg=(0), leak_mm2=<2 of tuple>)
    """

    muscle: Muscle
    """Whose suture and tip; "both": the same error on both sides."""
    suture_length_mm: tuple[float, ...]
    """Errors of length, -1 to 1, R of them; without a suture of the distance between a tip and its trigone."""
    outwards_deg: tuple[float, ...]
    """Errors of the tip's angle, -5 to 5, C of them."""
    leak_mm2: tuple[tuple[float | None, ...], ...]
    """R x C: a row for each length, a column for each angle; None: not closed."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> LeakMap:
        return cls(
            json["muscle"],
            tuple(json["suture_length_mm"]),
            tuple(json["outwards_deg"]),
            tuple(map(tuple, json["leak_mm2"])),
        )


@dataclass(frozen=True, repr=False)
class LeakMaps(tables.Short):
    """Of one plan.

    >>> best = coapt.preset("human-functional-mr").evaluate([Plan(OwnRing(2))], region_points=2).plans[0]
    >>> [one.muscle for one in best.leak_maps.maps]
    ['both']
    """

    maps: tuple[LeakMap, ...]
    """Both muscles, then each suture alone. Empty: too little was closed."""

    def of(self, muscle: Muscle = "both") -> LeakMap:
        """
        >>> len(best.leak_maps.of("both").outwards_deg)
        11

        :raises KeyError: there is none of it
        """
        for one in self.maps:
            if one.muscle == muscle:
                return one
        raise KeyError(f"no map of {muscle!r}; there are: {[one.muscle for one in self.maps]}")

    def to_frame(self) -> pandas.DataFrame:
        """A row a node: muscle, suture_length_mm and outwards_deg (errors), leak_mm2.

        >>> list(best.leak_maps.to_frame())
        ['muscle', 'suture_length_mm', 'outwards_deg', 'leak_mm2']
        """
        rows = [
            (one.muscle, length, angle, leak)
            for one in self.maps
            for length, leaks in zip(one.suture_length_mm, one.leak_mm2)
            for angle, leak in zip(one.outwards_deg, leaks)
        ]
        return frames.leaks(rows, ("muscle", "suture_length_mm", "outwards_deg", "leak_mm2"))


@dataclass(frozen=True, repr=False)
class Remodelling(tables.Short):
    """Leak with further ventricular remodelling after the repair.

    >>> coapt.Remodelling(displacement_mm=(0, 1), leak_mm2={"apical": (0.4, 2.5)}).to_frame()["leak_mm2"].tolist()
    [0.4, 2.5]
    """

    displacement_mm: tuple[int, ...]
    """Of the papillary tips: 0, 1, 2, ..."""
    leak_mm2: Mapping[str, tuple[float | None, ...]]
    """By direction ("apical", ...), one for each displacement."""

    @classmethod
    def from_json(cls, json: Sequence[Mapping[str, Any]]) -> Remodelling:
        curves = {one["direction"]: tuple(one["leak_mm2"]) for one in json}
        return cls(tuple(range(max(map(len, curves.values()), default=0))), curves)

    def to_frame(self) -> pandas.DataFrame:
        """A row a step: direction, displacement_mm, leak_mm2.

        >>> list(best.remodelling.to_frame())
        ['direction', 'displacement_mm', 'leak_mm2']
        """
        rows = [
            (direction, displacement, leak)
            for direction, leaks in self.leak_mm2.items()
            for displacement, leak in zip(self.displacement_mm, leaks)
        ]
        return frames.leaks(rows, ("direction", "displacement_mm", "leak_mm2"))


@dataclass(frozen=True, repr=False)
class Tolerance(tables.Short):
    """Leak over the error of one step of a plan, the other steps as planned.

    >>> coapt.Tolerance(0, "suture_length", (-1.0, 0.0, 1.0), (0.0, 0.1, 2.1), 0.45, True).margin_mm
    0.45
    """

    step: int
    """Index in Plan.steps."""
    error: str
    """"ring_size", "suture_length", "suture_anchor", "neochorda_length", "stitch_along_leaflet" or "stitch_towards_edge"."""
    error_mm: tuple[float, ...]
    """Ascending, with 0; impossible errors are left out."""
    leak_mm2: tuple[float | None, ...]
    """One for each error; None: the closure failed."""
    margin_mm: float
    """Smallest error in either direction with a leak above 1 mm2."""
    leaks_beyond: bool
    """False: no simulated error leaks more, so the margin may be larger."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Tolerance:
        values = (tuple(json["error_mm"]), tuple(json["leak_mm2"]))
        return cls(json["step"], json["error"], *values, json["margin_mm"], json["leaks_beyond"])


@dataclass(frozen=True, repr=False)
class Table(tables.Short):
    """CSV with a header line, units in the names of its columns; empty: not known.

    >>> coapt.Table("suture_mm,leak_mm2\\n24,0.5\\n26,\\n").to_frame()["leak_mm2"].tolist()
    [0.5, nan]
    """

    csv: str = field(repr=False)
    """The text of it."""

    def to_frame(self) -> pandas.DataFrame:
        """Its columns; what is not known is NaN.

        >>> len(job.evaluations().to_frame()) > 5
        True
        """
        return frames.csv(self.csv)

    def write(self, path: str | os.PathLike[str]) -> None:
        """To a file, UTF-8.

        >>> job.evaluations().write("evaluations.csv")
        """
        pathlib.Path(path).write_text(self.csv, encoding="utf-8")
