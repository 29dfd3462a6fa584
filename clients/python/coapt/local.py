"""The engine of this process, made when it is first asked for."""

from __future__ import annotations

from collections.abc import Iterable

from .engine import Engine, LocalValve, engine_here
from .files import Path
from .sources import PlanSource, Valve
from .sweep import SweepItem


def engine() -> Engine:
    """The engine that preset(), read_valve() and close_many() use.

    >>> coapt.engine() is coapt.engine()
    True

    :raises MissingPackage: this installation has none
    """
    return engine_here()


def preset(name: str) -> LocalValve:
    """A preset valve; Service.presets() lists them.

    >>> coapt.preset("human-normal").close().trusted
    True

    :raises InvalidRequest: there is none of that name
    """
    return engine().preset(name)


def read_valve(path: Path) -> LocalValve:
    """A file of a coapt.valve/1.

    >>> coapt.read_valve("examples/valves/bodyparts3d-leaking.json").close().measure.leak_mm2 > 5
    True

    :raises NoSuchFile, BadDocument: problems have pointers into the file
    """
    return engine().read_valve(path)


def close_many(
    valves: Valve | Iterable[Valve],
    plans: PlanSource | Iterable[PlanSource] | None = None,
    *,
    threads: int | None = None,
) -> list[SweepItem]:
    """Closes every valve with every plan in this process: all plans of the first valve, then all of the second. An error of one
    stands in its place. See Engine.map() for one after the other.

    >>> plans = [Plan(), "examples/plans/ring.json"]
    >>> items = coapt.close_many(["human-normal", "porcine-1", "no-such-valve"], plans, threads=2)
    >>> [(item.valve, item.plan, item.trusted) for item in items[:3]]
    [('human-normal', 'plan 1', True), ('human-normal', 'ring', True), ('porcine-1', 'plan 1', True)]
    >>> items[-1].error.status
    422

    :param threads: closures at once; does not change any; all cores by default
    """
    return engine().close_many(valves, plans, threads=threads)
