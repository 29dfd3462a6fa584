"""Small tables and drawings for notebooks: what they are put together of. Each says what coapt is not."""

from __future__ import annotations

import dataclasses
import html
import math
import re
from collections.abc import Iterable, Sequence
from typing import Any

NOTICE = "coapt is research software, not a medical device; not for clinical decisions."
NOTICE_HTML = f'<p style="font-size:smaller;opacity:.75">{NOTICE}</p>'
_BAR_WIDTH, _BAR_HEIGHT = 36, 90  # of the drawing of coaptation, px
_LONG = 80  # letters of one value
_LEAST_RANGE_MM = 10.0  # that its height stands for


def printable(text: object) -> str:
    """What others wrote, in one line: without what moves a terminal, turns the direction of what follows, or is no character."""
    return re.sub("[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]", " ", str(text))


def escaped(text: object) -> str:
    """The same in HTML."""
    return html.escape(printable(text))


class Short:
    """A dataclass (repr=False) that prints in a few lines at most: numbers to four digits, of long lists and of what prints so itself only
    what it is."""

    def __repr__(self) -> str:
        fields: Any = dataclasses.fields(self)
        told = (f"{one.name}={_short(getattr(self, one.name))}" for one in fields if one.repr)
        return f"{type(self).__name__}({', '.join(told)})"


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, Short):
        return f"{type(value).__name__}(...)"
    if isinstance(value, tuple):
        if len(value) > 3 or any(isinstance(one, (Short, tuple)) for one in value):
            return f"<{len(value)} of {type(value[0]).__name__}>"
        return f"({', '.join(map(_short, value))})"
    text = repr(value)
    return text if len(text) <= _LONG else f"{text[:_LONG]}..."


def number(value: float | None, decimals: int = 1) -> str:
    """A dash where it is not known; never "-0.0"."""
    if value is None:
        return "-"
    return f"{round(value, decimals) + 0.0:.{decimals}f}"


def counted(count: int, one: str, many: str = "") -> str:
    """1 closure, 0 closures, 2 chordae."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def with_error(value: float | None, error: float | None) -> str:
    """45.7 ± 2.1, 46 ± 5: the error to two digits where they are 10 to 35, else to one (Particle Data Group 2022, 5.3)."""
    if value is None or error is None:
        return number(value)
    decimals = 1
    if error > 0.0:
        exponent = math.floor(math.log10(error))
        leading = error / 10.0**exponent
        next_decade = leading >= 9.5
        two_digits = leading < 3.55 or next_decade
        decimals = min(3, max(0, int(two_digits) - exponent - int(next_decade)))
    return f"{number(value, decimals)} ± {number(error, decimals)}"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Cells are HTML."""
    top = "".join(f"<th>{cell}</th>" for cell in head)
    body = "".join(
        "<tr>" + "".join(f'<td style="text-align:left">{cell}</td>' for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>" if head else f"<table>{body}</table>"


def listed(lines: Iterable[str], mark: str = "") -> str:
    """Text, a line each."""
    return "<br>".join(mark + escaped(line) for line in lines)


def coaptation_svg(sections: Sequence[Any]) -> str:
    """Bars of coaptation height along the line of coaptation; a section whose leaflets do not touch has its distance in red
    below the line."""
    middle = _BAR_HEIGHT
    scale = _BAR_HEIGHT / max([_LEAST_RANGE_MM, *(section["height_mm"] or 0.0 for section in sections)])
    bars = []
    for i, section in enumerate(sections):
        x, height, apart = i * _BAR_WIDTH, section["height_mm"] or 0.0, section["distance_mm"] or 0.0
        if section["contact"]:
            up = height * scale
            bars.append(
                f'<rect x="{x + 3}" y="{middle - up:.1f}" width="{_BAR_WIDTH - 6}" height="{up:.1f}" fill="#3b7dd8">'
                f"<title>{number(height)} mm coaptation</title></rect>"
            )
        else:
            down = min(apart * scale, middle) / 2
            bars.append(
                f'<rect x="{x + 3}" y="{middle}" width="{_BAR_WIDTH - 6}" height="{down:.1f}" fill="#c8372d">'
                f"<title>{number(apart)} mm apart</title></rect>"
            )
        label = number(height if section["contact"] else apart)
        bars.append(f'<text x="{x + _BAR_WIDTH / 2}" y="{1.5 * middle + 16}" text-anchor="middle">{label}</text>')
    width, bottom = len(sections) * _BAR_WIDTH, 1.5 * middle + 34
    return (
        f'<svg role="img" aria-label="coaptation along the valve" width="{width}" height="{bottom + 4}" '
        f'style="font:11px sans-serif;fill:currentColor">{"".join(bars)}'
        f'<line x1="0" x2="{width}" y1="{middle}" y2="{middle}" stroke="currentColor"/>'
        f'<text x="0" y="{bottom}">anterolateral</text><text x="{width}" y="{bottom}" text-anchor="end">posteromedial</text>'
        "</svg>"
    )


def state(status: str, crossing: bool) -> str:
    return f"{status}, {'leaflets cross' if crossing else 'no crossing'}"
