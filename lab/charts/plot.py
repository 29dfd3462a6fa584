#!/usr/bin/python3
"""Draws the laboratory's tables: the file's name says which chart it is.

ablation.csv            what each ingredient of a closure buys and costs
speed-accuracy.csv      distance from a reference, and error of the leak, against time
stability.csv           where each method closes a valve and where it fails
front-rise.csv          how much of what plans trade the search and its rivals have found
ecdf.csv                share of targets that the search and its rivals reach
mesh.csv                error of leaks and shapes against the number of triangles
uniqueness.csv          how unique the closed state is, over the leaflets' rigidity
indications.csv         in how many settings of the thresholds the first plans of valves stay first
verdicts.csv            leak and verdict of the same plans on three meshes
twins.csv               fitted against true values of valves whose answers are known
growth.csv              time of the parts of a closure against the number of triangles
hostile-memory.csv      memory of the service over the time of `tests/service/hostile.py --curve`
attacks.csv             waits and memory under attack, in release 0.2 and now
"""

import argparse
import csv
import io
import pathlib
import statistics

import attacks
import front_rise
import growth
import indications
import mesh
import twins
import uniqueness
import verdicts
from matplotlib.patches import Patch, Rectangle
from matplotlib.ticker import FuncFormatter
from PIL import Image
from style import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PLAIN,
    PURPLE,
    SKY,
    VERMILION,
    YELLOW,
    each_once,
    figure_titled,
    legend_beside,
    numbers,
    plt,
    title,
)

# Speed against accuracy.

KINDS = {
    ("fast", "springs"): ("fast, springs", BLUE, "o"),
    ("fast", "continuum"): ("fast, continuum", VERMILION, "s"),
    ("thesis", "springs"): ("thesis", GREEN, "^"),
}
MEMBRANE = "continuum"  # default
# Table 2.2 of the thesis: distance from imaging; chapter 4: time of a configuration.
THESIS_MS, THESIS_MM = 1e4, (0.56, 0.82)


def front(points):
    """Those that no other beats in both time and error, in order of time."""
    best = []
    for time, error in sorted(points):
        if not best or error < best[-1][1]:
            best.append((time, error))
    return best


def draw_against_time(rows, heading, label, error, from_imaging=False):
    rows = [row for row in rows if row["status"] == "converged" and row["crossing"] == "false"]
    scenes = each_once(row["scene"] for row in rows)
    figure, axes = figure_titled(heading, 10, 4.6, ncols=len(scenes), sharey=True, sharex=True, squeeze=False)
    for axis, scene in zip(axes[0], scenes):
        here = [row for row in rows if row["scene"] == scene]
        for (method, membrane), (name, colour, marker) in KINDS.items():
            of = [row for row in here if (row["method"], row["membrane"]) == (method, membrane)]
            axis.scatter(
                [1e3 * second for second in numbers(of, "seconds")],
                [error(row) for row in of],
                s=[12 + int(row["triangles"]) / 30 for row in of],
                c=colour,
                marker=marker,
                alpha=0.75,
                linewidths=0.5,
                edgecolors="white",
                label=name,
            )
        own = [row for row in here if row["method"] == "fast" and row["membrane"] == MEMBRANE]
        axis.plot(
            *zip(*front([(1e3 * float(row["seconds"]), error(row)) for row in own])),
            color=BLACK,
            lw=1,
            drawstyle="steps-post",
            label=f"{MEMBRANE}, best for its time",
            zorder=1,
        )
        if from_imaging:
            axis.plot([THESIS_MS] * 2, THESIS_MM, color=PURPLE, lw=3, label="thesis, from imaging")
        axis.set(title=scene, xscale="log", xlabel="time of a closure, ms")
        axis.xaxis.set_major_formatter(PLAIN)
    axes[0][0].set_ylabel(label)
    handles, names = axes[0][0].get_legend_handles_labels()
    for size in sorted({int(row["triangles"]) for row in rows}):
        handles.append(plt.scatter([], [], s=12 + size / 30, c=GREY))
        names.append(f"{size:,} triangles")
    legend_beside(axes[0][-1], handles, names)
    return figure


