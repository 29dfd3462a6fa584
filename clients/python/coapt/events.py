"""Server-sent events: what happens to a job, as it happens."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

JobState = Literal["QUEUED", "RUNNING", "SUCCEEDED", "FAILED", "CANCELLED"]
ENDED = ("SUCCEEDED", "FAILED", "CANCELLED")


@dataclass(frozen=True)
class Progress:
    """How far a job is. closures includes known ones; best_leak_mm2 is the least leak of a plan as planned, None: none yet;
    seconds are those of running, over all attempts."""

    stage: str
    closures: int
    closures_planned: int
    best_leak_mm2: float | None
    seconds: float

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Progress:
        return cls(json["stage"], json["closures"], json["closures_planned"], json["best_leak_mm2"], json["seconds"])

    def __str__(self) -> str:
        best = "" if self.best_leak_mm2 is None else f", lowest leak as planned {self.best_leak_mm2:.1f} mm2"
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
