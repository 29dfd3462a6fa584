"""The plans that a search may try on a valve as vectors of numbers, for optimisers and objectives of one's own."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from . import tables
from .asking import checked_threads
from .closures import Closure
from .errors import CoaptError
from .lattices import Lattice
from .leaflets import local_closure
from .local_transport import refusing
from .repair import Plan
from .searchers import Searcher
from .sources import ONE_PLAN, PlanSource, plan_document
from .steps import Step
from .transport import encoded

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

Objective: TypeAlias = Callable[[Closure], float]
"""Of a closure that is to be trusted; less is better."""

# Operations that a search tries on request alone.
_REQUESTED = ("leaflet_resection", "edge_to_edge", "chordal_length_change", "chordal_excision", "chordal_transfer")


def leak_mm2(closure: Closure) -> float:
    """The objective where none is given."""
    return math.inf if closure.measure.leak_mm2 is None else closure.measure.leak_mm2


@dataclass(frozen=True, repr=False)
class Trial(tables.Short):
    """A point of a space, tried.

    >>> space = coapt.preset("human-functional-mr").space(Ring("generic-classic", 30))
    >>> space.evaluate(space.start).reason
    ''
    """

    x: tuple[float, ...]
    plan: Plan | None
    """None: there is no such point."""
    closure: Closure | None = field(repr=False)
    """None: the plan was refused."""
    value: float
    """Of the objective; infinite where there is a reason."""
    reason: str
    """Why it does not count: outside the space, impossible on this valve, or no closure that is to be trusted; empty: it counts."""


class Space(Lattice):
    """The plans that a search of a valve may try, made by LocalValve.space(): what its diagnosis indicates, within rules.

    A plan is a vector: first sizes, lengths and places, on the lattice of what can be bought and tied, in the units of their
    names; then, as integers, the operation's choices, whose words are in choices. What an operation does not have is ignored: the
    size of a ring where there is none. Vectors between the points of the lattice are rounded to it, sizes that a ring is not
    made in to the nearest.

    It is the problem of pygmo (fitness, get_bounds, get_nix, batch_fitness), the function of scipy (a call, ``Bounds(*get_bounds())``)
    and of OpenTURNS (PythonFunction(len(space.names), 1, space.fitness, func_sample=space.batch_fitness)) at once.

    >>> space = coapt.preset("human-functional-mr").space()
    >>> space.names
    ('ring_size_mm', 'posteromedial_movement_mm', 'posteromedial_anchor_place', 'anterolateral_movement_mm', \
'anterolateral_anchor_place', 'ring', 'anterolateral', 'posteromedial')
    >>> space.lower[0], space.upper[0], space.step[0], space.integer[0]
    (24.0, 32.0, 2.0, False)
    >>> space.choices["posteromedial"]
    ('none', 'ipsilateral_trigone', 'saddle_peak', 'annulus_point')
    >>> plan = space.plan(space.start)
    >>> space.plan(space.vector(plan)) == plan
    True
    >>> space.fitness(space.start) == [space.evaluate(space.start).value]
    True

    It pickles where its objective does, a function of a module; copies share all but the objective.
    """

    def __init__(
        self,
        valve: Any,
        rules: Mapping[str, Any],
        like: Mapping[str, Any] | None = None,
        objective: Objective = leak_mm2,
    ) -> None:
        """
        :param valve: a LocalValve
        :param rules: of a search's request
        :param like: a coapt.plan/1, whose operation alone counts
        :raises InvalidRequest: rules that are wrong or leave nothing, or an operation that this valve is not offered
        """
        self.valve, self.objective = valve, objective
        self.rules, self._like = dict(rules), None if like is None else dict(like)
        super().__init__(valve.native, self.rules, self._like)

    def __reduce__(self) -> tuple[Any, ...]:
        return Space, (self.valve, self.rules, self._like, self.objective)

    def __copy__(self) -> Space:
        return self

    def __deepcopy__(self, memo: Any) -> Space:
        return self.problem(copy.deepcopy(self.objective, memo))

    def _identity(self) -> tuple[Any, ...]:
        return self.valve, self.rules, self._like, self.objective

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Space) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash((self.valve, self.objective))

    def __repr__(self) -> str:
        return f"Space({self.valve.name!r}, {len(self._branches)} operations, {len(self._coordinates)} numbers)"

    def problem(self, objective: Objective) -> Space:
        """The same plans with an objective of one's own, less is better.

        >>> space = coapt.preset("human-functional-mr").space()
        >>> problem = space.problem(lambda closure: closure.measure.leak_mm2 + 20 * closure.measure.tension_max_n)
        >>> problem(space.start) > space(space.start)
        True

        :param objective: of a closure that is to be trusted
        """
        made = Space.__new__(Space)
        made.__dict__ = self.__dict__ | {"objective": objective}
        return made

    def searcher(self, seed: int = 1) -> Searcher:
        """A search by ask and tell.

        >>> space.plan(space.searcher().ask()[0])
        Plan(...)
        """
        return Searcher(self, seed)

    def evaluate(self, x: Iterable[float]) -> Trial:
        """Closes the valve with the plan at a vector, and asks the objective; what is refused is infinite and says why.

        >>> space.evaluate([99.0] * len(space.names)).reason
        '...ring_size_mm is 99, must be from 24 to 32'
        """
        given, plan, closure, value = tuple(map(float, x)), None, None, math.inf
        try:
            plan = self.plan(given)
            with refusing():
                closure = local_closure(self.valve.native.close(encoded({"plan": plan.to_json()})))
            if not closure.trusted:
                reason = f"no closure that is to be trusted: {'leaflets cross' if closure.crossing else closure.status}"
            else:
                value = float(self.objective(closure))
                reason = "the objective is not a number" if math.isnan(value) else ""
        except CoaptError as error:
            reason = str(error)
        return Trial(given, plan, closure, math.inf if reason else value, reason)

    def evaluate_many(self, vectors: Iterable[Iterable[float]], *, threads: int | None = None) -> list[Trial]:
        """evaluate() of each, several at once.

        >>> [trial.reason for trial in space.evaluate_many(space.random(2))]
        ['', '']

        :param threads: closures at once; by default the engine's. It does not change any value
        """
        at_once = self.valve.engine._at_once(None if threads is None else checked_threads(threads))
        with ThreadPoolExecutor(at_once) as pool:
            return list(pool.map(self.evaluate, vectors))

    def __call__(self, x: Iterable[float]) -> float:
        return self.evaluate(x).value

    def fitness(self, x: Iterable[float]) -> list[float]:
        """The objective alone, in a list, as pygmo and OpenTURNS want it.

        >>> space.fitness(space.start) == [space(space.start)]
        True
        """
        return [self.evaluate(x).value]

    def batch_fitness(self, vectors: Any) -> NDArray[numpy.float64]:
        """fitness() of many, several at once: rows give rows, one long vector (pygmo's) gives a vector.

        >>> space.batch_fitness(space.random(2)).shape
        (2, 1)
        """
        import numpy

        given = numpy.asarray(vectors, dtype=numpy.float64)
        trials = self.evaluate_many(given.reshape(-1, max(1, len(self._coordinates))))
        values = numpy.array([trial.value for trial in trials])
        return values if given.ndim == 1 else values.reshape(-1, 1)


def space_of(
    valve: Any,
    steps: Sequence[Step | PlanSource],
    rules: Mapping[str, Any],
    objective: Objective | None,
) -> Space:
    """See LocalValve.space()."""
    plan: Any = None
    if steps:
        are_steps = not isinstance(steps[0], ONE_PLAN)
        plan = plan_document(Plan(*steps) if are_steps else steps[0])  # type: ignore[arg-type]
        named = {step["step"] for step in plan["steps"]}
        rules = {name: True for name in _REQUESTED if name in named} | dict(rules)
        if any(step.get("shape") == "own" for step in plan["steps"]):
            rules = {"own_ring": True} | dict(rules)
        rings = [step["ring"] for step in plan["steps"] if step.get("shape") == "designed"]
        rules = ({"shapes": rings} if rings else {}) | dict(rules)
    return Space(valve, rules, plan, objective or leak_mm2)
