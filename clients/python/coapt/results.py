"""What is answered, as small typed objects. Each keeps the whole document in json.

A unit is the last part of a name (mm, mm2, n: newtons, deg); None: not known, because too little was closed or a closure flew
apart. Areas are anatomic, from geometry: not an effective regurgitant orifice area.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from . import frames, tables
from .errors import CoaptError
from .evidence import Coaptation, LeakMap, LeakMaps, Remodelling
from .meshes import Mesh, Picture
from .repair import Plan
from .transport import Transport

if TYPE_CHECKING:
    import pandas

Status = Literal["converged", "step_limit", "diverged"]
Document = Mapping[str, Any]
MeshFormat = Literal["ply", "obj", "stl", "vtk"]


def known_fields(kind: Any, json: Document) -> dict[str, Any]:
    """Those of a dataclass: a later service may say more."""
    return {one.name: json[one.name] for one in fields(kind)}


@dataclass(frozen=True)
class Measure:
    """A closed valve, measured.

    leak_mm2: the larger of orifice (what the view from the atrium shows) and gap (the opening between the leaflets in three
    dimensions). Errors are numerical (mesh, stopping early, other equilibria), kept by nine of ten measured valves; None of a
    closure that is not to be trusted. Coaptation heights over nine sections. Tenting is below 0 where leaflets billow. Strains are the 99th
    percentile over triangles, as shares.
    """

    leak_mm2: float | None
    leak_mm2_error: float | None
    orifice_area_mm2: float | None
    orifice_area_mm2_error: float | None
    gap_area_mm2: float | None
    gap_area_mm2_error: float | None
    coaptation_height_mean_mm: float | None
    coaptation_height_min_mm: float | None
    annulus_ap_mm: float | None
    annulus_al_pm_mm: float | None
    tenting_height_mm: float | None
    tension_max_n: float | None
    tension_sum_n: float | None
    strain_circumferential_max: float | None
    strain_radial_max: float | None
    _document: Callable[[], Document] = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document) -> Measure:
        coaptation, annulus = json["coaptation"], json["annulus"]
        return cls(
            json["leak_mm2"],
            json["leak_mm2_error"],
            json["orifice_area_mm2"],
            json["orifice_area_mm2_error"],
            coaptation["gap_area_mm2"],
            coaptation["gap_area_mm2_error"],
            coaptation["height_mean_mm"],
            coaptation["height_min_mm"],
            annulus["ap_mm"],
            annulus["al_pm_mm"],
            json["tenting_height_mm"],
            json["tension_max_n"],
            json["tension_sum_n"],
            json["strain_circumferential_max"],
            json["strain_radial_max"],
            lambda: json,
        )

    @cached_property
    def json(self) -> Document:
        """The whole of it."""
        return self._document()

    @property
    def coaptation(self) -> Coaptation:
        return Coaptation.from_json(self.json["coaptation"])


@dataclass(frozen=True)
class Closure:
    """A valve, closed (coapt.closure/1). valve is its name; residual the rms free force over the rms pressure force."""

    valve: str
    status: Status
    crossing: bool
    residual: float | None
    steps: int
    seconds: float
    measure: Measure
    warnings: tuple[str, ...]
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
            lambda: json,
            leaflets,
        )

    @cached_property
    def json(self) -> Document:
        """The coapt.closure/1."""
        return self._document()

    def leaflets(self) -> Mesh:
        """The closed, repaired leaflets, vertices in the order of the valve's. Of the engine in this process its own numbers,
        read-only, not copied; of a service asked for now, to the digits of its PLY file."""
        if self._leaflets is None:
            raise CoaptError("only closures of close(), close_many() and map() have leaflets")
        return self._leaflets()

    @property
    def closed_mm(self) -> Any:
        """V x 3, float64: leaflets().vertices_mm."""
        return self.leaflets().vertices_mm

    @property
    def trusted(self) -> bool:
        """Whether the figures count: it converged, and no leaflet passes through another."""
        return self.status == "converged" and not self.crossing

    def _repr_html_(self) -> str:
        return tables.closure_html(self)


@dataclass(frozen=True)
class Statistics:
    """mm2 over a plan's region of interest: its errors of suture length and papillary position. nominal: as planned; p95: 95th
    percentile; below_N: share of the region below N mm2."""

    nominal: float | None
    mean: float | None
    sd: float | None
    worst: float | None
    p95: float | None
    below_5: float | None
    below_10: float | None
    below_20: float | None

    @classmethod
    def from_json(cls, json: Document) -> Statistics:
        return cls(**known_fields(cls, json))


@dataclass(frozen=True)
class _Place:
    """Where a plan of a job is."""

    transport: Transport
    path: str


@dataclass(frozen=True)
class RankedPlan:
    """A plan with its evidence. rank 1 is the best; description is in surgical words, a line a step; cost is in mm2, lower is
    better. margin_mm and margin_deg: how much shorter or longer a suture, how far off a tip may be before it leaks.
    opening_area_mm2 and gradient_mmhg: in diastole, at rest; durability_mm: further disease until it leaks 5 mm2, 12 at most; None
    where that was not asked for. The rest (gates, Sobol indices) is in json.
    """

    rank: int
    plan: Plan
    description: tuple[str, ...]
    leak_mm2: Statistics
    orifice_area_mm2: Statistics
    cost: float | None
    status: Status
    crossing: bool
    measure: Measure
    region_closures: int
    region_failures: int
    margin_mm: float | None
    margin_deg: float | None
    pareto: bool
    tie_with_next: bool
    warnings: tuple[str, ...]
    opening_area_mm2: float | None
    gradient_mmhg: float | None
    durability_mm: float | None
    json: Document = field(repr=False, compare=False)
    _place: _Place | None = field(default=None, repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document, transport: Transport | None = None, job_path: str = "") -> RankedPlan:
        margin = json["margin_to_leak"]
        place = _Place(transport, f"{job_path}/plans/{json['rank']}") if transport else None
        return cls(
            json["rank"],
            Plan.from_json(json["plan"]),
            tuple(json["description"]),
            Statistics.from_json(json["leak_mm2"]),
            Statistics.from_json(json["orifice_area_mm2"]),
            json["cost"],
            json["status"],
            json["crossing"],
            Measure.from_json(json["measure"]),
            json["region_closures"],
            json["region_failures"],
            margin["suture_length_mm"],
            margin["angle_deg"],
            json["pareto"],
            json["tie_with_next"],
            tuple(json["warnings"]),
            json.get("opening_area_mm2"),
            json.get("gradient_mmhg"),
            json.get("durability_mm"),
            json,
            place,
        )

    @property
    def closes_robustly(self) -> bool:
        """All closures of its region converged uncrossed, mean + sd of the leak are below 1 mm2, and so is the leak on the
        refined mesh."""
        mean, sd = self.leak_mm2.mean, self.leak_mm2.sd
        return (
            bool(self.json.get("closes_robustly", True))
            and self.status == "converged"
            and not self.crossing
            and self.region_failures == 0
            and self.region_closures > 1
            and mean is not None
            and sd is not None
            and mean + sd < 1.0
        )

    @property
    def leak_maps(self) -> LeakMaps:
        return LeakMaps(tuple(map(LeakMap.from_json, self.json["leak_map"])))

    @property
    def remodelling(self) -> Remodelling:
        return Remodelling.from_json(self.json["remodelling"])

    def picture(self) -> Picture:
        """The view from the atrium, before and after (PNG)."""
        return Picture(self._get("/picture"))

    def mesh(self, format: MeshFormat = "ply") -> bytes:
        """A file of the closed, repaired leaflets: millimetres, frame of the valve."""
        return self._get("/mesh", {"format": format})

    def leaflets(self) -> Mesh:
        """The same as numbers."""
        return Mesh.from_ply(self.mesh("ply"))

    def report(self) -> str:
        """A page about this plan: HTML that stands alone."""
        return self._get("/report").decode()

    def _get(self, what: str, query: Document | None = None) -> bytes:
        if self._place is None:
            raise CoaptError("only the plans of a search have pictures, meshes and reports: see Client.search()")
        return self._place.transport.request("GET", self._place.path + what, query=query).body

    def _repr_html_(self) -> str:
        picture = self.picture() if self._place else None
        return tables.plan_html(self, picture)


@dataclass(frozen=True)
class Before:
    """The valve as it is."""

    status: Status
    crossing: bool
    measure: Measure

    @classmethod
    def from_json(cls, json: Document) -> Before:
        return cls(json["status"], json["crossing"], Measure.from_json(json))


@dataclass(frozen=True)
class Evaluations:
    """Plans of one's own, in the order asked, each with its rank."""

    before: Before
    plans: tuple[RankedPlan, ...]
    closures: int
    seconds: float
    json: Document = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document) -> Evaluations:
        return cls(
            Before.from_json(json["before"]),
            tuple(map(RankedPlan.from_json, json["plans"])),
            json["closures"],
            json["seconds"],
            json,
        )

    def to_frame(self) -> pandas.DataFrame:
        """A row a plan; its last column is the coapt.plan/1 as JSON. Figures are as planned but those with mean_, sd_, p95_ and
        worst_, which are over the region of interest."""
        return frames.plans(self.plans)

    def _repr_html_(self) -> str:
        return tables.plans_html(self.before, self.plans)


