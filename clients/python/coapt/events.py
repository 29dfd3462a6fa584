"""Server-sent events: what happens to a job, as it happens."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from . import tables
from .repair import Plan

JobState = Literal["QUEUED", "RUNNING", "SUCCEEDED", "FAILED", "CANCELLED"]
"""The last three: it has ended."""

ENDED = ("SUCCEEDED", "FAILED", "CANCELLED")


@dataclass(frozen=True, repr=False)
class LeadingPlan(tables.Short):
    """A search's best plan so far.

    >>> coapt.LeadingPlan(Plan(OwnRing(2)), ("own ring",), cost=4.1, nodes=17, leak_mm2=0.3).plan
    Plan(OwnRing(sizes_below=2))
    """

    plan: Plan
    description: tuple[str, ...]
    """Surgical description, one line per step."""
    cost: float | None
    """In mm2, over so many nodes."""
    nodes: int
    """Of its region of interest that were closed."""
    leak_mm2: float | None
    """As planned."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> LeadingPlan:
        plan, description = Plan.from_json(json["plan"]), tuple(json["description"])
        return cls(plan, description, json["cost"], json["nodes"], json["leak_mm2"])


@dataclass(frozen=True, repr=False)
class Progress(tables.Short):
    """How far a job is. None: none yet, or another kind of job.

    >>> print(coapt.Progress("searching", 40, 600, best_leak_mm2=1.2, best_cost=None, seconds=3.0))
    40 of 600 closures, searching, lowest planned leak 1.2 mm2
    """

    stage: str
    """"starting", "searching", "ranking", a part of a study, "importing" or "fitting"."""
    closures: int
    """So far, known ones included."""
    closures_planned: int
    """Of a search at most, of a study in its present stage; 0: not known yet."""
    best_leak_mm2: float | None
    """The least leak of a plan as planned, estimated."""
    best_cost: float | None
    """The least cost at one closure a plan, in mm2."""
    seconds: float
    """Of running, over all attempts."""
    best: LeadingPlan | None = None
    """The best plan so far."""
    rms_mm: float | None = None
    """Remaining distance of a fit, root mean square."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Progress:
        return cls(
            json["stage"],
            json["closures"],
            json["closures_planned"],
            json["best_leak_mm2"],
            json["best_cost"],
            json["seconds"],
            LeadingPlan.from_json(json["best"]) if "best" in json else None,
            json.get("rms_mm"),
        )

    def __str__(self) -> str:
        stage = tables.printable(self.stage)
        best = "" if self.best_leak_mm2 is None else f", lowest planned leak {self.best_leak_mm2:.1f} mm2"
        if self.rms_mm is not None:
            return f"{tables.counted(self.closures, 'closure')}, {stage}, {self.rms_mm:.2f} mm rms"
        return f"{self.closures} of {self.closures_planned} closures, {stage}{best}"


@dataclass(frozen=True, repr=False)
class Event(tables.Short):
    """What happened to a job: one of state and progress is there.

    >>> job = client.search("human-functional-mr", evaluations=20, plans=1, region_points=2, evidence=False)
    >>> [event.state for event in job.events() if event.state]
    ['QUEUED', 'RUNNING', 'SUCCEEDED']
    """

    number: int
    """Counts a job's events from 1."""
    state: JobState | None = None
    """That the job changed to."""
    progress: Progress | None = None


def read_events(lines: Iterable[bytes]) -> Iterator[Event]:
    """The events of a text/event-stream. Comments, and an event that breaks off, are left out."""
    fields: dict[str, str] = {}
    for raw in lines:
        line = raw.decode().rstrip("\r\n")
        if line:
            name, _, value = line.partition(":")
            fields[name] = value.removeprefix(" ")
            continue
        if raw.endswith(b"\n") and "data" in fields:
            data = json.loads(fields["data"])
            number = int(fields.get("id", 0))
            if fields.get("event") == "state":
                yield Event(number, state=data["state"])
            elif fields.get("event") == "progress":
                yield Event(number, progress=Progress.from_json(data))
        fields = {}
