"""Repair plans with their evidence, as small typed objects. Each keeps the whole document in json; None: not known."""

from __future__ import annotations

import base64
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal

from . import frames, tables
from .closures import Document, Measure, Status, known_fields
from .errors import CoaptError
from .estimates import Estimate, interval_words
from .evidence import LeakMap, LeakMaps, Remodelling, Tolerance
from .meshes import Mesh, Picture
from .repair import Plan
from .transport import Transport

MeshFormat = Literal["ply", "obj", "stl", "vtk"]

COLUMNS = {
    "rank": "rank",
    "description": "description",
    "ranked_cost_mm2": "ranked_cost",
    "cost_mm2": "cost",
    "nodes": "region_closures",
    "failed_nodes": "region_failures",
    "mean_leak_mm2": "leak_mm2.mean",
    "sd_leak_mm2": "leak_mm2.sd",
    "p95_leak_mm2": "leak_mm2.p95",
    "worst_leak_mm2": "leak_mm2.worst",
    **frames.MEASURE,
    "margin_mm": "margin_mm",
    "margin_deg": "margin_deg",
    "status": "status",
    "crossing": "crossing",
    "pareto": "pareto",
    "tie_with_next": "tie_with_next",
    "closes_robustly": "closes_robustly",
    "plan": "plan",
}
"""Of a table of plans, and where their values are."""

_FARTHEST_MM, _FARTHEST_DEG = 1.0, 5.0  # borders of the region of interest: a margin there may be larger


@dataclass(frozen=True, repr=False)
class Statistics(tables.Short):
    """mm2 over a plan's region of interest: its errors of suture length (1 mm) and papillary position (5 degrees). None: fewer
    than two nodes of the region were closed.

    >>> best = coapt.preset("human-functional-mr").evaluate([Plan(OwnRing(2))]).plans[0]
    >>> best.leak_mm2.nominal == best.measure.leak_mm2, best.leak_mm2.sd  # of one node
    (True, None)
    """

    nominal: float | None
    """Leak as planned, measured. The other statistics are estimated."""
    mean: float | None
    sd: float | None
    worst: float | None
    p95: float | None
    """The 95th percentile."""
    below_5: float | None
    """Fraction of the region, 0 to 1, below 5 mm2."""
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


