"""Repair plans (coapt.plan/1): some steps.

>>> plan = Plan(Ring("generic-classic", size_mm=38), PapillaryApproximation("posteromedial", suture_length_mm=24))
>>> plan.to_json()["steps"][0]
{'step': 'annuloplasty', 'shape': 'generic-classic', 'size_mm': 38}
"""

from __future__ import annotations

import json
import pathlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .errors import BadDocument
from .files import Path, read_plan_entries
from .step_documents import step_from_json
from .steps import Step


class Plan:
    """Steps of a repair; their order does not change the result. Plan() is no repair.

    >>> ring = Plan(OwnRing(2))
    >>> ring.with_step(Neochorda("AL1", LeafletPoint("posterior", along=0.5), length_mm=20))
    Plan(OwnRing(sizes_below=2), Neochorda(head='AL1', insertion=LeafletPoint(leaflet='posterior', along=0.5, height=1.0), length_mm=20))
    >>> Plan.from_json(ring.to_json()) == ring
    True
    """

    def __init__(self, *steps: Step) -> None:
        self.steps: tuple[Step, ...] = steps

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Plan:
        """:raises BadDocument: it is no coapt.plan/1"""
        if (
            not isinstance(json, Mapping)
            or json.get("schema") != "coapt.plan/1"
            or not isinstance(json.get("steps"), list)
        ):
            raise BadDocument('no coapt.plan/1: "schema" and "steps" are needed')
        return cls(*map(step_from_json, json["steps"]))

    @classmethod
    def read(cls, path: Path) -> Plan:
        """The plan of a file, the first of several.

        >>> len(Plan.read("examples/plans/mixed.json").steps)
        2

        :raises NoSuchFile, BadDocument: it holds none
        """
        return read_plans(path)[0].plan

    def to_json(self) -> dict[str, Any]:
        """coapt.plan/1, as the service and `coapt close --plan` read it."""
        return {"schema": "coapt.plan/1", "steps": [step.to_json() for step in self.steps]}

    def write(self, path: Path) -> None:
        """To a file, as Plan.read() and `coapt close --plan` read it.

        >>> plan.write("plan.json")
        >>> Plan.read("plan.json") == plan
        True
        """
        pathlib.Path(path).write_text(json.dumps(self.to_json(), indent=2) + "\n")

    def with_step(self, step: Step) -> Plan:
        """This plan and one step more.

        >>> plan.with_step(PapillaryApproximation("posteromedial", 24)).steps[-1].side
        'posteromedial'
        """
        return Plan(*self.steps, step)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Plan) and self.steps == other.steps

    def __hash__(self) -> int:
        return hash(self.steps)

    def __repr__(self) -> str:
        return f"Plan({', '.join(map(repr, self.steps))})"


@dataclass(frozen=True)
class NamedPlan:
    """A plan of a file.

    >>> coapt.read_plans("examples/plans/ring.json")[0].name
    'ring'
    """

    name: str
    plan: Plan


def read_plans(path: Path) -> list[NamedPlan]:
    """Every plan of a file, in its order: a coapt.plan/1, the output of `coapt plan --json`, or plans saved on the page.

    >>> [one.name for one in read_plans("examples/plans/mixed.json")]
    ['mixed']

    :raises NoSuchFile, BadDocument: it holds none
    """

    def read(name: str, plan: Any) -> NamedPlan:
        try:
            return NamedPlan(name, Plan.from_json(plan))
        except BadDocument as error:
            raise BadDocument(f"{path}: {name}: {error}") from error

    return [read(name, plan) for name, plan in read_plan_entries(path)]