@dataclass(frozen=True)
class SearchResult:
    """Ranked plans, best first (coapt.plans/1). any_competent: one of them closes the valve robustly. stop: why the search
    ended (evaluation_limit, exhausted, no_improvement, target_reached, time_limit, cancelled)."""

    before: Before
    plans: tuple[RankedPlan, ...]
    any_competent: bool
    stop: str
    closures: int
    seconds: float
    json: Document = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document, transport: Transport, job_path: str) -> SearchResult:
        plans = tuple(RankedPlan.from_json(plan, transport, job_path) for plan in json["plans"])
        return cls(
            Before.from_json(json["before"]),
            plans,
            json["any_competent"],
            json["stop"],
            json["closures"],
            json["seconds"],
            json,
        )

    def to_frame(self) -> pandas.DataFrame:
        """A row a plan; its last column is the coapt.plan/1 as JSON. Figures are as planned but those with mean_, sd_, p95_ and
        worst_, which are over the region of interest."""
        return frames.plans(self.plans)

    def _repr_html_(self) -> str:
        return tables.plans_html(self.before, self.plans)


@dataclass(frozen=True)
class Finding:
    """A finding of the thesis (section of it) beside this valve's, and by what they were judged to agree."""

    finding: str
    section: str
    thesis: str
    ours: str
    judged: str
    agrees: bool


@dataclass(frozen=True)
class StudyResult:
    """A study's findings. untrusted: not converged, or crossed."""

    study: str
    valve: str
    configurations: int
    closures: int
    untrusted: int
    seconds: float
    findings: tuple[Finding, ...]
    json: Document = field(repr=False, compare=False)

    @classmethod
    def from_json(cls, json: Document, transport: Transport, job_path: str) -> StudyResult:
        return cls(
            json["study"],
            json["valve"],
            json["configurations"],
            json["closures"],
            json["untrusted"],
            json["seconds"],
            tuple(Finding(**known_fields(Finding, finding)) for finding in json["findings"]),
            json,
        )

    def to_frame(self) -> pandas.DataFrame:
        """A row a finding."""
        return frames.findings(self.findings)

    def _repr_html_(self) -> str:
        return tables.findings_html(self)
