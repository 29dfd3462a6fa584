"""The ranking rule, for plans that were evaluated elsewhere."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from dataclasses import dataclass

from .local_transport import engine_module


@dataclass(frozen=True)
class Merits:
    """Criteria for ranking a plan. The defaults are the best values; None: unknown, for all plans or for none.

    >>> coapt.Merits(steps=2, muscles=1).acceptable_probability
    1.0
    """

    acceptable_probability: float = 1.0
    """Probability that the valve leaks less than 5 mm², given the errors of execution, tissue and mesh."""
    steps: int = 0
    muscles: int = 0
    """That a suture moves."""
    free_anchors: int = 0
    """Of sutures: no landmark to find."""
    resections: int = 0
    """Of leaflets."""
    sizes_below: float = 0.0
    """Of the ring, the true size."""
    leak_mm2: float = 0.0
    """Mean and standard deviation over the region, added."""
    durability_mm: float | None = None
    """Reserve against progression: further remodelling until the valve leaks."""
    gradient_mmhg: float | None = None
    avoidable_warnings: int = 0
    cost: float = 0.0
    """Decides where nothing else does."""
    trusted: bool = True
    """As planned, on its own mesh."""
    varied: bool = True
    """Closed at more than one node of its region."""
    fails_often: bool = False
    """Its closures over the region."""
    rejected: bool = False
    """By a rule of practice."""
    stenotic: bool = False
    closes_finely: bool = True
    """On the finer mesh, too."""


@dataclass(frozen=True)
class Ordered:
    """A plan's place.

    >>> coapt.order_plans([coapt.Merits(), coapt.Merits(steps=1)])
    [Ordered(index=0, of_class=1), Ordered(index=1, of_class=1)]
    """

    index: int
    """Into the plans given."""
    of_class: int
    """Equivalence class, from 1: plans of one class are equivalent."""


def order_plans(
    plans: Iterable[Merits],
    *,
    by_price: bool = False,
    acceptable: float = 0.95,
    same_durability_mm: float = 2.0,
    same_gradient_mmhg: float = 1.0,
    enough_durability_mm: float = 6.5,
) -> list[Ordered]:
    """Best first, by the rule of the search: acceptable plans, of these plans without avoidable warnings, of equivalent plans the
    simplest.

    >>> ring = coapt.Merits(acceptable_probability=0.97, steps=1)
    >>> ring_and_suture = coapt.Merits(acceptable_probability=0.99, steps=2, muscles=1)
    >>> leaking = coapt.Merits(acceptable_probability=0.4, steps=1)
    >>> [place.index for place in coapt.order_plans([leaking, ring_and_suture, ring])]
    [2, 1, 0]

    :param by_price: acceptable plans by their cost instead
    :param acceptable: from that probability on a plan is
    :param same_durability_mm: within it of the longest of a class, plans last as long
    :param same_gradient_mmhg: within it of the least, or below what usual rings leave, gradients are alike
    :param enough_durability_mm: from it on plans last as long, too
    """
    told = [{k: math.nan if v is None else v for k, v in dataclasses.asdict(plan).items()} for plan in plans]
    places = engine_module().order(
        told, by_price, acceptable, same_durability_mm, same_gradient_mmhg, enough_durability_mm
    )
    return [Ordered(index, of_class) for index, of_class in places]