@dataclass(frozen=True, repr=False)
class RankedPlan(tables.Short):
    """A plan with its evidence.

    >>> best = coapt.preset("human-functional-mr").evaluate([Plan(OwnRing(2))]).plans[0]
    >>> best.rank, best.plan, best.status
    (1, Plan(OwnRing(sizes_below=2)), 'converged')
    """

    rank: int
    """1 is the best."""
    plan: Plan
    """Ready for close(), evaluate() and others."""
    description: tuple[str, ...]
    """Surgical description, one line per step."""
    leak_mm2: Statistics
    """Over the region of interest."""
    cost: float | None
    """In mm2, lower is better: what a search minimises, on the valve's own mesh and without durability. Plans are ranked by ranked_cost."""
    status: Status
    """Status of the planned closure."""
    crossing: bool
    """Whether leaflets cross in it."""
    measure: Measure
    """The valve with this plan as planned."""
    region_closures: int
    """Nodes of the region of interest that were closed, 1 to 1,089."""
    region_failures: int
    """Of them not converged, or with leaflets that cross."""
    margin_mm: float | None
    """Smallest error of suture length that causes a leak; 1.0 is the border of the region, so it may be larger."""
    margin_deg: float | None
    """Smallest error of the tips' angle that causes a leak; 5.0 is the border of the region, so it may be larger."""
    pareto: bool
    """Pareto-optimal among the reported plans in leak (mean + sd), opening and reserve."""
    tie_with_next: bool
    """Whether it is equivalent to the next plan (of one class)."""
    warnings: tuple[str, ...]
    """Warnings, in sentences: rules of practice, unreliable closures, and others."""
    opening_area_mm2: float | None
    """In diastole; None: not requested."""
    gradient_mmhg: float | None
    """Mean gradient in diastole, at rest; None: not requested."""
    durability_mm: float | None
    """Reserve against progression, at most 12; None: not requested."""
    json: Document = field(repr=False, compare=False)
    """The whole of it, with gates and Sobol indices."""
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
    def why_margin_unknown(self) -> str | None:
        """Why margin_mm or margin_deg is None, in words; None: both are known, or of files of release 0.2.

        >>> (best.why_margin_unknown is None) == (None not in (best.margin_mm, best.margin_deg))
        True
        """
        why: str | None = self.json["margin_to_leak"].get("why_unknown")
        return why

    @property
    def ranked_cost(self) -> float | None:
        """In mm2, lower is better: what plans of a class are ranked by. None of files of release 0.2.

        >>> best.ranked_cost >= 0
        True
        """
        cost: float | None = self.json.get("ranked_cost")
        return cost

    @property
    def leak(self) -> Estimate:
        """As planned, mm2, with its errors by cause.

        >>> best.leak.value == best.measure.leak_mm2
        True
        """
        leak = self.json.get("leak")  # not of files of release 0.2
        return Estimate(self.measure.leak_mm2) if leak is None else Estimate.from_json(leak, "area_mm2")

    @property
    def estimates(self) -> dict[str, Estimate]:
        """Other figures that rules of practice use, and strains, as planned, with their errors by cause; empty of files of release 0.2.

        >>> best.estimates["tension_max_n"].value == best.measure.tension_max_n
        True
        """
        return {name: Estimate.from_json(one) for name, one in self.json.get("estimates", {}).items()}

    @property
    def closes_robustly(self) -> bool:
        """Acceptable: the valve leaks less than 5 mm2 with a probability of at least 0.95, given the errors of execution, tissue and mesh, also on
        the refined mesh; no rule of practice rejects the plan; and the valve opens far enough. Of files of release 0.2: mean + sd
        of the leak are below 1 mm2.

        >>> best.closes_robustly == (best.acceptable_probability >= 0.95)
        True
        """
        return bool(self.json.get("closes_robustly", False))

    @property
    def acceptable_probability(self) -> float | None:
        """That the repaired valve leaks less than 5 mm2; None of files of release 0.2.

        >>> 0 <= best.acceptable_probability <= 1
        True
        """
        probability: float | None = self.json.get("acceptable_probability")
        return probability

    @property
    def leak_maps(self) -> LeakMaps:
        """Leak over errors of execution; empty: too little was closed.

        >>> [one.muscle for one in best.leak_maps.maps]
        ['both', 'posteromedial']
        """
        return LeakMaps(tuple(map(LeakMap.from_json, self.json["leak_map"])))

    @property
    def remodelling(self) -> Remodelling:
        """Leak with further ventricular remodelling; empty without evidence.

        >>> sorted(best.remodelling.leak_mm2)
        ['all three', 'apical', 'outwards', 'posterior']
        """
        return Remodelling.from_json(self.json["remodelling"])

    @property
    def tolerance(self) -> tuple[Tolerance, ...]:
        """Leak over the error of each step; of the first plan of a search alone, empty without evidence.

        >>> [one.error for one in best.tolerance]
        ['ring_size', 'suture_length', 'suture_anchor']
        """
        return tuple(map(Tolerance.from_json, self.json.get("tolerance", ())))

    def picture(self) -> Picture:
        """The view from the atrium, before and after (PNG); of a search's plans alone, as mesh() and report().

        >>> best.picture().write("before-after.png")
        """
        return Picture(self._get("/picture"))

    def mesh(self, format: MeshFormat = "ply") -> bytes:
        """A file of the closed, repaired leaflets: millimetres, frame of the valve.

        >>> best.mesh("stl")[:5] == b"coapt"
        True
        """
        return self._get("/mesh", {"format": format})

    def leaflets(self) -> Mesh:
        """The same as numbers.

        >>> best.leaflets().faces.shape
        (648, 3)
        """
        return Mesh.from_ply(self.mesh("ply"))

    def report(self) -> str:
        """A report on this plan: a self-contained HTML page.

        >>> "annuloplasty" in best.report()
        True
        """
        return self._get("/report").decode()

    def _get(self, what: str, query: Document | None = None) -> bytes:
        if self._place is None:
            raise CoaptError("only the plans of a search have pictures, meshes and reports: see Client.search()")
        return self._place.transport.request("GET", self._place.path + what, query=query).body

    def _repr_html_(self) -> str:
        shown = ""
        if self._place:
            content = base64.b64encode(self.picture().png).decode()
            shown = f'<img alt="view from the atrium, before and after" style="max-width:100%" src="data:image/png;base64,{content}">'
        return plans_table([self]) + shown + tables.NOTICE_HTML


def plans_table(plans: Iterable[RankedPlan]) -> str:
    """A row each, as HTML."""
    head = ("", "plan", "leak as planned, mm²", "with errors of execution, 5 to 95 %", "worst", "margin", "tension, N")
    return tables.table(head, map(_row, plans))


def _row(plan: RankedPlan) -> tuple[str, ...]:
    leak, tension = plan.leak, plan.estimates.get("tension_max_n")
    margins = _margin(plan.margin_mm, _FARTHEST_MM, 2, " mm") + _margin(plan.margin_deg, _FARTHEST_DEG, 1, "°")
    what = tables.listed(plan.description) or "no repair"
    settled = plan.status == "converged" and not plan.crossing
    warnings = (() if settled else (tables.state(plan.status, plan.crossing),)) + plan.warnings
    warned = f"<br><small>{tables.listed(warnings, '! ')}</small>" if warnings else ""
    tie = "<br><small>equivalent to the next</small>" if plan.tie_with_next else ""
    return (
        str(plan.rank),
        what + warned + tie,
        leak.words(),
        interval_words(leak.execution),
        tables.number(plan.leak_mm2.worst),
        ", ".join(margins) or tables.escaped(plan.why_margin_unknown or "-"),
        tension.words() if tension else tables.number(plan.measure.tension_max_n, 2),
    )


def _margin(value: float | None, farthest: float, decimals: int, unit: str) -> list[str]:
    return [] if value is None else [f"{'more than ' * (value >= farthest)}{tables.number(value, decimals)}{unit}"]
