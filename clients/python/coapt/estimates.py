"""A number with what is known of its errors by cause, and what is said of it: the rules and words of the command line
(core/metrics/estimate.h, estimate_text.h)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from . import tables

Interval: TypeAlias = tuple[float, float]

_CAUSES = {"numerical": "numerical error", "tissue": "tissue error", "execution": "errors of execution"}
_TENTHS = 0.4  # the least error that leaves no more digits


def interval(json: Any) -> Interval | None:
    return None if json is None else (json[0], json[1])


def interval_words(of: Interval | None) -> str:
    """ "0.1 to 3.5", "16 to 78": to a tenth, or to fewer digits where half its width leaves no more; "-": not known."""
    if of is None:
        return "-"
    low, high = of
    half = 0.5 * (high - low)
    return f"{_known(low, half)} to {_known(high, half)}"


@dataclass(frozen=True, repr=False)
class Estimate(tables.Short):
    """A number and, apart by cause, intervals from 5 to 95 %. The errors are not added; None: not known.

    >>> leak = coapt.preset("human-functional-mr").evaluate([Plan(OwnRing(2))]).plans[0].leak
    >>> low, high = leak.numerical
    >>> low <= leak.value <= high, "mm²" in leak.words("mm²")
    (True, True)
    """

    value: float | None
    numerical: Interval | None = None
    """Mesh, stopping early, other ends of the closure."""
    tissue: Interval | None = None
    """Uncertain tissue and chordae."""
    execution: Interval | None = None
    """Errors of execution of a plan."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any], value: str = "value") -> Estimate:
        """:param value: the member that has the number"""
        return cls(json[value], *(interval(json.get(cause)) for cause in _CAUSES))

    @property
    def cause(self) -> str | None:
        """Of the widest interval: "numerical", "tissue" or "execution"; the tissue where it excludes the value.

        >>> Estimate(46.0, numerical=(43.0, 49.0), tissue=(16.0, 78.0)).cause
        'tissue'
        """
        if self._tissue_excludes_value():
            return "tissue"
        known = {cause: getattr(self, cause) for cause in _CAUSES}
        widths = {cause: part[1] - part[0] for cause, part in known.items() if part is not None}
        return max(widths, key=widths.__getitem__) if widths else None

    @property
    def widest(self) -> Interval | None:
        """The interval of this cause.

        >>> Estimate(46.0, numerical=(43.0, 49.0), tissue=(16.0, 78.0)).widest
        (16.0, 78.0)
        """
        cause = self.cause
        return None if cause is None else getattr(self, cause)

    def words(self, unit: str = "") -> str:
        """ "3.32 ± 0.23 N" of the numerical error, else "46 mm²; 16 to 78 mm² with tissue error (5 to 95 %)".

        >>> Estimate(46.0, tissue=(16.0, 78.0)).words("mm²")
        '46 mm²; 16 to 78 mm² with tissue error (5 to 95 %)'
        """
        of, cause, wide = f" {unit}" if unit else "", self.cause, self.widest
        if self.value is None or cause is None or wide is None:
            return tables.number(self.value) + (of if self.value is not None else "")
        low, high = wide
        if cause == "numerical" and low <= self.value <= high:
            return tables.with_error(self.value, high - self.value) + of
        value, spread = _known(self.value, 0.5 * (high - low)), interval_words(wide)
        if cause == "tissue" and self._tissue_excludes_value():
            return f"{spread}{of}; {value}{of} with the tissue of its file"
        return f"{value}{of}; {spread}{of} with {_CAUSES[cause]} (5 to 95 %)"

    def __str__(self) -> str:
        return self.words()

    def _tissue_excludes_value(self) -> bool:
        if self.tissue is None or self.value is None:
            return False
        low, high = self.numerical or (self.value, self.value)
        return high < self.tissue[0] or low > self.tissue[1]


def _known(value: float, error: float) -> str:
    return tables.with_error(value, max(_TENTHS, error)).split(" ± ")[0] if math.isfinite(value) else "n/a"
