"""How much of what plans trade the search and its rivals have found."""

from matplotlib.ticker import FuncFormatter
from style import BLACK, BLUE, GREY, ORANGE, each_once, figure_titled, legend_beside, numbers

PANELS = {"0": "valves that settings were chosen on", "1": "valves held out"}
COLOURS = {"coapt": BLACK, "random": GREY, "pagmo_nsga2": BLUE, "pagmo_moead": ORANGE}


def draw_front_rise(rows):
    words = "Volume that the plans found dominate: leak, opening and durability"
    figure, axes = figure_titled(words, 10, 4, ncols=2, sharey=True)
    for axis, (held_out, words) in zip(axes, PANELS.items(), strict=True):
        for method in each_once(row["method"] for row in rows):
            of = [row for row in rows if row["method"] == method and row["held_out"] == held_out]
            shares = [100 * share for share in numbers(of, "share")]
            width = 2.4 if method == "coapt" else 1.3
            axis.step(numbers(of, "closures"), shares, where="post", label=method, color=COLOURS[method], lw=width)
        axis.axhline(99, color=GREY, lw=0.8, ls=":")
        axis.set(xscale="log", ylim=(0, 101), xlabel="closures (an opening counts as five)", title=words)
        axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    axes[0].set_ylabel("of the whole volume, % (mean of runs)")
    legend_beside(axes[1])
    return figure
