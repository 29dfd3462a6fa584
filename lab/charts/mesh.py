"""Error of leaks and shapes against the number of triangles: mesh.csv."""

import statistics

from style import BLUE, PLAIN, each_once, figure_titled, numbers

LEAKS_MM2 = 10  # scenes above it have a relative error


def quantile(values, share):
    return (
        statistics.quantiles(values, n=100, method="inclusive")[round(100 * share) - 1]
        if len(values) > 1
        else values[0]
    )


def difference(row):
    return float(row["leak_mm2"]) - float(row["reference_leak_mm2"])


def relative(rows):
    """Per cent, of the scenes that leak on the finest mesh."""
    return [
        100 * difference(row) / float(row["reference_leak_mm2"])
        for row in rows
        if float(row["reference_leak_mm2"]) > LEAKS_MM2
    ]


def draw_median_and_most(axis, triangles, parts):
    """The values of each number of triangles."""
    axis.plot(triangles, [statistics.median(part) for part in parts], "o-", color=BLUE, label="median")
    axis.plot(triangles, [quantile(part, 0.9) for part in parts], "o:", color=BLUE, label="90 % are below")


def draw_errors(rows):
    rows = [row for row in rows if row["trusted"] == "true"]
    triangles = sorted(each_once(int(row["triangles"]) for row in rows))
    at = {n: [row for row in rows if int(row["triangles"]) == n] for n in triangles}
    finest = int(rows[0]["reference_triangles"])
    figure, (large, every, shape) = figure_titled(
        f"The same scenes on growing meshes, against {finest:,} triangles", 11, 3.6, ncols=3
    )
    draw_median_and_most(large, triangles, [[abs(error) for error in relative(at[n])] or [0] for n in triangles])
    large.set(ylabel=f"error of leaks above {LEAKS_MM2} mm², %")
    draw_median_and_most(every, triangles, [[abs(difference(row)) for row in at[n]] for n in triangles])
    every.set(ylabel="error of all leaks, mm²")
    draw_median_and_most(shape, triangles, [numbers(at[n], "rms_mm") for n in triangles])
    shape.set(ylabel="distance of the leaflets, rms mm")
    for axis in (large, every, shape):
        axis.set(xscale="log", xlabel="triangles")
        axis.set_xticks(triangles, labels=[f"{n:,}" for n in triangles])
        axis.minorticks_off()
        axis.set_ylim(bottom=0)
        axis.yaxis.set_major_formatter(PLAIN)
        axis.legend()
    return figure