def draw_speed_accuracy(rows):
    figure = draw_against_time(
        rows,
        "Accuracy against time",
        "rms distance from the reference, mm",
        lambda row: float(row["rms_mm"]),
        from_imaging=True,
    )
    for axis in figure.axes:
        axis.set_ylim(bottom=0)
    return figure


def draw_leak_accuracy(rows):
    figure = draw_against_time(
        rows,
        "Error of the leak against time",
        "difference from the reference, mm²",
        lambda row: abs(float(row["leak_error_mm2"])),
    )
    for axis in figure.axes:
        axis.set_yscale("symlog", linthresh=0.1)
        axis.yaxis.set_major_formatter(PLAIN)
        axis.set_ylim(bottom=0)
    return figure


# Ablation: a bar is the median over the scenes, a whisker ends at the largest.

PANELS = (
    ("Leak", "|change|, mm²", BLUE, "log", (0.01, 300), lambda row: abs(float(row["leak_change_mm2"]))),
    ("Shape", "rms change, mm", GREEN, "linear", (0, 2.6), lambda row: float(row["rms_mm"])),
    ("Time", "time over the full model's", VERMILION, "log", (0.25, 40), lambda row: float(row["time_ratio"])),
)
SCALE_GROUP = "to compare"  # rows that the others are read against; the first is the floor


def short(value):
    return f"{value:.0f}" if value >= 10 else f"{value:.1f}" if value >= 1 else f"{value:.2f}"


def ablation_lines(rows):
    """(height, group or change, rows of the change or none), from the top."""
    lines, height = [], 0.0
    for group in each_once(row["group"] for row in rows):
        lines.append((height, group, None))
        height -= 1.0
        for change in each_once(row["change"] for row in rows if row["group"] == group):
            lines.append((height, change, [row for row in rows if (row["group"], row["change"]) == (group, change)]))
            height -= 1.0
        height -= 0.3
    return lines


def write_figures(axis, height, median, largest, **font):
    """Right of the panel."""
    for x, text, colour in ((1.13, median, BLACK), (1.30, largest, GREY)):
        axis.text(x, height, text, ha="right", va="center", color=colour, transform=axis.get_yaxis_transform(), **font)


def draw_panel(axis, lines, name, unit, colour, scale, limits, value):
    axis.set(title=name, xlabel=unit, xscale=scale, xlim=limits)
    if scale == "log":
        axis.xaxis.set_major_formatter(PLAIN)
    start = 1.0 if name == "Time" else limits[0]
    for height, _, rows in lines:
        if not rows:
            continue
        compared = [value(row) for row in rows if row["compared"] == "true" or name == "Time"]
        if not compared:
            continue
        median, largest = statistics.median(compared), max(compared)
        faint = 0.45 if rows[0]["group"] == SCALE_GROUP else 1.0
        axis.barh(height, max(median, limits[0]) - start, left=start, height=0.62, color=colour, alpha=faint)
        axis.plot([max(median, start), largest], [height] * 2, color=GREY, lw=1, marker="|", markevery=[1])
        write_figures(axis, height, short(median), short(largest))
    write_figures(axis, 1.0, "median", "largest", fontsize=8)
    floor = next((rows for _, _, rows in lines if rows and rows[0]["group"] == SCALE_GROUP), None)
    if name == "Time":
        axis.axvline(1.0, color=BLACK, lw=0.8)
    elif floor:
        axis.axvline(statistics.median(map(value, floor)), color=BLACK, lw=1, ls="--")
    axis.tick_params(axis="y", length=0)
    axis.grid(axis="y", visible=False)


def trouble(rows):
    failed = max(sum(row["crossing"] == "true" for row in rows), sum(row["status"] != "converged" for row in rows))
    retried = sum(int(row["attempts"]) > 1 for row in rows)
    return f"{failed} failed" if failed else f"{retried} retried" if retried else ""


