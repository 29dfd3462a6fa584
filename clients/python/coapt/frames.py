"""Tables of pandas, which is imported when the first is asked for. What is not known is NaN, and text is printable. Columns that a
search's evaluations.csv has, too, have its names; its leak_mm2 is estimated."""

from __future__ import annotations

import dataclasses
import io
import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .errors import MissingPackage
from .repair import Plan
from .tables import printable

if TYPE_CHECKING:
    import pandas

MEASURE = {
    "leak_mm2": "measure.leak_mm2",
    "leak_error_mm2": "measure.leak.error_mm2",
    "coaptation_height_mean_mm": "measure.coaptation_height_mean_mm",
    "coaptation_height_min_mm": "measure.coaptation_height_min_mm",
    "tension_max_n": "measure.tension_max_n",
}
"""Columns of what has a measure, and where their values are."""

_SEVERAL = (
    "neochorda",
    "chordal_length_change",
    "chordal_excision",
    "chordal_transfer",
)  # steps that a plan has some of


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
        thing = "; ".join(thing)
    return float("nan") if thing is None else _shown(thing)


def _shown(value: Any) -> Any:
    return printable(value) if isinstance(value, str) else value


def table(things: Iterable[object], columns: Mapping[str, str]) -> pandas.DataFrame:
    """A row each.

    :param columns: their names, and where their values are: attributes joined by points
    """
    rows = [[_cell(thing, place) for place in columns.values()] for thing in things]
    frame: pandas.DataFrame = _pandas().DataFrame(rows, columns=list(columns))
    return frame


def with_steps(frame: pandas.DataFrame, plans: Iterable[Mapping[str, Any] | None]) -> pandas.DataFrame:
    """And a column for each number and word of the steps of the rows' plans (coapt.plan/1)."""
    steps = _pandas().DataFrame([step_columns(plan) for plan in plans], index=frame.index)
    joined: pandas.DataFrame = frame.join(steps)
    return joined


def step_columns(plan: Mapping[str, Any] | None) -> dict[str, Any]:
    """ "annuloplasty_size_mm", "papillary_approximation_posteromedial_suture_length_mm", "neochorda_1_length_mm", ..."""
    columns: dict[str, Any] = {}
    numbers: Counter[str] = Counter()
    for step in [] if plan is None else plan["steps"]:
        name = "_".join([step["step"], *([step["side"]] if "side" in step else [])])
        numbers[name] += 1
        several = step["step"] in _SEVERAL or numbers[name] > 1
        prefix = f"{name}_{numbers[name]}" if several else name
        told = {key: value for key, value in step.items() if key not in ("step", "side")}
        for key, value in {**told, **told.get("insertion", {})}.items():
            if not isinstance(value, Mapping):
                columns[f"{prefix}_{key}"] = value
    return {printable(name): _shown(value) for name, value in columns.items()}


def records(kind: Any, things: Iterable[object]) -> pandas.DataFrame:
    """A row each, a column for each field of their dataclass."""
    return table(things, {one.name: one.name for one in dataclasses.fields(kind)})


def leaks(rows: Sequence[tuple[Any, ...]], columns: Sequence[str]) -> pandas.DataFrame:
    """leak_mm2, one of the columns, may be unknown."""
    shown = [tuple(map(_shown, row)) for row in rows]
    frame: pandas.DataFrame = _pandas().DataFrame(shown, columns=list(columns)).astype({"leak_mm2": float})
    return frame


def csv(text: str) -> pandas.DataFrame:
    lines = text.replace("\r\n", "\n").split("\n")
    frame: pandas.DataFrame = _pandas().read_csv(io.StringIO("\n".join(map(printable, lines))))
    return frame
