"""What the service keeps or knows by name: valves, plans, rings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from . import tables
from .repair import Plan


@dataclass(frozen=True, repr=False)
class ImportDecision(tables.Short):
    """A decision of an import on what its files leave open.

    >>> ImportDecision("units", "millimetres", "the annulus is 32 wide").look
    False
    """

    subject: str
    """What, such as "units"."""
    value: str
    """In a sentence."""
    reason: str
    """The reason in a sentence; empty if there is none."""
    look: bool = False
    """Whether a person should check it against the images."""
    confidence: float = 1.0
    """Probability that the decision is correct, if inferred from several measurements; otherwise 1."""


@dataclass(frozen=True, repr=False)
class StoredValve(tables.Short):
    """A valve that a service or an engine keeps.

    >>> stored = client.put_valve("examples/valves/bodyparts3d-leaking.json")
    >>> stored.id in [valve.id for valve in client.valves()]
    True
    """

    id: str
    """SHA-256 of its content: the same valve has the same."""
    name: str
    """Of its document."""
    vertices: int
    triangles: int
    chordae: int | None = None
    """None in a list, which does not count them."""
    decisions: tuple[ImportDecision, ...] = ()
    """Of its import."""


@dataclass(frozen=True, repr=False)
class KeptPlan(tables.Short):
    """A plan under a name.

    >>> kept = client.keep_plan("human-functional-mr", Plan(OwnRing(2)), "own ring")
    >>> client.close(kept.valve, kept).trusted
    True
    >>> client.delete_kept_plan(kept.id)
    """

    id: str
    name: str
    valve: str
    """The id or the preset's name that it was kept for."""
    plan: Plan

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> KeptPlan:
        return cls(json["kept_plan"], json["name"], json["valve"], Plan.from_json(json["plan"]))


@dataclass(frozen=True, repr=False)
class RingShape(tables.Short):
    """A ring of the catalogue.

    >>> [ring.name for ring in client.rings()]
    ['generic-classic', 'generic-etlogix-like', 'generic-geoform-like']
    """

    name: str
    """As Ring() takes it."""
    ap_over_transverse: float
    """Anteroposterior width, as a share of the labelled transverse size."""
    transverse_factor: float
    """True transverse width over the label."""
    saddle_over_transverse: float
    """Height of the saddle, as a share of the label."""
    note: str
    """What it stands for."""
