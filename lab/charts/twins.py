"""Fits of valves whose answers are known: twins.csv."""

from style import BLUE, GREY, VERMILION, figure_titled, legend_beside

PANELS = (
    ("slack_", "length of chordae, factor"),
    ("tip_", "papillary tips, mm"),
    ("hidden_", "hidden height, mm"),
    ("leak", "leak, mm²"),
)
NINETY = 1.6449  # standard deviations to either side that hold 90 %


def draw_twins(rows):
    figure, axes = figure_titled("Fitted against true values, with intervals of 90 %", 13, 3.9, ncols=len(PANELS))
    for axis, (beginning, label) in zip(axes, PANELS):
        of = [row for row in rows if row["quantity"].startswith(beginning)]
        for identifiable, colour, name in (("", BLUE, None), ("true", BLUE, "identified"), ("false", VERMILION, "not")):
            here = [row for row in of if row["identifiable"] == identifiable]
            if not here:
                continue
            axis.errorbar(
                [float(row["truth"]) for row in here],
                [float(row["value"]) for row in here],
                yerr=[NINETY * float(row["sd"]) for row in here],
                fmt="o",
                ms=2.5,
                lw=0.5,
                alpha=0.6,
                color=colour,
                label=name,
            )
        truths = [float(row["truth"]) for row in of]
        ends = [min(truths), max(truths)]
        axis.plot(ends, ends, color=GREY, lw=0.8, zorder=3)
        within = sum(abs(float(row["value"]) - float(row["truth"])) <= NINETY * float(row["sd"]) for row in of)
        axis.set_title(f"{label}:\n{within} of {len(of)} intervals hold", loc="left", fontsize=9.5)
        axis.set_xlabel("true")
    axes[0].set_ylabel("fitted")
    legend_beside(axes[-1], *axes[0].get_legend_handles_labels())
    return figure
