"""The plans that a search may try on a valve as vectors of numbers, for optimisers and objectives of one's own."""

from __future__ import annotations

import copy
import json
import math
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from . import tables
from .asking import checked_threads
from .closures import Closure
from .comparison import local_closure
from .errors import CoaptError, InvalidRequest, Problem
from .local_transport import engine_module, refusing
from .repair import Plan
from .searchers import Searcher
from .sources import ONE_PLAN, PlanSource, plan_document
from .steps import Step

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

Objective: TypeAlias = Callable[[Closure], float]
"""Of a closure that is to be trusted; less is better."""

_CHOICES = ("ring", "anterolateral", "posteromedial", "neochordae", "chordal", "leaflet")
_DECIDED = (
    "step",
    "shape",
    "side",
    "anchor",
    "device",
    "chorda",
    "leaflet",
)  # fields of a step that are no numbers to choose
# Operations that a search tries on request alone.
_REQUESTED = ("leaflet_resection", "edge_to_edge", "chordal_length_change", "chordal_excision", "chordal_transfer")
_ROUNDING = 1e-9
_PLACE = 1e4  # mm for a place that is off by 1


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


@dataclass(frozen=True)
class _Coordinate:
    name: str
    lower: float
    upper: float
    step: float
    start: float


class Space:
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
        asked = json.dumps({"rules": self.rules})
        for indicated in (True,) if like is None else (True, False):
            with refusing():
                self._native = engine_module().Space(valve.native, asked, indicated)
            told = json.loads(self._native.document())
            self._branches = {
                number: branch
                for number, branch in enumerate(told["branches"])
                if like is None or _operation(like) == _operation(self._start_of(number, branch))
            }
            if self._branches:
                break
        self.cut: tuple[tuple[str, str], ...] = tuple((one["what"], one["why"]) for one in told["cut"])
        """What is left out, and why."""
        if like is not None and not self._branches:
            raise self._not_offered()
        self._set_coordinates()

    def _start_of(self, number: int, branch: Mapping[str, Any]) -> Any:
        return json.loads(self._native.plan(number, [one["start"] for one in branch["parameters"]]))

    def _not_offered(self) -> InvalidRequest:
        why = "".join(f"; {what}: {reason}" for what, reason in self.cut)
        problem = Problem("impossible_step", "/plan", f"no plan of this operation is offered on this valve{why}")
        return InvalidRequest(422, "not offered", [problem])

    def _set_coordinates(self) -> None:
        found: dict[str, _Coordinate] = {}
        for branch in self._branches.values():
            for one in branch["parameters"]:
                lower, step = one["lower"], one["step"]
                upper, start = lower + step * (one["count"] - 1), lower + step * one["start"]
                known = found.setdefault(one["name"], _Coordinate(one["name"], lower, upper, step, start))
                found[known.name] = _Coordinate(
                    known.name, min(known.lower, lower), max(known.upper, upper), step, known.start
                )
        words = {name: tuple(dict.fromkeys(one[name] for one in self._branches.values())) for name in _CHOICES}
        self.choices: dict[str, tuple[str, ...]] = {name: told for name, told in words.items() if len(told) > 1}
        """Words of the integers, by their names."""
        self._coordinates = [one for one in found.values() if one.lower < one.upper]
        self._coordinates += [_Coordinate(name, 0, len(told) - 1, 1, 0) for name, told in self.choices.items()]
        self._numbers = {
            tuple(branch[name] for name in self.choices): number for number, branch in self._branches.items()
        }

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
        """A search by ask and tell."""
        return Searcher(self, seed)

    @property
    def names(self) -> tuple[str, ...]:
        """Of the numbers of a vector, with their units."""
        return tuple(one.name for one in self._coordinates)

    @property
    def lower(self) -> tuple[float, ...]:
        """Their least values."""
        return tuple(one.lower for one in self._coordinates)

    @property
    def upper(self) -> tuple[float, ...]:
        """Their largest values."""
        return tuple(one.upper for one in self._coordinates)

    @property
    def step(self) -> tuple[float, ...]:
        """From one value to the next."""
        return tuple(one.step for one in self._coordinates)

    @property
    def integer(self) -> tuple[bool, ...]:
        """Whether it is the number of a choice: these come last."""
        return tuple(one.name in self.choices for one in self._coordinates)

    @property
    def start(self) -> tuple[float, ...]:
        """What practice would try first of the simplest operation."""
        return self._vector(next(iter(self._branches)), None)

    def get_bounds(self) -> tuple[list[float], list[float]]:
        """lower and upper, as pygmo and scipy.optimize.Bounds take them."""
        return list(self.lower), list(self.upper)

    def get_nix(self) -> int:
        """How many integers there are."""
        return len(self.choices)

    def plan(self, x: Iterable[float]) -> Plan:
        """The plan at a vector.

        :raises InvalidRequest: another length, a number outside its bounds, choices that are not offered together
        """
        return Plan.from_json(json.loads(self._native.plan(*self._point(x))))

    def vector(self, plan: PlanSource) -> tuple[float, ...]:
        """Of the plan of the space that is nearest to this one.

        :raises InvalidRequest: its operation is not offered
        """
        given = plan_document(plan)
        for number, branch in self._branches.items():
            if _operation(given) == _operation(self._start_of(number, branch)):
                at = [one["start"] for one in branch["parameters"]]
                # A suture's length follows from the movement and from its anchor's place, which comes first.
                for k, one in sorted(enumerate(branch["parameters"]), key=_is_movement):
                    tried = [[*at[:k], value, *at[k + 1 :]] for value in range(one["count"])]
                    at = min(tried, key=lambda at: _distance(json.loads(self._native.plan(number, at)), given))
                return self._vector(number, at)
        raise self._not_offered()

    def random(self, count: int, seed: int = 1) -> list[tuple[float, ...]]:
        """Vectors at random: an operation, each as likely, and a point of its lattice."""
        chance = random.Random(seed)
        numbers = list(self._branches)
        points = []
        for _ in range(count):
            number = chance.choice(numbers)
            points.append(
                self._vector(number, [chance.randrange(one["count"]) for one in self._branches[number]["parameters"]])
            )
        return points

    def evaluate(self, x: Iterable[float]) -> Trial:
        """Closes the valve with the plan at a vector, and asks the objective; what is refused is infinite and says why."""
        given, plan, closure, value = tuple(map(float, x)), None, None, math.inf
        try:
            plan = self.plan(given)
            with refusing():
                closure = local_closure(self.valve.native.close(json.dumps(plan.to_json()), b""))
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

        :param threads: closures at once; by default the engine's. It does not change any value
        """
        at_once = self.valve.engine._at_once(None if threads is None else checked_threads(threads))
        with ThreadPoolExecutor(at_once) as pool:
            return list(pool.map(self.evaluate, vectors))

    def __call__(self, x: Iterable[float]) -> float:
        return self.evaluate(x).value

    def fitness(self, x: Iterable[float]) -> list[float]:
        """The objective alone, in a list, as pygmo and OpenTURNS want it."""
        return [self.evaluate(x).value]

    def batch_fitness(self, vectors: Any) -> NDArray[numpy.float64]:
        """fitness() of many, several at once: rows give rows, one long vector (pygmo's) gives a vector."""
        import numpy

        given = numpy.asarray(vectors, dtype=numpy.float64)
        trials = self.evaluate_many(given.reshape(-1, max(1, len(self._coordinates))))
        values = numpy.array([trial.value for trial in trials])
        return values if given.ndim == 1 else values.reshape(-1, 1)

    def _point(self, x: Iterable[float]) -> tuple[int, list[int]]:
        """The number of an operation, and a point of its lattice."""
        values = [float(one) for one in x]
        if len(values) != len(self._coordinates):
            raise _outside("/x", f"has {len(values)} numbers, must have {len(self._coordinates)}")
        named = {}
        for i, (value, one) in enumerate(zip(values, self._coordinates)):
            if not one.lower - _ROUNDING <= value <= one.upper + _ROUNDING:
                raise _outside(f"/x/{i}", f"{one.name} is {value:g}, must be from {one.lower:g} to {one.upper:g}")
            named[one.name] = value
        chosen = tuple(words[round(named[name])] for name, words in self.choices.items())
        if chosen not in self._numbers:
            together = ", ".join(f"{name} {word}" for name, word in zip(self.choices, chosen))
            raise _outside("/x", f"is not offered: {together}")
        number = self._numbers[chosen]
        return number, [_index(one, named.get(one["name"])) for one in self._branches[number]["parameters"]]

    def _vector(self, number: int, at: Sequence[int] | None) -> tuple[float, ...]:
        """Of a point of an operation's lattice; None: where it starts."""
        branch = self._branches[number]
        values = {one.name: one.start for one in self._coordinates}
        for k, one in enumerate(branch["parameters"]):
            values[one["name"]] = one["lower"] + one["step"] * (one["start"] if at is None else at[k])
        values |= {name: words.index(branch[name]) for name, words in self.choices.items()}
        return tuple(float(values[one.name]) for one in self._coordinates)

    # What a Searcher asks.

    def _starts(self) -> list[tuple[float, ...]]:
        return [self._vector(number, None) for number in self._branches]

    def _neighbours(self, x: Sequence[float]) -> list[tuple[float, ...]]:
        """One and two steps away on the lattice of the operation, and with one other choice."""
        number, at = self._point(x)
        near = []
        for k, one in enumerate(self._branches[number]["parameters"]):
            for value in (at[k] - 2, at[k] - 1, at[k] + 1, at[k] + 2):
                if 0 <= value < one["count"]:
                    near.append(self._vector(number, [*at[:k], value, *at[k + 1 :]]))
        chosen = tuple(self._branches[number][name] for name in self.choices)
        sizes = len(self._coordinates) - len(self.choices)
        for other in self._numbers:
            if sum(a != b for a, b in zip(chosen, other)) == 1:
                numbers = [float(words.index(word)) for words, word in zip(self.choices.values(), other)]
                near.append((*x[:sizes], *numbers))
        return near

    def _place(self, x: Sequence[float]) -> list[float]:
        """Where the plan puts the valve; empty: the valve does not allow it."""
        place: list[float] = self._native.place(*self._point(x))
        return place


def _index(parameter: Mapping[str, Any], value: float | None) -> int:
    """Of the value of a lattice that is nearest."""
    if value is None:
        return 0
    nearest: int = round((value - parameter["lower"]) / parameter["step"])
    return max(0, min(int(parameter["count"]) - 1, nearest))


def _is_movement(numbered: tuple[int, Mapping[str, Any]]) -> bool:
    return str(numbered[1]["name"]).endswith("_movement_mm")


def _outside(path: str, message: str) -> InvalidRequest:
    return InvalidRequest(422, "outside the space", [Problem("out_of_range", path, message)])


def _decided(step: Mapping[str, Any]) -> tuple[str, ...]:
    place = step.get("insertion", {}).get("leaflet", "") if step["step"] == "neochorda" else ""
    ring = step.get("ring", {}).get("name", "")
    return (*(str(step.get(name, "")) for name in _DECIDED), place, ring)


def _operation(plan: Mapping[str, Any]) -> list[tuple[str, ...]]:
    """What plans share that differ in sizes, lengths and places alone."""
    return sorted(map(_decided, plan["steps"]))


def _distance(a: Mapping[str, Any], b: Mapping[str, Any]) -> float:
    """Between plans of one operation, over all numbers; a difference of a place counts more than any of lengths."""
    pairs = zip(sorted(a["steps"], key=_decided), sorted(b["steps"], key=_decided))
    return sum(_apart(one, other) for one, other in pairs)


def _apart(a: Mapping[str, Any], b: Mapping[str, Any]) -> float:
    apart = 0.0
    for name, value in a.items():
        other = b.get(name)
        if isinstance(value, Mapping) and isinstance(other, Mapping):
            apart += _apart(value, other)
        elif isinstance(value, (int, float)) and isinstance(other, (int, float)):
            apart += abs(value - other) * (1.0 if name.endswith("_mm") else _PLACE)
    return apart


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
