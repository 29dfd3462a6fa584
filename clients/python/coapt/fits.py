"""What an import as a job takes and finds: a valve, and a fit of it to its closed leaflets."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from . import tables
from .imports import packed
from .meshes import Picture
from .stored import ImportDecision
from .transport import Transport

Known = Literal["slack", "tips", "prestretch", "stiffness", "hidden"]


def fit_target(
    side: Literal["atrial", "middle"],
    leak_mm2: float | None,
    leak_sd_mm2: float | None,
    known: Iterable[Known],
    ruptured: bool,
    points: int | None,
    rounds: int | None,
) -> dict[str, Any]:
    """Fields of a request for a fit."""
    numbers = {"leak_mm2": leak_mm2, "leak_sd_mm2": leak_sd_mm2, "points": points, "rounds": rounds}
    asked = {name: value for name, value in numbers.items() if value is not None}
    return {"side": side, "known": list(known), "ruptured": ruptured} | asked


@dataclass(frozen=True)
class Fit:
    """To what a valve is fitted by Client.import_job().

    >>> Fit("systole.stl", leak_mm2=35.0, known=["prestretch"]).leak_mm2
    35.0
    """

    surface: str | os.PathLike[str] | Any | None = None
    """The closed leaflets as imaged, a mesh or points (CSV), in the coordinates and the unit of the other files; None: the leaflets
    themselves, imported with closed=True."""
    side: Literal["atrial", "middle"] = "atrial"
    """Surface of the leaflets that was imaged."""
    leak_mm2: float | None = None
    """As imaged."""
    leak_sd_mm2: float | None = None
    """Standard deviation of leak_mm2."""
    known: Sequence[Known] = ()
    """Parameters that are not fitted."""
    points: int | None = None
    """Of the surface, at most."""
    rounds: int | None = None
    """Of either pass, at most."""

    def to_json(self) -> dict[str, Any]:
        asked = {name: getattr(self, name) for name in ("leak_mm2", "leak_sd_mm2", "points", "rounds")}
        request: dict[str, Any] = {"side": self.side} | {k: v for k, v in asked.items() if v is not None}
        if self.surface is not None:
            request["surface"] = packed(self.surface)
        if self.known:
            request["known"] = list(self.known)
        return request


@dataclass(frozen=True, repr=False)
class FittedParameter(tables.Short):
    """One parameter of a fit.

    >>> coapt.FittedParameter("slack", "1", value=1.02, sd=0.01, prior=1.0, prior_sd=0.05, identifiable=True).value
    1.02
    """

    name: str
    unit: str
    """"mm", or "1" for none."""
    value: float
    """As fitted, in that unit."""
    sd: float
    """Standard deviation of it."""
    prior: float
    """Prior value."""
    prior_sd: float
    identifiable: bool
    """Whether the surface at least halves the prior uncertainty."""


@dataclass(frozen=True, repr=False)
class FitResult(tables.Short):
    """Result of a fit.

    >>> valve = coapt.preset("porcine-1")
    >>> fitted, told = valve.fit(valve.close().closed_mm, side="middle", points=200, rounds=1)
    >>> told.rms_mm < 0.3
    True
    """

    rms_before_mm: float
    """Distance from the surface, root mean square, of the valve as it was."""
    rms_mm: float
    """The same of the fitted one."""
    leak_before_mm2: float
    leak_mm2: float
    leak_sd_mm2: float
    """Standard deviation of the fitted valve's leak."""
    parameters: tuple[FittedParameter, ...]
    finished: bool
    """False: the fit was stopped before convergence."""
    json: Mapping[str, Any] = field(repr=False, compare=False)
    """The whole of it, with the correlations; of Engine.fit() and Service.fit_job() also the valve, "fitted"."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any], transport: Transport | None = None, job_path: str = "") -> FitResult:
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


@dataclass(frozen=True, repr=False)
class ImportResult(tables.Short):
    """Result of an import.

    >>> folder = "examples/valves/source/bodyparts3d"
    >>> leaflets = [f"{folder}/{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
    >>> made = client.import_job(leaflets, f"{folder}/annulus_centerline.csv", f"{folder}/chordae.csv").result()
    >>> made.fit is None, any(decision.subject == "units" for decision in made.decisions)
    (True, True)
    """

    valve: str
    """Id of the stored valve, fitted if that was asked for."""
    imported: str
    """Id of the one before the fit."""
    name: str
    triangles: int
    chordae: int
    decisions: tuple[ImportDecision, ...]
    """Decisions on what the files leave open."""
    fit: FitResult | None
    """None: not asked for."""
    json: Mapping[str, Any] = field(repr=False, compare=False)
    _transport: Transport = field(repr=False, compare=False)
    _path: str = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Mapping[str, Any], transport: Transport, job_path: str) -> ImportResult:
        decisions = tuple(ImportDecision(**one) for one in json["decisions"])
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
        """Picture of the input beside the resulting valve; a notebook shows it.

        >>> imports = client.jobs("SUCCEEDED")
        >>> [one.result().picture().write("import.png") for one in imports if one.kind == "import"][:1]
        [...]
        """
        return Picture(self._transport.request("GET", f"{self._path}/files/import.png").body)
