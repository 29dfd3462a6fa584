"""A search by ask and tell, for objectives that something else evaluates."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

from .local_transport import engine_module

Point: TypeAlias = tuple[float, ...]

_FIRST = 12  # starts of operations, before anything is expected of others
_AT_RANDOM = 60  # candidates at random, and so many more at each question
_MORE = 20
_BEST = 3  # points whose neighbours are candidates


class Searcher:
    """Proposes points of a Space and learns from what they are worth: first what practice would try of several operations, then where a
    Gaussian process over places of annulus, tips and chordae, the one of the engine's own search, expects most improvement. The same
    seed and values give the same points. Pickled, it goes on where it was.

    >>> space = coapt.preset("human-functional-mr").space()
    >>> searcher = space.searcher(seed=1)
    >>> for _ in range(2):
    ...     points = searcher.ask(6)
    ...     searcher.tell(points, [space(x) for x in points])
    >>> len(searcher.told), searcher.best[1] == min(value for _, value in searcher.told)
    (12, True)
    """

    def __init__(self, space: Any, seed: int = 1) -> None:
        """:param space: a Space"""
        self.space = space
        self.told: list[tuple[Point, float]] = []
        """Vectors and their values, in order."""
        self._chance = random.Random(seed)
        self._asked: dict[str, None] = {}  # plans, in order
        self._pool: list[Point] = []
        self._places: dict[Point, tuple[str, list[float]]] = {}

    def __repr__(self) -> str:
        return f"Searcher({self.space!r}, {len(self.told)} told)"

    @property
    def best(self) -> tuple[Point, float]:
        """The vector of least value, and that.

        >>> searcher = space.searcher()
        >>> searcher.tell([space.lower, space.upper], [2.0, 1.0])
        >>> searcher.best == (space.upper, 1.0)
        True

        :raises ValueError: nothing was told
        """
        return min(self.told, key=lambda one: one[1])

    def tell(self, vectors: Iterable[Iterable[float]], values: Iterable[float]) -> None:
        """What points are worth, asked for or not; less is better. Infinite or no number: refused.

        >>> searcher = space.searcher()
        >>> searcher.tell([space.start], [space(space.start)])
        """
        for x, value in zip(vectors, values, strict=True):
            point = tuple(map(float, x))
            self._asked[self._of(point)[0]] = None
            self.told.append((point, math.inf if math.isnan(value) else float(value)))

    def ask(self, count: int = 1) -> list[Point]:
        """Points to try next, none of which was asked for or told before: fewer than count where nothing is left.

        >>> len(space.searcher().ask(4))
        4
        """
        starts: list[Point] = self.space._starts()
        chosen: list[Point] = []
        while len(chosen) < count:
            x = self._first(starts) if len(self._asked) < _FIRST else self._expected(starts, chosen)
            if x is None and (x := self._expected(starts, chosen)) is None:
                break
            chosen.append(x)
            self._asked[self._of(x)[0]] = None
        return chosen

    def _of(self, x: Point) -> tuple[str, list[float]]:
        """The plan as text, and its place."""
        if x not in self._places:
            self._places[x] = repr(self.space.plan(x)), self.space._place(x)
        return self._places[x]

    def _is_new(self, x: Point) -> bool:
        plan, place = self._of(x)
        return bool(place) and plan not in self._asked

    def _first(self, starts: Sequence[Point]) -> Point | None:
        """Starts from all over the operations, the simplest first."""
        every = max(1, len(starts) // _FIRST)
        return next((x for x in [*starts[::every], *starts] if self._is_new(x)), None)

    def _expected(self, starts: Sequence[Point], chosen: Sequence[Point]) -> Point | None:
        """Where most improvement is expected, points that are being tried taken for what is expected of them."""
        if not chosen or not self._pool:
            more = _MORE if self._pool else _AT_RANDOM
            self._pool += self.space.random(more, self._chance.randrange(2**31))
            self._pool = list(filter(self._is_new, self._pool))
        known = sorted(self.told, key=lambda one: one[1])
        near = [x for best, value in known[:_BEST] if math.isfinite(value) for x in self.space._neighbours(best)]
        candidates: list[Point] = list(dict.fromkeys(filter(self._is_new, [*near, *self._pool, *starts])))
        if not candidates:
            return None
        worth = [value for _, value in known if math.isfinite(value)]
        if not worth:
            return self._chance.choice(candidates)
        values = _levelled(worth)
        told = [(self._of(x)[1], values.get(value, max(values.values()))) for x, value in known]
        told = [(place, value) for place, value in told if place]
        guess = engine_module().guess
        if chosen:
            tried = [self._of(x)[1] for x in chosen]
            told += list(zip(tried, guess(*_columns(told), 1.0, tried)[0]))
        means, sds = guess(*_columns(told), 1.0, [self._of(x)[1] for x in candidates])
        least = min(value for _, value in told)
        improvements = [_improvement(least - mean, sd) for mean, sd in zip(means, sds)]
        return candidates[improvements.index(max(improvements))]


def _levelled(worth: Sequence[float]) -> dict[float, float]:
    """Values, least first, of any scale as numbers of about one."""
    usual = worth[len(worth) // 2] - worth[0] or 1.0
    return {value: math.asinh((value - worth[0]) / usual) for value in worth}


def _columns(told: Sequence[tuple[list[float], float]]) -> tuple[list[list[float]], list[float]]:
    return [place for place, _ in told], [value for _, value in told]


def _improvement(by: float, sd: float) -> float:
    """Expected of a normal distribution."""
    if sd <= 0.0:
        return max(0.0, by)
    z = by / sd
    return by * 0.5 * math.erfc(-z / math.sqrt(2.0)) + sd * math.exp(-0.5 * z * z) / math.sqrt(2.0 * math.pi)
