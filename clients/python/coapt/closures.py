"""A closed valve and its figures, as small typed objects. Each keeps the whole document in json.

A unit is the last part of a name (mm, mm2, n: newtons, deg); None: not known, because too little was closed or a closure flew
apart. Areas are anatomic, from geometry: not an effective regurgitant orifice area.
"""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from . import tables
from .drawn_meshes import OBLIQUE, RIM, THREAD, Lines, rim_of
from .errors import CoaptError
from .evidence import Coaptation
from .fields import Fields
from .leaks import Leak, LeakOpening
from .meshes import Mesh, Picture

if TYPE_CHECKING:
    import numpy
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

Status = Literal["converged", "step_limit", "diverged"]
"""How a closure ended: in equilibrium, before equilibrium, or unstable without a shape."""

_BARE = "a closure that is read from a document, or refined by a service, has figures alone"

Document = Mapping[str, Any]


class Kept:
    """A function that returns what is there already; unlike a lambda it can be pickled."""

    def __init__(self, value: Any) -> None:
        self._value = value

    def __call__(self) -> Any:
        return self._value


def known_fields(kind: Any, json: Document) -> dict[str, Any]:
    """Those of a dataclass: a later service may say more."""
    return {one.name: json[one.name] for one in fields(kind)}


@dataclass(frozen=True, repr=False)
class Measure(tables.Short):
    """A closed valve, measured. Errors are numerical (mesh, stopping early, other equilibria), kept by nine of ten measured
    valves; None if the closure is unreliable. Strains are the 99th percentile over triangles, as shares.

    >>> measure = coapt.preset("human-functional-mr").close().measure
    >>> measure.leak_mm2 == measure.leak.area_mm2, "P2" in measure.leak.openings[0].segments
    (True, True)
    >>> [section.contact for section in measure.coaptation.sections].count(True) <= 9
    True
    """

    leak_mm2: float | None
    """The leak; close to zero for a competent valve."""
    coaptation_height_mean_mm: float | None
    """Over nine sections from commissure to commissure; 0 where leaflets do not touch."""
    coaptation_height_min_mm: float | None
    annulus_ap_mm: float | None
    """Anteroposterior diameter, under pressure."""
    annulus_al_pm_mm: float | None
    """Transverse diameter, under pressure."""
    tenting_height_mm: float | None
    """Of the leaflets below the annulus's plane; below 0 where they billow."""
    tension_max_n: float | None
    """Of the segment of a chorda that carries most."""
    tension_sum_n: float | None
    """Of the chordae at their papillary heads."""
    strain_circumferential_max: float | None
    """99th percentile over the leaflets' triangles."""
    strain_radial_max: float | None
    """99th percentile over the leaflets' triangles."""
    _document: Callable[[], Document] = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document) -> Measure:
        coaptation, annulus = json["coaptation"], json["annulus"]
        return cls(
            json["leak_mm2"],
            coaptation["height_mean_mm"],
            coaptation["height_min_mm"],
            annulus["ap_mm"],
            annulus["al_pm_mm"],
            json["tenting_height_mm"],
            json["tension_max_n"],
            json["tension_sum_n"],
            json["strain_circumferential_max"],
            json["strain_radial_max"],
            Kept(json),
        )

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_document": Kept(self.json)}

    @cached_property
    def json(self) -> Document:
        """The whole of it: leak, annulus, sections, and more."""
        return self._document()

    @property
    def leak(self) -> Leak:
        """Its area with error and openings.

        >>> closure.measure.leak.area_mm2 == closure.measure.leak_mm2
        True
        """
        return Leak.from_json(self.json["leak"])

    @property
    def coaptation(self) -> Coaptation:
        """How the leaflets meet, at nine sections.

        >>> len(closure.measure.coaptation.sections)
        9
        """
        return Coaptation.from_json(self.json["coaptation"])


