"""Tables of pandas, which is imported when the first is asked for. What is not known is NaN. Columns that a search's
evaluations.csv has, too, have its names."""

from __future__ import annotations

import io
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .errors import MissingPackage
from .repair import Plan

if TYPE_CHECKING:
    import pandas

    from .evidence import LeakMap, Remodelling, Section
    from .ranked_plans import RankedPlan
    from .results import Finding
    from .sweep import SweepItem

# Columns, and where their values are.
_SECTION = {name: name for name in ("along", "height_mm", "distance_mm", "contact")}
_FINDING = {name: name for name in ("finding", "section", "thesis", "ours", "judged", "agrees")}
_MEASURE = {
    "leak_mm2": "measure.leak_mm2",
    "orifice_mm2": "measure.orifice_area_mm2",
    "gap_mm2": "measure.gap_area_mm2",
    "coaptation_height_mean_mm": "measure.coaptation_height_mean_mm",
    "coaptation_height_min_mm": "measure.coaptation_height_min_mm",
    "tension_max_n": "measure.tension_max_n",
}
_PLAN = {
    "rank": "rank",
    "description": "description",
    "cost_mm2": "cost",
    "nodes": "region_closures",
    "failed_nodes": "region_failures",
    "mean_leak_mm2": "leak_mm2.mean",
    "sd_leak_mm2": "leak_mm2.sd",
    "p95_leak_mm2": "leak_mm2.p95",
    "worst_leak_mm2": "leak_mm2.worst",
    **_MEASURE,
    "margin_mm": "margin_mm",
    "margin_deg": "margin_deg",
    "status": "status",
    "crossing": "crossing",
    "pareto": "pareto",
    "tie_with_next": "tie_with_next",
    "closes_robustly": "closes_robustly",
    "plan": "plan",
}
_SWEEP = {
    "valve_number": "valve_number",
    "plan_number": "plan_number",
    "valve": "valve",
    "plan": "plan",
    "trusted": "trusted",
    "status": "closure.status",
    "crossing": "closure.crossing",
    **{column: f"closure.{place}" for column, place in _MEASURE.items()},
    "annulus_ap_mm": "closure.measure.annulus_ap_mm",
    "annulus_al_pm_mm": "closure.measure.annulus_al_pm_mm",
    "tenting_height_mm": "closure.measure.tenting_height_mm",
    "tension_sum_n": "closure.measure.tension_sum_n",
    "strain_circumferential_max": "closure.measure.strain_circumferential_max",
    "strain_radial_max": "closure.measure.strain_radial_max",
    "error": "problem",
}


def _pandas() -> Any:
    try:
        import pandas
    except ImportError as error:
        raise MissingPackage("a table needs pandas: pip install pandas, or apt install python3-pandas") from error
    return pandas


def _cell(thing: object, place: str) -> Any:
    for name in place.split("."):
        if thing is None:
            break
        thing = getattr(thing, name)
    if isinstance(thing, Plan):
        return json.dumps(thing.to_json())
    if isinstance(thing, tuple):
        return "; ".join(thing)
    return float("nan") if thing is None else thing


def _frame(things: Iterable[object], columns: Mapping[str, str]) -> pandas.DataFrame:
    rows = [[_cell(thing, place) for place in columns.values()] for thing in things]
    frame: pandas.DataFrame = _pandas().DataFrame(rows, columns=list(columns))
    return frame


def sections(rows: Sequence[Section]) -> pandas.DataFrame:
    return _frame(rows, _SECTION)


def findings(rows: Sequence[Finding]) -> pandas.DataFrame:
    return _frame(rows, _FINDING)


def plans(ranked: Sequence[RankedPlan]) -> pandas.DataFrame:
    return _frame(ranked, _PLAN)


def sweep(items: Iterable[SweepItem]) -> pandas.DataFrame:
    return _frame(items, _SWEEP)


def leak_maps(maps: Sequence[LeakMap]) -> pandas.DataFrame:
    rows = [
        (one.muscle, length, angle, leak)
        for one in maps
        for length, leaks in zip(one.suture_length_mm, one.leak_mm2)
        for angle, leak in zip(one.outwards_deg, leaks)
    ]
    return _numbers(rows, ("muscle", "suture_length_mm", "outwards_deg", "leak_mm2"))


def remodelling(curves: Remodelling) -> pandas.DataFrame:
    rows = [
        (direction, displacement, leak)
        for direction, leaks in curves.leak_mm2.items()
        for displacement, leak in zip(curves.displacement_mm, leaks)
    ]
    return _numbers(rows, ("direction", "displacement_mm", "leak_mm2"))


def _numbers(rows: Sequence[tuple[Any, ...]], columns: Sequence[str]) -> pandas.DataFrame:
    """leak_mm2 may be unknown."""
    frame: pandas.DataFrame = _pandas().DataFrame(rows, columns=list(columns)).astype({"leak_mm2": float})
    return frame


def csv(text: str) -> pandas.DataFrame:
    frame: pandas.DataFrame = _pandas().read_csv(io.StringIO(text))
    return frame
