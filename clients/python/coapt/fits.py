"""What an import as a job takes and finds: a valve, and a fit of it to its closed leaflets."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from .imports import packed
from .meshes import Picture
from .stored import ImportDecision
from .transport import Transport

Known = Literal["slack", "tips", "prestretch", "hidden"]


@dataclass(frozen=True)
class Fit:
    """To what a valve is fitted.

    surface: the closed leaflets as imaged, a mesh or points (CSV), in the coordinates and the unit of the other files; None:
    the leaflets themselves, imported with closed=True. side: what of them it shows. leak_mm2: as imaged, known to within
    leak_sd_mm2. known: what stays as it is. points, rounds: of the surface, and of either pass, at most.
    """

    surface: str | os.PathLike[str] | None = None
    side: Literal["atrial", "middle"] = "atrial"
    leak_mm2: float | None = None
    leak_sd_mm2: float | None = None
    known: Sequence[Known] = ()
    points: int | None = None
    rounds: int | None = None

    def to_json(self) -> dict[str, Any]:
        asked = {name: getattr(self, name) for name in ("leak_mm2", "leak_sd_mm2", "points", "rounds")}
        request: dict[str, Any] = {"side": self.side} | {k: v for k, v in asked.items() if v is not None}
        if self.surface is not None:
            request["surface"] = packed(self.surface)
        if self.known:
            request["known"] = list(self.known)
        return request


@dataclass(frozen=True)
class FittedParameter:
    """One unknown of a fit, in mm or without a unit ("1"); identifiable: the surface at least halves what was not known."""

    name: str
    unit: str
    value: float
    sd: float
    prior: float
    prior_sd: float
    identifiable: bool


@dataclass(frozen=True)
class FitResult:
    """Distances from the surface in mm, root mean square, before and after; the leak with its standard deviation after. Not
    finished: it was stopped before it came to rest. json has the correlations."""

    rms_before_mm: float
    rms_mm: float
    leak_before_mm2: float
    leak_mm2: float
    leak_sd_mm2: float
    parameters: tuple[FittedParameter, ...]
    finished: bool
    json: Mapping[str, Any] = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> FitResult:
        names = FittedParameter.__dataclass_fields__
        parameters = tuple(FittedParameter(**{name: one[name] for name in names}) for one in json["parameters"])
        leak = json["leak_mm2"]
        return cls(
            json["rms_before_mm"],
            json["rms_mm"],
            leak["before"],
            leak["fitted"],
            leak["sd"],
            parameters,
            json["finished"],
            json,
        )


@dataclass(frozen=True)
class ImportResult:
    """valve: id of the one made, fitted if that was asked for; imported: id before the fit."""

    valve: str
    imported: str
    name: str
    triangles: int
    chordae: int
    decisions: tuple[ImportDecision, ...]
    fit: FitResult | None
    json: Mapping[str, Any] = field(repr=False, compare=False)
    _transport: Transport = field(repr=False, compare=False)
    _path: str = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Mapping[str, Any], transport: Transport, job_path: str) -> ImportResult:
        decisions = tuple(ImportDecision(one["about"], one["decision"], one["reason"]) for one in json["decisions"])
        fit = None if json["fit"] is None else FitResult.from_json(json["fit"])
        return cls(
            json["valve"],
            json["imported"],
            json["name"],
            json["triangles"],
            json["chordae"],
            decisions,
            fit,
            json,
            transport,
            job_path,
        )

    def picture(self) -> Picture:
        """What was given beside the valve made of it; a notebook shows it."""
        return Picture(self._transport.request("GET", f"{self._path}/files/import.png").body)
