"""Closures of many valves with many plans, several at once."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from . import frames, tables
from .closures import Closure
from .errors import CoaptError
from .sources import Valve, valve_document, valve_name

if TYPE_CHECKING:
    import pandas

COLUMNS = {
    "valve_number": "valve_number",
    "plan_number": "plan_number",
    "valve": "valve",
    "plan": "plan",
    "trusted": "trusted",
    "status": "closure.status",
    "crossing": "closure.crossing",
    **{column: f"closure.{place}" for column, place in frames.MEASURE.items()},
    "annulus_ap_mm": "closure.measure.annulus_ap_mm",
    "annulus_al_pm_mm": "closure.measure.annulus_al_pm_mm",
    "tenting_height_mm": "closure.measure.tenting_height_mm",
    "tension_sum_n": "closure.measure.tension_sum_n",
    "strain_circumferential_max": "closure.measure.strain_circumferential_max",
    "strain_radial_max": "closure.measure.strain_radial_max",
    "error": "problem",
}
"""Of its table, and where their values are."""


@dataclass(frozen=True, repr=False)
class SweepItem(tables.Short):
    """One closure of a sweep, or the error in its place.

    >>> item = coapt.close_many("human-normal")[0]
    >>> item.valve, item.plan, item.trusted, item.problem
    ('human-normal', 'no repair', True, '')
    """

    valve_number: int
    """From 0, in the order given."""
    plan_number: int
    """From 0, in the order given."""
    valve: str
    """Its name."""
    plan: str
    """Name of the plan; "no repair" without a plan."""
    closure: Closure | None
    """None: see error."""
    error: CoaptError | None

    @property
    def trusted(self) -> bool:
        """Whether there is a reliable closure.

        >>> [item.trusted for item in client.map(["human-normal", "no-such-valve"])]
        [True, False]
        """
        return self.closure is not None and self.closure.trusted

    @property
    def problem(self) -> str:
        """The error in words; empty: there is none.

        >>> [item.problem.splitlines()[0] for item in client.map(["no-such-valve"])]
        ['422 Unprocessable content']
        """
        return "" if self.error is None else str(self.error)


class Sweep:
    """Every valve with every plan: iterating makes the closures. See Client.map().

    >>> table = client.map(["human-normal"], [Plan(OwnRing(1)), Plan(OwnRing(2))]).to_frame()
    >>> table["annuloplasty_sizes_below"].tolist()
    [1, 2]
    """

    def __init__(
        self,
        close: Callable[[Any, Any], Closure],
        valves: Iterable[Valve],
        plans: Sequence[tuple[str, Any]],
        threads: int,
        read: Callable[[Valve], Any] = valve_document,
    ) -> None:
        """
        :param plans: names and documents; a document None is no repair
        :param read: makes of a valve what close takes, once
        """
        self._close, self._valves, self._plans, self._threads, self._read = close, valves, plans, threads, read

    def __repr__(self) -> str:
        return f"Sweep({tables.counted(len(self._plans), 'plan')}, {tables.counted(self._threads, 'thread')})"

    def to_frame(self) -> pandas.DataFrame:
        """Makes all closures: a row each, with the valve's and the plan's number and name, figures, trusted, error, and the plan's
        steps: "annuloplasty_size_mm", "neochorda_1_length_mm" and so on.

        >>> client.map("human-normal", [Plan(), plan]).to_frame()["plan"].tolist()
        ['plan 1', 'plan 2']
        """
        items = list(self)
        return frames.with_steps(frames.table(items, COLUMNS), (self._plans[item.plan_number][1] for item in items))

    def __iter__(self) -> Iterator[SweepItem]:
        waiting: deque[Future[SweepItem]] = deque()
        with ThreadPoolExecutor(self._threads) as pool:
            try:
                for task in self._tasks():
                    if len(waiting) == 2 * self._threads:
                        yield waiting.popleft().result()
                    waiting.append(pool.submit(task))
                while waiting:
                    yield waiting.popleft().result()
            finally:
                for future in waiting:
                    future.cancel()

    def _tasks(self) -> Iterator[Callable[[], SweepItem]]:
        for valve_number, valve in enumerate(self._valves):
            name = valve_name(valve)
            try:
                document, error = self._read(valve), None
            except CoaptError as unreadable:
                document, error = None, unreadable
            for plan_number, (plan_name, plan) in enumerate(self._plans):
                place = (valve_number, plan_number, name, plan_name)
                yield partial(self._item, place, document, plan, error)

    def _item(self, place: tuple[int, int, str, str], valve: Any, plan: Any, error: CoaptError | None) -> SweepItem:
        if error is None:
            try:
                return SweepItem(*place, self._close(valve, plan), None)
            except CoaptError as refused:
                error = refused
        return SweepItem(*place, None, error)
