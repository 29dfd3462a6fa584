"""What evaluations, searches and studies answer, as small typed objects. Each keeps the whole document in json."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from . import frames, tables
from .closures import Document, Measure, Status, known_fields
from .ranked_plans import COLUMNS, RankedPlan, plans_table
from .transport import Transport

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True, repr=False)
class Before(tables.Short):
    """The unrepaired valve, for comparison with the plans.

    >>> scored = coapt.preset("human-functional-mr").evaluate([Plan(OwnRing(2))])
    >>> scored.before.status, scored.before.measure.leak_mm2 > scored.plans[0].measure.leak_mm2
    ('converged', True)
    """

    status: Status
    """How its closure ended."""
    crossing: bool
    """Whether leaflets cross, which makes the results unreliable."""
    measure: Measure
    """Its figures."""

    @classmethod
    def from_json(cls, json: Document) -> Before:
        return cls(json["status"], json["crossing"], Measure.from_json(json))


@dataclass(frozen=True, repr=False)
class Evaluations(tables.Short):
    """Given plans in the order of the request, each with its rank.

    >>> plans = [Plan(), Plan(OwnRing(2))]
    >>> scored = coapt.preset("human-functional-mr").evaluate(plans, region_points=2)
    >>> [plan.rank for plan in scored.plans]
    [2, 1]
    >>> list(scored.to_frame()["description"])
    ['', "annuloplasty: ring in the annulus's own shape, undersized by 2 sizes (transverse 33.0 to 29.0 mm)"]
    """

    before: Before
    """The unrepaired valve."""
    plans: tuple[RankedPlan, ...]
    """In the order asked."""
    closures: int
    """Number of closures, including that of the unrepaired valve."""
    seconds: float
    """Computing time of scoring."""
    json: Document = field(repr=False, compare=False)
    """The whole of it."""

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
        """A row a plan; "plan" is the coapt.plan/1 as JSON, and its steps' numbers follow. Figures are as planned but those that begin with
        mean, sd, p95 and worst, which are over the region of interest.

        >>> list(valve.evaluate([plan]).to_frame()["annuloplasty_size_mm"])
        [32.0]
        """
        return frames.with_steps(frames.table(self.plans, COLUMNS), (one.plan.to_json() for one in self.plans))

    def _repr_html_(self) -> str:
        return _plans_html(self.before, self.plans)


@dataclass(frozen=True, repr=False)
class SearchResult(tables.Short):
    """Ranked plans (coapt.plans/2).

    >>> job = client.search("human-functional-mr", evaluations=20, plans=1, region_points=2, evidence=False)
    >>> result = job.result()
    >>> result.stop, result.plans[0].rank, len(result.to_frame())
    ('evaluation_limit', 1, 1)
    """

    before: Before
    """The unrepaired valve."""
    plans: tuple[RankedPlan, ...]
    """Best first."""
    any_competent: bool
    """Whether one of them is acceptable: see RankedPlan.closes_robustly."""
    stop: str
    """Why the search ended: evaluation_limit, exhausted, no_improvement, target_reached, time_limit or cancelled."""
    closures: int
    """Number of closures, including reused ones."""
    seconds: float
    """That the search ran, over all attempts."""
    json: Document = field(repr=False, compare=False)
    """The coapt.plans/2: progress, Pareto-optimal plans, branches, and more."""

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
        """A row a plan; "plan" is the coapt.plan/1 as JSON, and its steps' numbers follow. Figures are as planned but those that begin with
        mean, sd, p95 and worst, which are over the region of interest.

        >>> list(result.to_frame()["rank"])
        [1]
        """
        return frames.with_steps(frames.table(self.plans, COLUMNS), (one.plan.to_json() for one in self.plans))

    def _repr_html_(self) -> str:
        return _plans_html(self.before, self.plans)


@dataclass(frozen=True, repr=False)
class Finding(tables.Short):
    """A finding of the thesis compared with this valve's.

    >>> finding = coapt.Finding("dilation-orifice", "4.3.1", "it opens", "it opens", "the sign", agrees=True)
    >>> finding.section
    '4.3.1'
    """

    finding: str
    """Its name, such as "dilation-orifice"."""
    section: str
    """Of the thesis."""
    thesis: str
    """Finding of the thesis, in a sentence."""
    ours: str
    """Finding on this valve, in a sentence."""
    judged: str
    """Criterion of agreement."""
    agrees: bool
    """Whether they do."""


@dataclass(frozen=True, repr=False)
class StudyResult(tables.Short):
    """A study's findings.

    >>> result = client.study("porcine-3", "annulus").result()
    >>> result.study, result.valve, result.untrusted
    ('annulus', 'porcine-3', 0)
    """

    study: str
    """Its name, such as "annulus"."""
    valve: str
    """The valve's name."""
    configurations: int
    """Of annulus, papillary tips, rings or sutures, how many were looked at."""
    closures: int
    """How many were made."""
    untrusted: int
    """Of them not converged, or with leaflets that cross."""
    seconds: float
    """That the study ran."""
    findings: tuple[Finding, ...]
    """In the order of the thesis."""
    json: Document = field(repr=False, compare=False)
    """The whole of it."""

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
        """A row a finding.

        >>> list(client.study("porcine-3", "annulus").result().to_frame())[:2]
        ['finding', 'section']
        """
        return frames.records(Finding, self.findings)

    def _repr_html_(self) -> str:
        rows = [
            (
                "agrees" if finding.agrees else "<b>differs</b>",
                tables.escaped(finding.finding),
                tables.escaped(finding.thesis),
                tables.escaped(finding.ours),
            )
            for finding in self.findings
        ]
        return tables.table(("", "finding", "thesis", tables.escaped(self.valve)), rows) + tables.NOTICE_HTML


def _plans_html(before: Before, plans: Sequence[RankedPlan]) -> str:
    state = (
        f"<p>Before: leak {tables.number(before.measure.leak_mm2)} mm², "
        f"{tables.escaped(tables.state(before.status, before.crossing))}</p>"
    )
    return state + plans_table(plans) + tables.NOTICE_HTML
