"""Leak of plans on drawn chordae against that on the anatomy's own: chordae.csv."""

import statistics

from style import BLUE, GREY, ORANGE, PLAIN, figure_titled

KNOWN = (("tips seen", BLUE), ("nothing seen", ORANGE))
SHOWN_MM2 = 0.1  # smaller leaks lie on the border: both scales are logarithmic


def draw_chordae(rows):
    figure, axes = figure_titled("Leak of plans, chordae drawn against own", 9.5, 4.6, ncols=2)
    own = {(row["anatomy"], row["plan"]): row["leak_mm2"] for row in rows if row["known"] == "own"}
    for axis, (known, colour) in zip(axes, KNOWN):
        leaks = {}
        for row in rows:
            if row["known"] == known and row["leak_mm2"] and own[row["anatomy"], row["plan"]]:
                leaks.setdefault((row["anatomy"], row["plan"]), []).append(max(SHOWN_MM2, float(row["leak_mm2"])))
        for bare, marker, name in ((True, "s", "no repair"), (False, "o", "plans")):
            here = [key for key in leaks if (key[1] == "0") == bare]
            true = [max(SHOWN_MM2, float(own[key])) for key in here]
            middle = [statistics.median(leaks[key]) for key in here]
            low = [m - min(leaks[key]) for m, key in zip(middle, here)]
            high = [max(leaks[key]) - m for m, key in zip(middle, here)]
            axis.errorbar(
                true, middle, (low, high), fmt=marker, ms=5 if bare else 3, lw=0.4, alpha=0.6, color=colour, label=name
            )
        most = max(max(of) for of in leaks.values())
        axis.plot([SHOWN_MM2, most], [SHOWN_MM2, most], color=GREY, lw=0.8)
        axis.set(xscale="log", yscale="log", title=known, xlabel="own chordae, mm²")
        axis.xaxis.set_major_formatter(PLAIN)
        axis.yaxis.set_major_formatter(PLAIN)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("median and range over the draws, mm²")
    return figure
