"""Leak of the same plans on three meshes, and who calls them competent: verdicts.csv."""

from style import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, each_once, figure_titled, legend_beside

COMPETENT_MM2 = 1.0  # objective.h
SHOWN_MM2 = 0.01  # smaller leaks lie on the border: both scales are logarithmic
COLOURS = (BLUE, ORANGE, GREEN, VERMILION, PURPLE, SKY)


def leak(row, mesh):
    """None where the closure is not trusted."""
    return max(SHOWN_MM2, float(row[f"{mesh}_leak_mm2"])) if row[f"{mesh}_trusted"] == "true" else None


def competent(row, mesh):
    return row[f"{mesh}_trusted"] == "true" and float(row[f"{mesh}_leak_mm2"]) < COMPETENT_MM2


def agreement(rows, mesh):
    """Plans that agree, are falsely called competent and falsely called leaking."""
    pairs = [(competent(row, mesh), competent(row, "reference")) for row in rows]
    return (
        sum(here == there for here, there in pairs),
        sum(here and not there for here, there in pairs),
        sum(there and not here for here, there in pairs),
    )


def draw_verdicts(rows):
    figure, axes = figure_titled("Leak of random plans against a mesh of 5,200 triangles", 11, 4.6, ncols=2)
    most = max(leak(row, mesh) or 0 for row in rows for mesh in ("own", "fine", "reference"))
    for axis, mesh, name in zip(axes, ("own", "fine"), ("the valve's own mesh", "refined once")):
        for colour, valve in zip(COLOURS, each_once(row["valve"] for row in rows)):
            of = [row for row in rows if row["valve"] == valve]
            points = [(leak(row, "reference"), leak(row, mesh)) for row in of]
            points = [(x, y) for x, y in points if x is not None and y is not None]
            held_out = of[0]["held_out"] == "true"
            axis.scatter(
                *zip(*points),
                s=22,
                marker="s" if held_out else "o",
                color=colour,
                alpha=0.75,
                label=valve + (" (held out)" if held_out else ""),
            )
        ends = [SHOWN_MM2, 1.3 * most]
        axis.plot(ends, ends, color=GREY, lw=0.8)
        axis.axhline(COMPETENT_MM2, color=GREY, ls="--", lw=0.8)
        axis.axvline(COMPETENT_MM2, color=GREY, ls="--", lw=0.8)
        agree, false_competent, false_leaks = agreement(rows, mesh)
        axis.set_title(
            f"{name}: {agree} of {len(rows)} verdicts agree,\n"
            f'{false_competent} false "competent", {false_leaks} false "leaks"',
            loc="left",
            fontsize=9.5,
        )
        axis.set(xscale="log", yscale="log", xlim=(0.9 * SHOWN_MM2, ends[1]), ylim=(0.9 * SHOWN_MM2, ends[1]))
        axis.set_xlabel("leak on 5,200 triangles, mm² (0.01 or less on the border)")
        axis.set_ylabel("leak, mm²")
    legend_beside(axes[-1])
    return figure
