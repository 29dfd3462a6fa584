"""What the parts of a closure cost on growing meshes: growth.csv."""

import math

from style import BLACK, BLUE, GREEN, ORANGE, PLAIN, PURPLE, VERMILION, each_once, figure_titled, legend_beside

COLOURS = {
    "step": VERMILION,
    "step without contact": ORANGE,
    "list of pairs": BLUE,
    "look for crossings": GREEN,
    "set-up": PURPLE,
}
LINES = {"0": "-", "100": "-", "250": "--"}  # steps before


def exponent(triangles, times):
    """Slope of the line of least squares through the logarithms."""
    x, y = [math.log(n) for n in triangles], [math.log(t) for t in times]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def draw_growth(rows):
    figure, axis = figure_titled("Time of the parts of a closure on growing meshes", 8.5, 4.2)
    for part, steps in each_once((row["part"], row["steps_before"]) for row in rows):
        own = [row for row in rows if (row["part"], row["steps_before"]) == (part, steps)]
        triangles = [int(row["triangles"]) for row in own]
        times = [float(row["microseconds"]) for row in own]
        where = f", after {steps} steps" if steps != "0" else ""
        label = f"{part}{where}: N^{exponent(triangles, times):.2f}"
        axis.plot(triangles, times, "o", ls=LINES.get(steps, ":"), color=COLOURS.get(part, BLACK), label=label)
    ticks = sorted(each_once(int(row["triangles"]) for row in rows))
    axis.set(xscale="log", yscale="log", xlabel="triangles N", ylabel="microseconds")
    axis.set_xticks(ticks, labels=[f"{n:,}" for n in ticks])
    axis.minorticks_off()
    axis.yaxis.set_major_formatter(PLAIN)
    legend_beside(axis)
    return figure
