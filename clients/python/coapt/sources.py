"""What may be given where a valve or a plan is asked for, and what a request carries of it."""

from __future__ import annotations

import functools
import inspect
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Concatenate, ParamSpec, TypeAlias, TypeVar

from .errors import BadDocument
from .files import Path, is_path, plan_entries, read_json, read_plan_entries
from .ranked_plans import RankedPlan
from .repair import NamedPlan, Plan
from .stored import KeptPlan, StoredValve


Rest = ParamSpec("Rest")
Result = TypeVar("Result")


def of_this_valve(
    function: Callable[Concatenate[Any, Any, Rest], Result],
) -> Callable[Concatenate[Any, Rest], Result]:
    """A function of an engine that takes a valve, as one of a valve that has an engine."""

    @functools.wraps(function)
    def asked(self: Any, /, *rest: Rest.args, **named: Rest.kwargs) -> Result:
        return function(self.engine, self, *rest, **named)

    asked.__module__, asked.__qualname__ = "coapt.engine", f"LocalValve.{function.__name__}"  # for pickle
    signature = inspect.signature(function)
    parameters = [one for name, one in signature.parameters.items() if name != "valve"]
    asked.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
    return asked


class ValveHere(ABC):
    """A valve in this process."""

    @property
    @abstractmethod
    def name(self) -> str:
        """Of its document."""

    @abstractmethod
    def to_json(self) -> dict[str, Any]:
        """The coapt.valve/1."""


Valve: TypeAlias = Path | Mapping[str, Any] | StoredValve | ValveHere
"""A preset's name or the id of a stored valve; a file (a pathlib.Path, or text that ends in ".json") of a coapt.valve/1; such a
document; what Client.valves() lists; or one in this process."""

PlanSource: TypeAlias = Plan | NamedPlan | RankedPlan | KeptPlan | Mapping[str, Any] | Path
"""A plan, from wherever it comes, or a file (a pathlib.Path, or text that ends in ".json") or document of one or several:
coapt.plan/1, what `coapt plan --json` prints, the page's saved plans. Where one plan is asked for, the first counts."""

_ONE_VALVE = (str, os.PathLike, Mapping, StoredValve, ValveHere)
ONE_PLAN = (Plan, NamedPlan, RankedPlan, KeptPlan, Mapping, str, os.PathLike)


def valve_document(valve: Valve) -> Any:
    """
    :raises NoSuchFile, BadDocument: of a file
    """
    if isinstance(valve, StoredValve):
        return valve.id
    if isinstance(valve, ValveHere):
        return valve.to_json()
    if is_path(valve):
        return read_json(valve)
    if not isinstance(valve, (str, Mapping)):
        raise BadDocument(
            f"{type(valve).__name__} is no valve: a name, a file, a document; import_valve() makes one of geometry"
        )
    return valve


def valve_name(valve: Valve) -> str:
    """What to call it in a table."""
    if isinstance(valve, Mapping):
        return str(valve.get("name", ""))
    return valve.name if isinstance(valve, (StoredValve, ValveHere)) else str(valve)


def named_plans(source: PlanSource) -> list[tuple[str, Any]]:
    """Name and coapt.plan/1 of each plan; names may be empty.

    :raises NoSuchFile, BadDocument: of a file or a document of several plans
    """
    if isinstance(source, Plan):
        return [("", source.to_json())]
    if isinstance(source, (NamedPlan, KeptPlan)):
        return [(source.name, source.plan.to_json())]
    if isinstance(source, RankedPlan):
        return [(f"rank {source.rank}", source.plan.to_json())]
    if is_path(source):
        return read_plan_entries(source)
    if isinstance(source, str):
        raise BadDocument(f"{source!r} is no plan: give a Plan, or a file whose name ends in .json")
    return plan_entries(source)


def plan_document(plan: PlanSource) -> Any:
    return named_plans(plan)[0][1]


def all_named_plans(plans: PlanSource | Iterable[PlanSource]) -> list[tuple[str, Any]]:
    """named_plans() of one source, or of several in their order; those without a name are numbered from 1."""
    sources = [plans] if isinstance(plans, ONE_PLAN) else plans
    named = [one for source in sources for one in named_plans(source)]
    return [(name or f"plan {i}", plan) for i, (name, plan) in enumerate(named, 1)]


def every_valve(valves: Valve | Iterable[Valve]) -> Iterable[Valve]:
    return [valves] if isinstance(valves, _ONE_VALVE) else valves
