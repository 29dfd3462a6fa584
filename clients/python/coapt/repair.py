"""Repair plans (coapt.plan/1) from small parts. Lengths are millimetres.

>>> plan = Plan(Ring("generic-classic", size_mm=38), PapillaryApproximation("posteromedial", suture_length_mm=24))
>>> plan.to_json()["steps"][0]
{'step': 'annuloplasty', 'shape': 'generic-classic', 'size_mm': 38}

Each part knows its JSON; what a valve allows (which chordae there are, how short a suture may be) the service checks.
"""

from __future__ import annotations

import dataclasses
import json
import pathlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal, TypeAlias

from .errors import BadDocument
from .files import Path, did_you_mean, read_plan_entries

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
class DesignedRing:
    """A ring of a shape of one's own: ring is the "ring" of a coapt.ring/1 document, size_mm its width, 24 to 40 in steps of 2."""

    ring: Mapping[str, Any]
    size_mm: float
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": "designed", "ring": dict(self.ring), "size_mm": self.size_mm}


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


@dataclass(frozen=True)
class EdgeToEdge:
    """Opposite points of both free edges held together, width_mm (2 to 15) along them: by a stitch (Alfieri) or a clip."""

    device: Literal["stitch", "clip"] = "clip"
    along: float = 0.5
    width_mm: float = 4.0
    step: ClassVar[str] = "edge_to_edge"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "device": self.device, "along": self.along, "width_mm": self.width_mm}


@dataclass(frozen=True)
class TriangularResection:
    """A wedge of a leaflet cut out, width_mm (3 to 20) at the free edge, that share of the height (0.3 to 0.95) towards the
    annulus."""

    width_mm: float
    along: float = 0.5
    leaflet: Literal["anterior", "posterior"] = "posterior"
    height: float = 0.7
    step: ClassVar[str] = "leaflet_resection"

    def to_json(self) -> dict[str, Any]:
        return {
            "step": self.step,
            "shape": "triangular",
            "leaflet": self.leaflet,
            "along": self.along,
            "width_mm": self.width_mm,
            "height": self.height,
        }


@dataclass(frozen=True)
class QuadrangularResection:
    """A strip of the posterior leaflet cut out, width_mm (3 to 30) from free edge to annulus. The rest slides over the
    annulus, or without sliding the annulus is gathered."""

    width_mm: float
    along: float = 0.5
    sliding: bool = True
    step: ClassVar[str] = "leaflet_resection"

    def to_json(self) -> dict[str, Any]:
        return {
            "step": self.step,
            "shape": "quadrangular",
            "along": self.along,
            "width_mm": self.width_mm,
            "sliding": self.sliding,
        }


Step: TypeAlias = (
    Ring
    | OwnRing
    | DesignedRing
    | Neochorda
    | ChordalLengthChange
    | ChordalExcision
    | ChordalTransfer
    | PapillaryApproximation
    | EdgeToEdge
    | TriangularResection
    | QuadrangularResection
)
_KINDS: dict[str, type[Step]] = {
    Ring.step: Ring,
    Neochorda.step: Neochorda,
    ChordalLengthChange.step: ChordalLengthChange,
    ChordalExcision.step: ChordalExcision,
    ChordalTransfer.step: ChordalTransfer,
    PapillaryApproximation.step: PapillaryApproximation,
    EdgeToEdge.step: EdgeToEdge,
    TriangularResection.step: TriangularResection,
}


def _made(kind: Any, json: Any) -> Any:
    """A part from its fields. Their values are checked by the service.

    :raises BadDocument: one is unknown or missing
    """
    if not isinstance(json, Mapping):
        raise BadDocument(f"no step of coapt.plan/1: {kind.__name__} cannot be {json!r}")
    needed = {one.name: one.default is dataclasses.MISSING for one in dataclasses.fields(kind)}
    wrong = [f'has no field "{name}"{did_you_mean(name, needed)}' for name in json if name not in needed]
    wrong += [f'needs "{name}"' for name in needed if needed[name] and name not in json]
    if wrong:
        raise BadDocument(f"no step of coapt.plan/1: {kind.__name__} {', '.join(wrong)}")
    return kind(**json)


def step_from_json(json: Mapping[str, Any]) -> Step:
    """:raises BadDocument: it is no step of coapt.plan/1"""
    fields = {name: value for name, value in json.items() if name != "step"}
    name = json.get("step")
    if name not in _KINDS:
        known = ", ".join(_KINDS)
        raise BadDocument(
            f'no step of coapt.plan/1: "step" is {name!r}, must be one of {known}{did_you_mean(str(name), _KINDS)}'
        )
    if "insertion" in fields:
        fields["insertion"] = _made(LeafletPoint, fields["insertion"])
    if name == Ring.step and fields.get("shape") == "own":
        del fields["shape"]
        step: Step = _made(OwnRing, fields)
    elif name == Ring.step and fields.get("shape") == "designed":
        del fields["shape"]
        step = _made(DesignedRing, fields)
    elif name == TriangularResection.step:
        shape = fields.pop("shape", None)
        if shape not in ("triangular", "quadrangular"):
            raise BadDocument(f'no step of coapt.plan/1: "shape" is {shape!r}, must be triangular or quadrangular')
        step = _made(TriangularResection if shape == "triangular" else QuadrangularResection, fields)
    else:
        step = _made(_KINDS[name], fields)
    return step


class Plan:
    """Steps of a repair; their order does not change the result. Plan() is the valve as it is.

    >>> ring = Plan(OwnRing(2))
    >>> ring.with_step(Neochorda("AL1", LeafletPoint("posterior", along=0.5), length_mm=20))
    Plan(OwnRing(sizes_below=2), Neochorda(head='AL1', insertion=LeafletPoint(leaflet='posterior', along=0.5, height=1.0), length_mm=20))
    >>> Plan.from_json(ring.to_json()) == ring
    True
    """

    def __init__(self, *steps: Step) -> None:
        self.steps: tuple[Step, ...] = steps

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Plan:
        """:raises BadDocument: it is no coapt.plan/1"""
        if (
            not isinstance(json, Mapping)
            or json.get("schema") != "coapt.plan/1"
            or not isinstance(json.get("steps"), list)
        ):
            raise BadDocument('no coapt.plan/1: "schema" and "steps" are needed')
        return cls(*map(step_from_json, json["steps"]))

    @classmethod
    def read(cls, path: Path) -> Plan:
        """The plan of a file, the first of several.

        :raises NoSuchFile, BadDocument: it holds none
        """
        return read_plans(path)[0].plan

    def to_json(self) -> dict[str, Any]:
        """coapt.plan/1, as the service and `coapt close --plan` read it."""
        return {"schema": "coapt.plan/1", "steps": [step.to_json() for step in self.steps]}

    def write(self, path: Path) -> None:
        """To a file, as Plan.read() and `coapt close --plan` read it."""
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


@dataclass(frozen=True)
class NamedPlan:
    """A plan of a file."""

    name: str
    plan: Plan


def read_plans(path: Path) -> list[NamedPlan]:
    """Every plan of a file, in its order: a coapt.plan/1, what `coapt plan --json` prints, or the page's saved plans.

    >>> [one.name for one in read_plans("examples/plans/mixed.json")]
    ['mixed']

    :raises NoSuchFile, BadDocument: it holds none
    """

    def read(name: str, plan: Any) -> NamedPlan:
        try:
            return NamedPlan(name, Plan.from_json(plan))
        except BadDocument as error:
            raise BadDocument(f"{path}: {name}: {error}") from error

    return [read(name, plan) for name, plan in read_plan_entries(path)]
