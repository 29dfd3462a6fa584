"""Server-sent events: what happens to a job, as it happens."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from .repair import Plan

JobState = Literal["QUEUED", "RUNNING", "SUCCEEDED", "FAILED", "CANCELLED"]
ENDED = ("SUCCEEDED", "FAILED", "CANCELLED")


@dataclass(frozen=True)
class LeadingPlan:
    """A search's best plan so far. cost in mm2 over so many nodes of its region of interest; leak_mm2 as planned; description in
    surgical words, a line a step."""

    plan: Plan
    description: tuple[str, ...]
    cost: float | None
    nodes: int
    leak_mm2: float | None

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> LeadingPlan:
        plan, description = Plan.from_json(json["plan"]), tuple(json["description"])
        return cls(plan, description, json["cost"], json["nodes"], json["leak_mm2"])


@dataclass(frozen=True)
class Progress:
    """How far a job is. closures includes known ones; best_leak_mm2 is the least leak of a plan as planned, best_cost the least
    cost (mm2) at one closure a plan, best the plan in front, rms_mm the distance that a fit leaves so far, None: none yet;
    seconds are those of running, over all attempts.
    """

    stage: str
    closures: int
    closures_planned: int
    best_leak_mm2: float | None
    best_cost: float | None
    seconds: float
    best: LeadingPlan | None = None
    rms_mm: float | None = None

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
        best = "" if self.best_leak_mm2 is None else f", lowest leak as planned {self.best_leak_mm2:.1f} mm2"
        if self.rms_mm is not None:
            return f"{self.closures} closures, {self.stage}, {self.rms_mm:.2f} mm rms"
        return f"{self.closures} of {self.closures_planned} closures, {self.stage}{best}"


@dataclass(frozen=True)
class Event:
    """number counts a job's events from 1. One of state (the job changed to it) and progress is there."""

    number: int
    state: JobState | None = None
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
