"""Error of areas and shapes against the number of triangles: mesh.csv."""

import statistics

from style import BLUE, ORANGE, PLAIN, VERMILION, each_once, figure_titled, numbers

LEAKS_MM2 = 10  # scenes above it have a relative error


def quantile(values, share):
    return (
        statistics.quantiles(values, n=100, method="inclusive")[round(100 * share) - 1]
        if len(values) > 1
        else values[0]
    )


def difference(row, area):
    return float(row[f"{area}_mm2"]) - float(row[f"reference_{area}_mm2"])


def relative(rows, area):
    """Per cent, of the scenes that leak on the finest mesh."""
    return [
        100 * difference(row, area) / float(row[f"reference_{area}_mm2"])
        for row in rows
        if float(row[f"reference_{area}_mm2"]) > LEAKS_MM2
    ]


def draw_errors(rows):
    rows = [row for row in rows if row["trusted"] == "true"]
    triangles = sorted(each_once(int(row["triangles"]) for row in rows))
    at = {n: [row for row in rows if int(row["triangles"]) == n] for n in triangles}
    finest = int(rows[0]["reference_triangles"])
    figure, (areas, small, shape) = figure_titled(
        f"The same scenes on growing meshes, against {finest:,} triangles", 11, 3.6, ncols=3
    )
    for area, colour in (("orifice", BLUE), ("gap", ORANGE), ("leak", VERMILION)):
        parts = [[abs(error) for error in relative(at[n], area)] or [0] for n in triangles]
        areas.plot(triangles, [statistics.median(part) for part in parts], "o-", color=colour, label=area)
        areas.plot(triangles, [quantile(part, 0.9) for part in parts], "o:", color=colour)
        all_of = [[abs(difference(row, area)) for row in at[n]] for n in triangles]
        small.plot(triangles, [statistics.median(part) for part in all_of], "o-", color=colour, label=area)
        small.plot(triangles, [quantile(part, 0.9) for part in all_of], "o:", color=colour)
    areas.set(ylabel=f"error of areas above {LEAKS_MM2} mm², %")
    small.set(ylabel="error of all areas, mm²")
    rms = [numbers(at[n], "rms_mm") for n in triangles]
    shape.plot(triangles, [statistics.median(part) for part in rms], "o-", color=BLUE, label="median")
    shape.plot(triangles, [quantile(part, 0.9) for part in rms], "o:", color=BLUE, label="90 % are below")
    shape.set(ylabel="distance of the leaflets, rms mm")
    for axis in (areas, small, shape):
        axis.set(xscale="log", xlabel="triangles")
        axis.set_xticks(triangles, labels=[f"{n:,}" for n in triangles])
        axis.minorticks_off()
        axis.set_ylim(bottom=0)
        axis.yaxis.set_major_formatter(PLAIN)
        axis.legend()
    return figure
