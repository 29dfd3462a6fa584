"""Fits of valves whose answers are known: twins.csv, ruptures.csv."""

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


def draw_ruptures(rows):
    figure, axis = figure_titled("Probability of a twin's own lesion", 7, 3.2)
    own = [row for row in rows if row["hypothesis"] == row["lesion"]]
    for intact, colour, label in ((True, BLUE, "intact"), (False, VERMILION, "ruptured")):
        here = [row for row in own if (row["lesion"] == "intact") == intact]
        axis.plot(
            [int(row["twin"]) for row in here],
            [float(row["probability"]) for row in here],
            "o",
            color=colour,
            label=label,
        )
    axis.axhline(0.5, color=GREY, lw=0.8)
    axis.set_xlabel("twin (even: looked at; odd: held out)")
    axis.set_ylabel("probability")
    axis.set_ylim(-0.03, 1.03)
    legend_beside(axis, *axis.get_legend_handles_labels())
    return figure
