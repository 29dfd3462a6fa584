"""A valve in diastole, as a small typed object. It keeps the whole document in json."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from . import tables
from .results import Document, Status, known_fields


@dataclass(frozen=True)
class Opening:
    """A valve, opened (coapt.opening/1). name is the valve's; None: not known, because it did not come to rest.

    opening_area_mm2: of the narrowest passage of the open leaflets, passage_depth_mm below the annulus; funnel_tilt_deg: of their
    axis from the annulus's normal. projected_area_mm2: open along that normal. annulus_area_mm2: in diastole. Gradients are
    mean ones by Gorlin's equation, of the smaller area, at flow_ml_s and flow_exercise_ml_s.
    """

    name: str
    status: Status
    crossing: bool
    opening_area_mm2: float | None
    passage_depth_mm: float | None
    funnel_tilt_deg: float | None
    projected_area_mm2: float | None
    annulus_area_mm2: float
    gradient_mmhg: float | None
    gradient_exercise_mmhg: float | None
    flow_ml_s: float
    flow_exercise_ml_s: float
    pressure_mmhg: float
    steps: int
    seconds: float
    warnings: tuple[str, ...]
    json: Document = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document) -> Opening:
        return cls(**known_fields(cls, {**json, "warnings": tuple(json["warnings"]), "json": json}))

    @property
    def trusted(self) -> bool:
        """Whether the figures count: it came to rest, and no leaflet passes through another."""
        return self.status == "converged" and not self.crossing

    @property
    def scene(self) -> Mapping[str, Any]:
        """All that is drawn of it: open_mm, faces, annulus_mm, heads, chordae, passage_mm (the outline of the narrowest
        passage), motion_mm. Lists of points are flat: x, y, z, x, y, z, ..."""
        scene: Mapping[str, Any] = self.json["scene"]
        return scene

    def _repr_html_(self) -> str:
        return tables.opening_html(self)
