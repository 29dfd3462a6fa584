"""What the service keeps or knows by name: valves, plans, rings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .repair import Plan


@dataclass(frozen=True)
class ImportDecision:
    """What an import settled that its files leave open, with the reason ("" where there is none to give). look: a person
    should check it against the images."""

    about: str
    decision: str
    reason: str
    look: bool = False


@dataclass(frozen=True)
class StoredValve:
    """name is that of its document; chordae is None in a list, which does not count them; decisions are those of its
    import."""

    id: str
    name: str
    vertices: int
    triangles: int
    chordae: int | None = None
    decisions: tuple[ImportDecision, ...] = ()


@dataclass(frozen=True)
class KeptPlan:
    """A plan under a name. valve: the id or the preset's name that it was kept for."""

    id: str
    name: str
    valve: str
    plan: Plan

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> KeptPlan:
        return cls(json["kept_plan"], json["name"], json["valve"], Plan.from_json(json["plan"]))


@dataclass(frozen=True)
class RingShape:
    """Widths are shares of the labelled transverse size; transverse_factor: true transverse width over the label."""

    name: str
    ap_over_transverse: float
    transverse_factor: float
    saddle_over_transverse: float
    note: str
