"""Steps of repair plans, each with its JSON in coapt.plan/1. Lengths are millimetres.

What a valve allows (which chordae there are, how short a suture may be) is checked where the plan is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, TypeAlias

Side = Literal["anterolateral", "posteromedial"]
Anchor = Literal["ipsilateral_trigone", "saddle_peak", "annulus_point"]


@dataclass(frozen=True)
class LeafletPoint:
    """A place on a leaflet. along: 0 at the anterolateral, 1 at the posteromedial commissure. height: 0 at the annulus, 1 at
    the free edge.

    >>> LeafletPoint("posterior", along=0.5).to_json()
    {'leaflet': 'posterior', 'along': 0.5, 'height': 1.0}
    """

    leaflet: Literal["anterior", "posterior"]
    along: float
    height: float = 1.0

    def to_json(self) -> dict[str, Any]:
        return {"leaflet": self.leaflet, "along": self.along, "height": self.height}


@dataclass(frozen=True)
class Ring:
    """An annuloplasty ring of the catalogue (Client.rings()). size_mm: its label, the transverse width, 24 to 40 in steps of
    2.

    >>> coapt.preset("human-functional-mr").close(Plan(Ring("generic-classic", size_mm=30))).trusted
    True
    """

    shape: str
    size_mm: float
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": self.shape, "size_mm": self.size_mm}


@dataclass(frozen=True)
class DesignedRing:
    """A ring of a shape of one's own: ring is the "ring" of a coapt.ring/1 document, size_mm its width, 24 to 40 in steps of 2.

    >>> DesignedRing({"name": "mine"}, size_mm=30).to_json()["size_mm"]
    30
    """

    ring: Mapping[str, Any] = field(hash=False)
    size_mm: float
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": "designed", "ring": dict(self.ring), "size_mm": self.size_mm}


@dataclass(frozen=True)
class OwnRing:
    """A ring of the valve's own shape, sizes_below (0 to 6) sizes of 2 mm transverse smaller.

    >>> coapt.preset("human-functional-mr").close(Plan(OwnRing(2))).trusted
    True
    """

    sizes_below: int
    step: ClassVar[str] = "annuloplasty"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "shape": "own", "sizes_below": self.sizes_below}


@dataclass(frozen=True)
class Neochorda:
    """A new chorda of length_mm (5 to 40) from a papillary head, by its id in the valve, to a leaflet.

    >>> torn = coapt.preset("human-p2-prolapse")
    >>> held = torn.close(Plan(Neochorda("AL1", LeafletPoint("posterior", along=0.5), length_mm=20)))
    >>> held.measure.leak_mm2 < torn.close().measure.leak_mm2
    True
    """

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
    """A chorda's trunk made longer by change_mm (-20 to 20); negative shortens.

    >>> valve = coapt.preset("human-p2-prolapse")
    >>> valve.close(Plan(ChordalLengthChange(valve.chordae[0]["id"], change_mm=-2))).trusted
    True
    """

    chorda: str
    change_mm: float
    step: ClassVar[str] = "chordal_length_change"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "chorda": self.chorda, "change_mm": self.change_mm}


@dataclass(frozen=True)
class ChordalExcision:
    """A chorda cut away.

    >>> valve = coapt.preset("human-normal")
    >>> strut = next(one["id"] for one in valve.chordae if one["kind"] == "strut")
    >>> closure = valve.close(Plan(ChordalExcision(strut)))
    >>> float(dict(zip(closure.chordae, closure.tension_n))[strut])
    0.0
    """

    chorda: str
    step: ClassVar[str] = "chordal_excision"

    def to_json(self) -> dict[str, Any]:
        return {"step": self.step, "chorda": self.chorda}


@dataclass(frozen=True)
class ChordalTransfer:
    """A chorda moved to another place of a leaflet.

    >>> ChordalTransfer("c1", LeafletPoint("anterior", along=0.5)).to_json()["step"]
    'chordal_transfer'
    """

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

    >>> suture = PapillaryApproximation("posteromedial", suture_length_mm=24, anchor="saddle_peak")
    >>> coapt.preset("human-functional-mr").close(Plan(suture)).trusted
    True
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
    """Opposite points of both free edges held together, width_mm (2 to 15) along them: by a stitch (Alfieri) or a clip;
    or the two edges of a cleft of the posterior leaflet ("cleft_suture"), width_mm from its root at along.

    Of a clip alone: grasp_mm (2 to 12) of each leaflet between the arms, rows (1 to 5) of ties over that, and by how many per
    cent (0 to 25) it draws the annulus in from front to back.

    >>> clipped = coapt.preset("human-functional-mr").open(Plan(EdgeToEdge()))
    >>> len(clipped.leak.openings)
    2
    """

    device: Literal["stitch", "clip", "cleft_suture"] = "clip"
    along: float = 0.5
    width_mm: float = 4.0
    grasp_mm: float = 5.0
    rows: int = 2
    annulus_drawn_in_percent: float = 11.0
    step: ClassVar[str] = "edge_to_edge"

    def to_json(self) -> dict[str, Any]:
        json: dict[str, Any] = {
            "step": self.step,
            "device": self.device,
            "along": self.along,
            "width_mm": self.width_mm,
        }
        if self.device == "clip":
            json |= {
                "grasp_mm": self.grasp_mm,
                "rows": self.rows,
                "annulus_drawn_in_percent": self.annulus_drawn_in_percent,
            }
        return json


@dataclass(frozen=True)
class TriangularResection:
    """A wedge of a leaflet cut out, width_mm (3 to 20) at the free edge, that share of the height (0.3 to 0.95) towards the
    annulus.

    >>> TriangularResection(width_mm=10).to_json()["height"]
    0.7
    """

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
    annulus, or without sliding the annulus is gathered.

    >>> QuadrangularResection(width_mm=12, sliding=False).to_json()["sliding"]
    False
    """

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