@dataclass(frozen=True, repr=False)
class Closure(tables.Short):
    """A valve, closed (coapt.closure/2).

    >>> closure = coapt.preset("human-normal").close()
    >>> closure.trusted, closure.status
    (True, 'converged')
    >>> vertices_n, axes_n = closure.closed_mm.shape
    >>> axes_n, closure.closed_mm.dtype, closure.closed_mm.flags.writeable
    (3, dtype('float64'), False)
    """

    valve: str
    """Name of the valve."""
    status: Status
    """"converged" (in equilibrium), "step_limit" (not yet) or "diverged" (without a shape)."""
    crossing: bool
    """Whether leaflets cross, which makes the results unreliable."""
    residual: float | None
    """Rms free force over rms pressure force, at the end."""
    steps: int
    """Of the relaxation, over all attempts."""
    seconds: float
    """Computing time of the closure."""
    measure: Measure
    """Its figures."""
    warnings: tuple[str, ...]
    """In sentences; most closures have none."""
    _document: Callable[[], Document] = field(repr=False, compare=False)
    _leaflets: Callable[[], Mesh] | None = field(default=None, repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document, leaflets: Callable[[], Mesh] | None = None) -> Closure:
        """:param leaflets: makes the closed mesh when it is asked for"""
        return cls(
            json["valve"],
            json["status"],
            json["crossing"],
            json["residual"],
            json["steps"],
            json["seconds"],
            Measure.from_json(json),
            tuple(json["warnings"]),
            Kept(json),
            leaflets,
        )

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_document": Kept(self.json)}

    @cached_property
    def json(self) -> Document:
        """The coapt.closure/2."""
        return self._document()

    def leaflets(self) -> Mesh:
        """The closed, repaired leaflets, vertices in the order of the valve's. Of the engine in this process its own numbers,
        read-only, not copied; of a service asked for now, to the digits of its PLY file.

        >>> closure.leaflets().vertices_mm.shape
        (378, 3)

        :raises CoaptError: the closure was read from a document, or refined by a service
        """
        if self._leaflets is None:
            raise CoaptError(_BARE)
        return self._leaflets()

    @property
    def closed_mm(self) -> Any:
        """V x 3, float64: leaflets().vertices_mm.

        >>> lowest_mm = closure.closed_mm[:, 2].min()
        """
        return self.leaflets().vertices_mm

    def _fields(self) -> Fields:
        """:raises CoaptError: it has none, or diverged"""
        fields = getattr(self._leaflets, "fields", None)
        if fields is None:
            raise CoaptError(_BARE)
        told: Fields = fields()
        return told

    @property
    def strain(self) -> NDArray[numpy.float64]:
        """F x 2, along the fibres and across them: Green-Lagrange strain of each triangle from the unstressed shape. Read-only, as are
        those below; of a service asked for now, to four decimals.

        >>> closure = coapt.preset("human-functional-mr").close()
        >>> closure.strain.shape, closure.contact.shape, closure.segments.shape
        ((648, 2), (378,), (648,))
        >>> tightest = closure.chordae[closure.tension_n.argmax()]
        """
        return self._fields().strain

    @property
    def contact(self) -> NDArray[numpy.bool_]:
        """V: whether a vertex touches another part of the leaflets, within 1.25 of their thickness.

        >>> closure.contact.any(), closure.contact.all()
        (True, False)

        :raises CoaptError: the closure is of a service, which does not tell
        """
        contact = self._fields().contact
        if contact is None:
            raise CoaptError("only closures of the engine in this process have contact")
        return contact

    @property
    def segments(self) -> NDArray[numpy.str_]:
        """F: "A1" to "P3" and the commissures "AC" and "PC"; empty of a valve that is not mitral.

        >>> sorted(set(closure.segments.tolist()))
        ['A1', 'A2', 'A3', 'AC', 'P1', 'P2', 'P3', 'PC']
        >>> strain_of_p2 = closure.strain[closure.segments == "P2"]
        """
        return self._fields().segments

    @property
    def chordae(self) -> tuple[str, ...]:
        """Their ids, neochordae included.

        >>> len(closure.chordae) == len(valve.chordae)
        True
        """
        return self._fields().chordae

    @property
    def tension_n(self) -> NDArray[numpy.float64]:
        """Of each chorda at its papillary head; 0 where it is slack or ruptured.

        >>> pull_n = dict(zip(closure.chordae, closure.tension_n))
        >>> round(sum(pull_n.values()), 3) == round(closure.measure.tension_sum_n, 3)
        True
        """
        return self._fields().tension_n

    @property
    def line_mm(self) -> NDArray[numpy.float64]:
        """L x 2 x 3: the segments of the chordae, each from the end towards the papillary head to the other.

        >>> closure.line_mm.shape == (len(closure.line_chorda), 2, 3) == (len(closure.line_tension_n), 2, 3)
        True
        """
        return self._fields().line_mm

    @property
    def line_chorda(self) -> NDArray[numpy.int32]:
        """L: of which chorda a segment is.

        >>> tightest = closure.chordae[closure.line_chorda[closure.line_tension_n.argmax()]]
        """
        return self._fields().line_chorda

    @property
    def line_tension_n(self) -> NDArray[numpy.float64]:
        """L: its tension.

        >>> closure.line_tension_n.max() == closure.measure.tension_max_n
        True
        """
        return self._fields().line_tension_n

    def plot(self, colour: str | None = "strain_radial", *, ax: Axes | None = None) -> Axes:
        """See Mesh.plot(); plots.atrial_view() and others draw it in the plane.

        >>> closure.plot("strain_circumferential").get_zlabel()
        'to the atrium, mm'
        """
        return self.leaflets().plot(colour, ax=ax)

    def render(
        self,
        colour: str | None = "strain_radial",
        *,
        seen_from: Sequence[float] = OBLIQUE,
        size_px: tuple[int, int] = (800, 600),
    ) -> Picture:
        """A picture in three dimensions by VTK, with the chordae and in blue the rims of the leak's openings: see Mesh.render().

        >>> closure.render(seen_from=(0, 0, 1)).write("closed.png")
        """
        chordae = Lines(self.line_mm, 0.25, THREAD)
        rims = [Lines(rim_of(one.outline_mm), 0.35, RIM) for one in self.measure.leak.openings]
        return self.leaflets().render(colour, seen_from=seen_from, size_px=size_px, lines=(chordae, *rims))

    def save(self, path: str | os.PathLike[str], *, open: bool = False) -> None:
        """Write the valve in the file format of another program, chosen by the extension, like Engine.export() without closing again; ".json": the
        coapt.closure/2.

        >>> coapt.preset("human-normal").close().save("closed.vtk")

        :param open: write the unstressed shape
        :raises BadDocument, InvalidRequest: another ending
        :raises CoaptError: the closure was pickled
        """
        file = pathlib.Path(path)
        if file.suffix == ".json" and not file.name.endswith(".mrk.json"):
            file.write_text(json.dumps(self.json) + "\n")
            return
        written = getattr(self._leaflets, "file", None)
        if written is None:
            raise CoaptError("a closure that was pickled is not saved; close the valve again")
        file.write_bytes(written(file.name, open))

    @property
    def trusted(self) -> bool:
        """Whether the results are reliable: the closure converged and leaflets do not cross.

        >>> closure.trusted
        True
        """
        return self.status == "converged" and not self.crossing

    def _repr_html_(self) -> str:
        warned = "" if self.trusted else "<p><b>These results are unreliable.</b></p>"
        bars = tables.coaptation_svg(self.measure.json["coaptation"]["sections"])
        return (
            f"<h4>{tables.escaped(f'{self.valve}: {tables.state(self.status, self.crossing)}')}</h4>{warned}"
            f"{tables.table((), _figures(self.measure))}"
            f"<p>Coaptation height at nine sections, mm (blue); leaflets apart, mm (red)</p>{bars}"
            f"<p>{tables.listed(self.warnings, '! ')}</p>{tables.NOTICE_HTML}"
        )


def _figures(measure: Measure) -> list[tuple[str, str]]:
    number, leak = tables.number, measure.leak
    return [
        ("leak", f"<b>{tables.with_error(leak.area_mm2, leak.error_mm2)} mm²</b>"),
        *((f"opening {i}", _place(opening)) for i, opening in enumerate(leak.openings, 1)),
        (
            "coaptation height",
            f"mean {number(measure.coaptation_height_mean_mm)}, min {number(measure.coaptation_height_min_mm)} mm",
        ),
        ("largest chordal tension", f"{number(measure.tension_max_n, 2)} N"),
        ("annulus", f"AP {number(measure.annulus_ap_mm)}, AL-PM {number(measure.annulus_al_pm_mm)} mm"),
    ]


def _place(opening: LeakOpening) -> str:
    number = tables.number
    at = f", at {', '.join(opening.segments)}" if opening.segments else ""
    return f"{number(opening.area_mm2)} mm², {number(opening.width_mm)} mm wide{at}"