def draw_ablation(rows):
    lines = ablation_lines(rows)
    figure, axes = figure_titled(
        "What each ingredient of a closure buys, and what it costs", 13, 0.27 * len(lines) + 1.8, ncols=3, sharey=True
    )
    for axis, panel in zip(axes, PANELS):
        draw_panel(axis, lines, *panel)
    axes[0].set_yticks([height for height, *_ in lines], [name for _, name, _ in lines])
    for label, (_, _, rows_of_change) in zip(axes[0].get_yticklabels(), lines):
        label.set(color=BLACK, fontweight="normal" if rows_of_change else "bold")
    axes[0].set_ylim(lines[-1][0] - 0.6, 1.5)
    figure.get_layout_engine().set(wspace=0.06, rect=(0, 0, 0.985, 1))
    for height, _, of in lines:
        axes[2].text(
            1.36,
            height,
            trouble(of) if of else "",
            va="center",
            color=GREY,
            fontsize=8,
            transform=axes[2].get_yaxis_transform(),
        )
    scenes = len(each_once(row["scene"] for row in rows))
    figure.supxlabel(
        f"Each row says what replaces the full model's ingredient. Bars: median over {scenes} scenes; "
        "ticks: largest. Beyond the dashed line is more\n"
        "than the same model differs when it is closed at half the speed. "
        "The contact thickness also counts in the leak.",
        x=0.01,
        ha="left",
        fontsize=9,
        color=GREY,
    )
    return figure


# Stability: a cell is a colour and a letter.

OUTCOMES = {
    "settles": ("S", GREEN, "white", "settles"),
    "other_equilibrium": ("O", SKY, "black", "settles elsewhere"),
    "crosses": ("X", VERMILION, "white", "settles, leaflets cross"),
    "stalls": ("N", YELLOW, "black", "does not settle"),
    "blows_up": ("B", BLACK, "white", "blows up"),
}
AXES = {
    "step": "step, factor",
    "contact-stiffness": "contact stiffness, factor",
    "chordae-modulus": "chordae modulus, factor",
    "pressure": "pressure, kPa",
    "slivers": "slivers, edge ratio",
    "resolution": "resolution, triangles",
    "dilation": "AP dilation, %",
    "tips": "tips displaced, mm",
}
SCENES = {"commissures": "human-normal, annulus 30 % narrower: surplus tissue at the commissures"}


def draw_map(axis, cells, methods):
    levels = each_once(cell["level"] for cell in cells)
    for cell in cells:
        x, y = levels.index(cell["level"]), methods.index(cell["method"])
        letter, colour, ink, _ = OUTCOMES[cell["outcome"]]
        axis.add_patch(Rectangle((x + 0.04, y + 0.05), 0.92, 0.9, facecolor=colour, clip_on=False))
        text = letter + (cell["attempts"] if int(cell["attempts"]) > 1 else "")
        axis.text(x + 0.5, y + 0.53, text, color=ink, ha="center", va="center", fontsize=8, fontweight="bold")
        if cell["nominal"] == "true":
            axis.add_patch(
                Rectangle((x, 0), 1, len(methods), fill=False, edgecolor=BLACK, lw=1.8, clip_on=False, zorder=3)
            )
    axis.set(xlim=(0, 7), ylim=(len(methods), 0))
    axis.set_title(AXES[cells[0]["axis"]], loc="left", fontweight="normal", fontsize=9.5)
    axis.set_xticks([i + 0.5 for i in range(len(levels))], levels, fontsize=8)
    axis.set_yticks([i + 0.5 for i in range(len(methods))], methods, color=BLACK)
    axis.tick_params(length=0)
    axis.grid(False)
    axis.spines[:].set_visible(False)


