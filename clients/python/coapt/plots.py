"""Drawings with matplotlib, which is imported when the first is asked for. Each takes axes (ax=) or makes new ones, and returns
them.

>>> from coapt import plots
>>> closure = coapt.preset("human-functional-mr").close()
>>> plots.atrial_view(closure).figure.savefig("closed.pdf")
>>> plots.section(closure).figure.savefig("section.pdf")
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import cycle
from typing import TYPE_CHECKING, Any, Literal

from .errors import MissingPackage
from .steps import PapillaryApproximation

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .closures import Closure
    from .evidence import Muscle
    from .ranked_plans import RankedPlan
    from .results import Evaluations, SearchResult

LEAKS_MM2 = 1.0  # a leak that counts, as in margins: a map's scale ends there or beyond
_BLUE, _RED, _GREY = "#3b7dd8", "#c8372d", "#9aa3ad"
# Colours that colour-blind readers tell apart (Okabe and Ito 2008), each with a marker of its own.
_LINES = (("#0072b2", "o"), ("#d55e00", "s"), ("#009e73", "^"), ("#cc79a7", "D"), ("#56b4e9", "v"), ("#e69f00", "P"))
_UNKNOWN = float("nan")


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise MissingPackage(
            "a drawing needs matplotlib: pip install matplotlib, or apt install python3-matplotlib"
        ) from error
    return pyplot.subplots(layout="constrained")[1]


def _numbers(values: Iterable[float | None]) -> list[float]:
    return [_UNKNOWN if value is None else value for value in values]


def leak_map(
    plan: RankedPlan, muscle: Muscle = "both", *, most_mm2: float | None = None, ax: Axes | None = None
) -> Axes:
    """Leak versus errors of suture length and of the angle of the tips. A frame marks the plan; cells not closed are hatched.

    >>> plots.leak_map(best).figure.savefig("map.pdf")

    :param most_mm2: end of the colour scale, so that maps can be compared; by default the map's largest leak, 1 mm2 at least
    :raises KeyError: the plan has no map of this muscle
    """
    one, axes = plan.leak_maps.of(muscle), _axes(ax)
    known = [leak for row in one.leak_mm2 for leak in row if leak is not None]
    lengths, angles = one.suture_length_mm, one.outwards_deg
    axes.patch.set(facecolor="white", edgecolor=_GREY, hatch="////")
    cells = axes.pcolormesh(
        angles,
        lengths,
        list(map(_numbers, one.leak_mm2)),
        shading="nearest",
        cmap="viridis_r",
        vmin=0.0,
        vmax=most_mm2 or max([LEAKS_MM2, *known]),
    )
    width, height = angles[1] - angles[0], lengths[1] - lengths[0]
    axes.add_patch(_frame(-width / 2, -height / 2, width, height))
    axes.set_xlabel("outward error of the tip, degrees")
    sutured = any(isinstance(step, PapillaryApproximation) for step in plan.plan.steps)
    axes.set_ylabel(f"{'suture length' if sutured else 'tip to trigone'} error, mm")
    axes.figure.colorbar(cells, ax=axes, label="leak, mm²", extend="neither" if most_mm2 is None else "max")
    return axes


def _frame(x: float, y: float, width: float, height: float) -> Any:
    from matplotlib.patches import Rectangle

    return Rectangle((x, y), width, height, fill=False, edgecolor="black", linewidth=1.5)


def coaptation(closure: Closure, *, ax: Axes | None = None) -> Axes:
    """Coaptation height in nine sections (blue); where leaflets do not coapt, their distance (red, downwards).

    >>> plots.coaptation(closure).get_ylabel()
    'coaptation height or distance, mm'
    """
    axes, sections = _axes(ax), closure.measure.coaptation.sections
    width = 0.8 / len(sections)
    for label, colour, contact in (("coaptation height", _BLUE, True), ("leaflets apart", _RED, False)):
        shown = [one for one in sections if one.contact == contact]
        if shown:
            heights = _numbers(one.height_mm if contact else one.distance_mm for one in shown)
            bars = heights if contact else [-height for height in heights]
            axes.bar([one.along for one in shown], bars, width, color=colour, label=label)
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.set_xlim(0.0, 1.0)
    axes.set_xticks([0.0, 0.5, 1.0], ["anterolateral\ncommissure", "A2 and P2", "posteromedial\ncommissure"])
    axes.yaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
    axes.set_ylabel("coaptation height or distance, mm")
    axes.legend()
    return axes


def atrial_view(closure: Closure, *, ax: Axes | None = None) -> Axes:
    """The closed leaflets seen from the atrium: anterior up, the anterolateral side left; colours are heights above the
    annulus, blue lines the rims of the leak's openings. Leaflets are drawn without their thickness.

    >>> plots.atrial_view(closure).figure.savefig("closed.pdf")
    """
    axes, mesh = _axes(ax), closure.leaflets()
    points, faces = _rows(mesh.vertices_mm), _rows(mesh.faces)
    height = [sum(points[corner][2] for corner in face) / 3.0 for face in faces]
    order = sorted(range(len(faces)), key=height.__getitem__)  # what is higher hides what is lower
    drawn = axes.tripcolor(
        [point[0] for point in points],
        [point[1] for point in points],
        [faces[i] for i in order],
        facecolors=[height[i] for i in order],
        cmap="copper",
        edgecolors="face",
        linewidth=0.2,
    )
    for opening in closure.measure.leak.openings:
        axes.fill(*list(zip(*opening.outline_mm))[:2], fill=False, edgecolor=_BLUE, linewidth=1.5)
    axes.set_aspect("equal")
    axes.set_xlabel("to the posteromedial commissure, mm")
    axes.set_ylabel("anterior, mm")
    axes.figure.colorbar(drawn, ax=axes, label="above the annulus, mm")
    return axes


def section(closure: Closure, x_mm: float = 0.0, *, ax: Axes | None = None) -> Axes:
    """The closed leaflets cut by the plane x = x_mm (0: through the annulus's middle, A2 and P2), the atrium above.

    >>> plots.section(closure, x_mm=5).get_xlabel()
    'anterior, mm'
    """
    from matplotlib.collections import LineCollection

    axes, mesh = _axes(ax), closure.leaflets()
    points, pieces = _rows(mesh.vertices_mm), []
    for face in _rows(mesh.faces):
        corners = [points[corner] for corner in face]
        cut = [
            [a[k] + (x_mm - a[0]) / (b[0] - a[0]) * (b[k] - a[k]) for k in (1, 2)]
            for a, b in zip(corners, corners[1:] + corners[:1])
            if (a[0] < x_mm) != (b[0] < x_mm)
        ]
        if cut:
            pieces.append(cut)
    axes.add_collection(LineCollection(pieces, colors=_RED, linewidths=1.5))
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_xlabel("anterior, mm")
    axes.set_ylabel("to the atrium, mm")
    return axes


def _rows(array: Any) -> list[Any]:
    """Of numpy, or lists already."""
    rows: list[Any] = array.tolist() if hasattr(array, "tolist") else array
    return rows


_AGAINST = {
    "tension_max_n": "highest chordal tension, N",
    "opening_area_mm2": "opening in diastole, mm²",
    "durability_mm": "reserve against progression, mm",
}


def plans(
    result: SearchResult | Evaluations,
    against: Literal["tension_max_n", "opening_area_mm2", "durability_mm"] = "tension_max_n",
    *,
    ax: Axes | None = None,
) -> Axes:
    """Trade-offs of ranked plans: tension, opening or reserve versus the leak as planned, with its widest interval from 5 to 95 % (errors of
    execution, tissue or the computation). Numbers are ranks, filled points Pareto-optimal plans. Plans with unknown values are omitted.

    >>> plots.plans(result, "opening_area_mm2").get_ylabel()
    'opening in diastole, mm²'
    """
    axes = _axes(ax)
    for plan in result.plans:
        leak = plan.leak
        value = plan.measure.tension_max_n if against == "tension_max_n" else getattr(plan, against)
        if leak.value is not None and value is not None:
            inside = _BLUE if plan.pareto else "white"
            if leak.widest is not None:
                axes.plot(leak.widest, [value, value], color=_GREY)
            axes.plot([leak.value], [value], "o", color=_BLUE, markerfacecolor=inside)
            axes.annotate(str(plan.rank), (leak.value, value), xytext=(5, 5), textcoords="offset points")
    axes.margins(y=0.15)  # a rank stands above its point
    axes.set_xlim(left=-0.03 * max(1.0, axes.get_xlim()[1]))
    axes.set_xlabel("leak as planned, mm², and its widest error, 5 to 95 %")
    axes.set_ylabel(_AGAINST[against])
    return axes


def progress(result: SearchResult, *, ax: Axes | None = None) -> Axes:
    """Search score of the best plan so far versus closures, and the expectation for a random search.

    >>> plots.progress(result).get_xlabel()
    'closures'
    """
    axes, highest = _axes(ax), 0.0
    for name, label, style in (("progress", "search", "-"), ("random_progress", "random search, expected", "--")):
        points: Sequence[Mapping[str, Any]] = [one for one in result.json[name] if one["cost"] is not None]
        if len(points) > 1:
            closures, costs = [one["closures"] for one in points], [one["cost"] for one in points]
            highest = max([highest, *costs])
            axes.step(closures, costs, style, where="post", color=_BLUE if name == "progress" else _GREY, label=label)
    if highest > 20.0:  # mm2: else a linear scale shows more
        axes.set_yscale("symlog", linthresh=1.0)
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_ylim(0.0, 1.2 * highest if highest else 1.0)
    axes.set_xlabel("closures")
    axes.set_ylabel("search score of the best plan so far, steps")
    axes.legend()
    return axes


def remodelling(plan: RankedPlan, *, ax: Axes | None = None) -> Axes:
    """Leak versus further papillary displacement after the repair, one line per direction.

    >>> plots.remodelling(best).figure.savefig("remodelling.pdf")
    """
    axes, curves = _axes(ax), plan.remodelling
    for (direction, leaks), (colour, marker) in zip(curves.leak_mm2.items(), cycle(_LINES)):
        shown = {"color": colour, "marker": marker, "markersize": 5, "alpha": 0.8, "clip_on": False}
        axes.plot(curves.displacement_mm[: len(leaks)], _numbers(leaks), label=direction, **shown)
    axes.axhline(LEAKS_MM2, color=_GREY, linestyle="--", linewidth=0.8)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("further remodelling, mm")
    axes.set_ylabel("leak, mm²")
    axes.legend()
    return axes
