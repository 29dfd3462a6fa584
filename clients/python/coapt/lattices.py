"""The plans that a search may try on a valve as a lattice of vectors of numbers."""

from __future__ import annotations

import json
import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .errors import InvalidRequest, Problem
from .local_transport import engine_module, refusing
from .repair import Plan
from .sources import PlanSource, plan_document

if TYPE_CHECKING:
    from . import _engine

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
_ROUNDING = 1e-9
_PLACE = 1e4  # mm for a place that is off by 1


@dataclass(frozen=True)
class _Coordinate:
    name: str
    lower: float
    upper: float
    step: float
    start: float


class Lattice:
    """What of a Space are vectors and plans; it closes nothing."""

    def __init__(self, valve: _engine.Valve, rules: Mapping[str, Any], like: Mapping[str, Any] | None) -> None:
        asked = json.dumps({"rules": dict(rules)})
        for indicated in (True,) if like is None else (True, False):
            with refusing():
                self._native = engine_module().Space(valve, asked, indicated)
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

    @property
    def names(self) -> tuple[str, ...]:
        """Of the numbers of a vector, with their units.

        >>> space.names[0]
        'ring_size_mm'
        """
        return tuple(one.name for one in self._coordinates)

    @property
    def lower(self) -> tuple[float, ...]:
        """Their least values.

        >>> space.lower[0]
        24.0
        """
        return tuple(one.lower for one in self._coordinates)

    @property
    def upper(self) -> tuple[float, ...]:
        """Their largest values.

        >>> space.upper[0]
        32.0
        """
        return tuple(one.upper for one in self._coordinates)

    @property
    def step(self) -> tuple[float, ...]:
        """From one value to the next.

        >>> space.step[0]
        2.0
        """
        return tuple(one.step for one in self._coordinates)

    @property
    def integer(self) -> tuple[bool, ...]:
        """Whether it is the number of a choice: these come last.

        >>> [name for name, integer in zip(space.names, space.integer) if integer] == list(space.choices)
        True
        """
        return tuple(one.name in self.choices for one in self._coordinates)

    @property
    def start(self) -> tuple[float, ...]:
        """What practice would try first of the simplest operation.

        >>> space.plan(space.start)
        Plan(...)
        """
        return self._vector(next(iter(self._branches)), None)

    def get_bounds(self) -> tuple[list[float], list[float]]:
        """lower and upper, as pygmo and scipy.optimize.Bounds take them.

        >>> space.get_bounds() == (list(space.lower), list(space.upper))
        True
        """
        return list(self.lower), list(self.upper)

    def get_nix(self) -> int:
        """How many integers there are.

        >>> space.get_nix()
        3
        """
        return len(self.choices)

    def plan(self, x: Iterable[float]) -> Plan:
        """The plan at a vector.

        >>> space.plan(space.upper).to_json()["schema"]
        'coapt.plan/1'

        :raises InvalidRequest: another length, a number outside its bounds, choices that are not offered together
        """
        return Plan.from_json(json.loads(self._native.plan(*self._point(x))))

    def vector(self, plan: PlanSource) -> tuple[float, ...]:
        """Of the plan of the space that is nearest to this one.

        >>> dict(zip(space.names, space.vector(plan)))["ring_size_mm"]
        32.0

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
        """Vectors at random: an operation, each as likely, and a point of its lattice.

        >>> len(space.random(3, seed=2))
        3
        """
        chance = random.Random(seed)
        numbers = list(self._branches)
        points = []
        for _ in range(count):
            number = chance.choice(numbers)
            points.append(
                self._vector(number, [chance.randrange(one["count"]) for one in self._branches[number]["parameters"]])
            )
        return points

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