def draw_stability(rows):
    methods, scenes = each_once(row["method"] for row in rows), each_once(row["scene"] for row in rows)
    axes = each_once(row["axis"] for row in rows)
    across = min(4, len(axes))
    down = -(-len(axes) // across)
    heights = [0.6] + [0.35 + 2.1 * down] * len(scenes)
    figure = plt.figure(figsize=(1.0 + 2.75 * across, 0.4 + sum(heights)), layout="constrained")
    title(figure, "Where each method closes a valve, and where it fails")
    figure.get_layout_engine().set(w_pad=0.08)
    legend, *parts = figure.subfigures(1 + len(scenes), 1, height_ratios=heights)
    for part, scene in zip(parts, scenes):
        title(part, SCENES.get(scene, scene), size=11)
        panels = part.subplots(down, across, sharey=True, squeeze=False).flat
        for panel, name in zip(panels, axes):
            draw_map(panel, [row for row in rows if (row["scene"], row["axis"]) == (scene, name)], methods)
        for panel in panels:
            panel.set_visible(False)
    handles = [
        Patch(facecolor=colour, label=f"{letter}  {meaning}") for letter, colour, _, meaning in OUTCOMES.values()
    ]
    handles.append(Patch(facecolor="white", edgecolor=BLACK, lw=1.8, label="nominal"))
    legend.legend(
        handles=handles,
        loc="upper left",
        ncols=len(handles),
        fontsize=9,
        columnspacing=1.2,
        title="All are at rest at residual 0.01. A number beside the letter: attempts of coapt's ladder.",
        title_fontsize=9,
        alignment="left",
    )
    return figure


# The search against its rivals.


def draw_ecdf(rows):
    figure, axis = figure_titled("Targets reached, from 5 mm² above the optimum to none", 8, 4.6)
    axis.set_prop_cycle(color=[BLACK, GREY, BLUE, ORANGE, GREEN, PURPLE, VERMILION, SKY])
    for method in each_once(row["method"] for row in rows):
        of = [row for row in rows if row["method"] == method]
        axis.step(
            numbers(of, "closures"),
            [100 * share for share in numbers(of, "share")],
            where="post",
            label=method,
            lw=2.4 if method == "coapt" else 1.3,
            ls="--" if method == "random" else "-",
        )
    axis.set(xscale="log", ylim=(0, 101), xlabel="closures", ylabel="targets reached, % (all lattices and seeds)")
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    legend_beside(axis)
    return figure


def draw_hostile_memory(rows):
    figure, axis = figure_titled("Memory of the service under hostile requests", 8, 3)
    axis.plot(numbers(rows, "seconds"), numbers(rows, "resident_mib"), color=BLUE, linewidth=1)
    axis.set(xlabel="seconds", ylabel="resident memory, MiB")
    axis.set_xlim(left=0)
    axis.set_ylim(bottom=0)
    return figure


CHARTS = {
    "ablation": {"ablation": draw_ablation},
    "speed-accuracy": {"speed-accuracy": draw_speed_accuracy, "speed-accuracy-leak": draw_leak_accuracy},
    "stability": {"stability": draw_stability},
    "mesh": {"mesh": mesh.draw_errors},
    "growth": {"growth": growth.draw_growth},
    "uniqueness": {"uniqueness": uniqueness.draw_uniqueness},
    "indications": {"indications": indications.draw_indications},
    "verdicts": {"verdicts": verdicts.draw_verdicts},
    "twins": {"twins": twins.draw_twins},
    "ruptures": {"ruptures": twins.draw_ruptures},
    "front-rise": {"front-rise": front_rise.draw_front_rise},
    "ecdf": {"ecdf": draw_ecdf},
    "hostile-memory": {"hostile-memory": draw_hostile_memory},
    "attacks": {"attacks": attacks.draw_attacks},
}


def write_png(figure, path):
    """Of 64 colours, which look like all and take a third of the bytes. The same table gives the same file."""
    drawn = io.BytesIO()
    figure.savefig(drawn)
    image = Image.open(drawn).convert("RGB").quantize(64, dither=Image.Dither.NONE)
    image.save(path, format="png", optimize=True)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="+", type=pathlib.Path, metavar="CSV")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="directory for the charts (default: the table's)")
    options = parser.parse_args(arguments)
    for table in options.tables:
        if table.stem not in CHARTS:
            parser.error(f"{table}: must be named {', '.join(f'{name}.csv' for name in CHARTS)}")
    for table in options.tables:
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
        for name, draw in CHARTS[table.stem].items():
            figure = draw(rows)
            write_png(figure, (options.output or table.parent) / f"{name}.png")
            plt.close(figure)


if __name__ == "__main__":
    main()
