"""A valve in diastole, as a small typed object. It keeps the whole document in json."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from . import tables
from .closures import Document, Status, known_fields
from .leaks import Leak


@dataclass(frozen=True, repr=False)
class Opening(tables.Short):
    """A valve, opened (coapt.opening/2). None: not known, because it did not come to rest.

    >>> opening = coapt.preset("human-normal").open()
    >>> opening.trusted, opening.opening_area_mm2 < opening.annulus_area_mm2, round(opening.flow_ml_s)
    (True, True, 151)
    """

    name: str
    """The valve's."""
    status: Status
    """"converged" (in equilibrium), "step_limit" (not yet) or "diverged" (without a shape)."""
    crossing: bool
    """Whether leaflets cross, in which case nothing is measured."""
    opening_area_mm2: float | None
    """Of leak."""
    leak: Leak
    """The smallest surface between atrium and ventricle, with its openings: two or more with a clip."""
    projected_area_mm2: float | None
    """Projected along the annular normal."""
    annulus_area_mm2: float
    """Of the annulus in diastole."""
    gradient_mmhg: float | None
    """Mean gradient at flow_ml_s, by Bernoulli's equation over the filling pulse."""
    gradient_exercise_mmhg: float | None
    """The same at flow_exercise_ml_s."""
    flow_ml_s: float
    """Mean filling flow at rest."""
    flow_exercise_ml_s: float
    """Mean filling flow at exercise."""
    pressure_mmhg: float
    """Peak atrioventricular pressure difference during filling."""
    steps: int
    """Of the relaxation."""
    seconds: float
    """Computing time of the opening."""
    warnings: tuple[str, ...]
    """In sentences."""
    json: Document = field(repr=False, compare=False)
    """The coapt.opening/2."""

    @classmethod
    def from_json(cls, json: Document) -> Opening:
        read = {"warnings": tuple(json["warnings"]), "leak": Leak.from_json(json["leak"]), "json": json}
        return cls(**known_fields(cls, {**json, **read}))

    @property
    def trusted(self) -> bool:
        """Whether the results are reliable: equilibrium was reached and leaflets do not cross.

        >>> valve.open().trusted
        True
        """
        return self.status == "converged" and not self.crossing

    @property
    def scene(self) -> Mapping[str, Any]:
        """All that is drawn of it: open_mm, faces, annulus_mm, heads, chordae, leak (a surface for each opening: points_mm,
        faces, outline), motion_mm. Lists of points are flat: x, y, z, x, y, z, ...

        >>> len(valve.open().scene["open_mm"]) == 3 * len(valve.vertices_mm)
        True
        """
        scene: Mapping[str, Any] = self.json["scene"]
        return scene

    def _repr_html_(self) -> str:
        warned = "" if self.trusted else "<p><b>These results are unreliable.</b></p>"
        number = tables.number
        rows = [
            ("opening", f"<b>{_cm2(self.opening_area_mm2)}</b>"),
            ("projected along the annular normal", _cm2(self.projected_area_mm2)),
            ("annulus in diastole", _cm2(self.annulus_area_mm2)),
            ("mean gradient", f"{number(self.gradient_mmhg)} mmHg at {number(self.flow_ml_s, 0)} ml/s"),
            ("at exercise", f"{number(self.gradient_exercise_mmhg)} mmHg at {number(self.flow_exercise_ml_s, 0)} ml/s"),
        ]
        return (
            f"<h4>{tables.escaped(f'{self.name}, open: {tables.state(self.status, self.crossing)}')}</h4>{warned}"
            f"{tables.table((), rows)}<p>{tables.listed(self.warnings, '! ')}</p>{tables.NOTICE_HTML}"
        )


def _cm2(mm2: float | None) -> str:
    return f"{tables.number(None if mm2 is None else 0.01 * mm2)} cm²"
