"""Small tables and drawings for notebooks. Each says what coapt is not."""

from __future__ import annotations

import base64
import html
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .closures import Closure, Measure
    from .meshes import Picture
    from .openings import Opening
    from .ranked_plans import RankedPlan
    from .results import Before, StudyResult

NOTICE = "coapt is research software, not a medical device; not for clinical decisions."
_NOTICE_HTML = f'<p style="font-size:smaller;opacity:.75">{NOTICE}</p>'
_BAR_WIDTH, _BAR_HEIGHT = 36, 90  # of the drawing of coaptation, px
_LEAST_RANGE_MM = 10.0  # that its height stands for


def number(value: float | None, decimals: int = 1) -> str:
    """A dash where it is not known; never "-0.0"."""
    if value is None:
        return "-"
    return f"{round(value, decimals) + 0.0:.{decimals}f}"


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


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Cells are HTML."""
    top = "".join(f"<th>{cell}</th>" for cell in head)
    body = "".join(
        "<tr>" + "".join(f'<td style="text-align:left">{cell}</td>' for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>" if head else f"<table>{body}</table>"


def _list(lines: Iterable[str], mark: str = "") -> str:
    return "<br>".join(mark + html.escape(line) for line in lines)


def _figures(measure: Measure) -> list[tuple[str, str]]:
    return [
        ("leak", f"<b>{with_error(measure.leak_mm2, measure.leak_mm2_error)} mm²</b>, the larger of orifice and gap"),
        ("orifice seen from the atrium", f"{with_error(measure.orifice_area_mm2, measure.orifice_area_mm2_error)} mm²"),
        ("gap between the leaflets", f"{with_error(measure.gap_area_mm2, measure.gap_area_mm2_error)} mm²"),
        (
            "coaptation height",
            f"mean {number(measure.coaptation_height_mean_mm)}, min " f"{number(measure.coaptation_height_min_mm)} mm",
        ),
        ("largest chordal tension", f"{number(measure.tension_max_n, 2)} N"),
        ("annulus", f"AP {number(measure.annulus_ap_mm)}, AL-PM {number(measure.annulus_al_pm_mm)} mm"),
    ]


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


def _state(status: str, crossing: bool) -> str:
    return f"{status}, {'leaflets cross' if crossing else 'no crossing'}"


def closure_html(closure: Closure) -> str:
    warned = "" if closure.trusted else "<p><b>These figures do not count.</b></p>"
    bars = coaptation_svg(closure.measure.json["coaptation"]["sections"])
    return (
        f"<h4>{html.escape(closure.valve)}: {_state(closure.status, closure.crossing)}</h4>{warned}"
        f"{_table((), _figures(closure.measure))}"
        f"<p>Coaptation height at nine sections, mm (blue); leaflets apart, mm (red)</p>{bars}"
        f"<p>{_list(closure.warnings, '! ')}</p>{_NOTICE_HTML}"
    )


def opening_html(opening: Opening) -> str:
    warned = "" if opening.trusted else "<p><b>These figures do not count.</b></p>"
    rest, exercise = number(opening.gradient_mmhg), number(opening.gradient_exercise_mmhg)
    rows = [
        ("narrowest passage", f"<b>{_cm2(opening.opening_area_mm2)}</b>"),
        ("seen along the annulus's normal", _cm2(opening.projected_area_mm2)),
        ("annulus in diastole", _cm2(opening.annulus_area_mm2)),
        ("mean gradient", f"{rest} mmHg at {number(opening.flow_ml_s, 0)} ml/s"),
        ("at exercise", f"{exercise} mmHg at {number(opening.flow_exercise_ml_s, 0)} ml/s"),
    ]
    return (
        f"<h4>{html.escape(opening.name)}, open: {_state(opening.status, opening.crossing)}</h4>{warned}"
        f"{_table((), rows)}<p>{_list(opening.warnings, '! ')}</p>{_NOTICE_HTML}"
    )


def _cm2(mm2: float | None) -> str:
    return f"{number(None if mm2 is None else 0.01 * mm2)} cm²"


_FARTHEST_MM, _FARTHEST_DEG = 1.0, 5.0  # borders of the region of interest: a margin there may be larger


def _margin(value: float | None, farthest: float, decimals: int, unit: str) -> list[str]:
    return [] if value is None else [f"{'more than ' * (value >= farthest)}{number(value, decimals)}{unit}"]


_PLANS_HEAD = ("", "plan", "leak as planned, mm²", "mean ± sd over the region", "worst", "margin", "tension, N")


def _plan_row(plan: RankedPlan) -> tuple[str, ...]:
    leak = plan.leak_mm2
    margins = _margin(plan.margin_mm, _FARTHEST_MM, 2, " mm") + _margin(plan.margin_deg, _FARTHEST_DEG, 1, "°")
    what = _list(plan.description) or "no repair"
    settled = plan.status == "converged" and not plan.crossing
    warnings = (() if settled else (_state(plan.status, plan.crossing),)) + plan.warnings
    warned = f"<br><small>{_list(warnings, '! ')}</small>" if warnings else ""
    tie = "<br><small>ties with the next</small>" if plan.tie_with_next else ""
    return (
        str(plan.rank),
        what + warned + tie,
        number(leak.nominal),
        f"{number(leak.mean)} ± {number(leak.sd)}",
        number(leak.worst),
        ", ".join(margins) or "-",
        number(plan.measure.tension_max_n, 2),
    )


def plan_html(plan: RankedPlan, picture: Picture | None) -> str:
    shown = ""
    if picture is not None:
        content = base64.b64encode(picture.png).decode()
        shown = f'<img alt="view from the atrium, before and after" style="max-width:100%" src="data:image/png;base64,{content}">'
    return _table(_PLANS_HEAD, [_plan_row(plan)]) + shown + _NOTICE_HTML


def plans_html(before: Before, plans: Sequence[RankedPlan]) -> str:
    state = (
        f"<p>Before: leak {number(before.measure.leak_mm2)} mm², orifice {number(before.measure.orifice_area_mm2)} mm², "
        f"{_state(before.status, before.crossing)}</p>"
    )
    return state + _table(_PLANS_HEAD, map(_plan_row, plans)) + _NOTICE_HTML


def findings_html(result: StudyResult) -> str:
    rows = [
        (
            "agrees" if finding.agrees else "<b>differs</b>",
            html.escape(finding.finding),
            html.escape(finding.thesis),
            html.escape(finding.ours),
        )
        for finding in result.findings
    ]
    return _table(("", "finding", "thesis", html.escape(result.valve)), rows) + _NOTICE_HTML
