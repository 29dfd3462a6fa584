"""Repair plans (coapt.plan/1) from small parts. Lengths are millimetres.

    Plan(Ring("generic-classic", size_mm=30), PapillaryApproximation("posteromedial", suture_length_mm=22))

Each part knows its JSON; what a valve allows (which chordae there are, how short a suture may be) the service checks.
"""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal, TypeAlias

Side = Literal["anterolateral", "posteromedial"]
Anchor = Literal["ipsilateral_trigone", "saddle_peak", "annulus_point"]


@dataclass(frozen=True)
class LeafletPoint:
    """A place on a leaflet. along: 0 at the anterolateral, 1 at the posteromedial commissure. height: 0 at the annulus, 1 at
    the free edge."""

    leaflet: Literal["anterior", "posterior"]
    along: float
    height: float = 1.0

    def to_json(self) -> dict[str, Any]:
        return {"leaflet": self.leaflet, "along": self.along, "height": self.height}


@dataclass(frozen=True)
class Ring:
    """An annuloplasty ring of the catalogue (Client.rings()). size_mm: its label, the transverse width, 24 to 40 in steps of
    2."""

    shape: str
    size_mm: float
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": self.shape, "size_mm": self.size_mm}


@dataclass(frozen=True)
class OwnRing:
    """A ring of the valve's own shape, sizes_below (0 to 6) sizes of 2 mm transverse smaller."""

    sizes_below: int
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": "own", "sizes_below": self.sizes_below}


@dataclass(frozen=True)
class Neochorda:
    """A new chorda of length_mm (5 to 40) from a papillary head, by its id in the valve, to a leaflet."""

    head: str
    insertion: LeafletPoint
    length_mm: float
    step: ClassVar[str] = "neochorda"

    def to_json(self) -> dict[str, Any]:
        return {
            "step": self.step,
            "head": self.head,
            "insertion": self.insertion.to_json(),
            "length_mm": self.length_mm,
        }


@dataclass(frozen=True)
class ChordalLengthChange:
    """A chorda's trunk made longer by change_mm (-20 to 20); negative shortens."""

    chorda: str
    change_mm: float
    step: ClassVar[str] = "chordal_length_change"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "chorda": self.chorda, "change_mm": self.change_mm}


@dataclass(frozen=True)
class ChordalExcision:
    """A chorda cut away."""

    chorda: str
    step: ClassVar[str] = "chordal_excision"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "chorda": self.chorda}


@dataclass(frozen=True)
class ChordalTransfer:
    """A chorda moved to another place of a leaflet."""

    chorda: str
    insertion: LeafletPoint
    step: ClassVar[str] = "chordal_transfer"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "chorda": self.chorda, "insertion": self.insertion.to_json()}


@dataclass(frozen=True)
class PapillaryApproximation:
    """A suture that pulls the tip of a papillary muscle to within suture_length_mm (12 to 100) of an anchor on the annulus.

    annulus_around, of anchor "annulus_point" alone: 0 posteromedial commissure, 0.25 saddle peak, 0.5 anterolateral
    commissure, 0.75 mid-posterior.
    """

    side: Side
    suture_length_mm: float
    anchor: Anchor = "ipsilateral_trigone"
    annulus_around: float | None = None
    step: ClassVar[str] = "papillary_approximation"

    def to_json(self) -> dict[str, Any]:
        json: dict[str, Any] = {"step": self.step, "side": self.side, "anchor": self.anchor}
        if self.annulus_around is not None:
            json["annulus_around"] = self.annulus_around
        return json | {"suture_length_mm": self.suture_length_mm}


Step: TypeAlias = (
    Ring | OwnRing | Neochorda | ChordalLengthChange | ChordalExcision | ChordalTransfer | PapillaryApproximation
)
_WITH_INSERTION = ("neochorda", "chordal_transfer")
_KINDS: dict[str, type[Step]] = {
    Neochorda.step: Neochorda,
    ChordalLengthChange.step: ChordalLengthChange,
    ChordalExcision.step: ChordalExcision,
    ChordalTransfer.step: ChordalTransfer,
    PapillaryApproximation.step: PapillaryApproximation,
}


def step_from_json(json: Mapping[str, Any]) -> Step:
    """:raises ValueError: it is no step of coapt.plan/1"""
    fields = {name: value for name, value in json.items() if name != "step"}
    try:
        if json["step"] == "annuloplasty":
            return OwnRing(fields["sizes_below"]) if fields["shape"] == "own" else Ring(**fields)
        if json["step"] in _WITH_INSERTION:
            fields["insertion"] = LeafletPoint(**fields["insertion"])
        return _KINDS[json["step"]](**fields)
    except (KeyError, TypeError) as error:
        raise ValueError(f"no step of coapt.plan/1: {dict(json)}") from error


class Plan:
    """Steps of a repair; their order does not change the result. Plan() is the valve as it is."""

    def __init__(self, *steps: Step) -> None:
        self.steps: tuple[Step, ...] = steps

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Plan:
        """:raises ValueError: it is no coapt.plan/1"""
        if json.get("schema") != "coapt.plan/1" or not isinstance(json.get("steps"), list):
            raise ValueError('no coapt.plan/1: "schema" and "steps" are needed')
        return cls(*map(step_from_json, json["steps"]))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Plan:
        return cls.from_json(json.loads(pathlib.Path(path).read_text()))

    def to_json(self) -> dict[str, Any]:
        """coapt.plan/1, as the service and `coapt close --plan` read it."""
        return {"schema": "coapt.plan/1", "steps": [step.to_json() for step in self.steps]}

    def write(self, path: str | os.PathLike[str]) -> None:
        pathlib.Path(path).write_text(json.dumps(self.to_json(), indent=2) + "\n")

    def with_step(self, step: Step) -> Plan:
        """This plan and one step more."""
        return Plan(*self.steps, step)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Plan) and self.steps == other.steps

    def __hash__(self) -> int:
        return hash(self.steps)

    def __repr__(self) -> str:
        return f"Plan({', '.join(map(repr, self.steps))})"
