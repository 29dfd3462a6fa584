"""Coaptation area index and leak of valves with Barlow's disease, annulus made smaller or larger: barlow.csv."""

from style import BLUE, GREY, ORANGE, VERMILION, each_once, figure_titled

LAWS = (("myxomatous", VERMILION), ("healthy", BLUE))
INDEX_PERCENT = 20.0  # Aguilera 2023, and the reductions there: of the models, in surgery
MODELLED, DONE = (31.0, 6.0), (58.0, 7.0)


def draw_barlow(rows):
    figure, axes = figure_titled("Barlow's disease: the annulus made smaller", 9.5, 4.2, ncols=2)
    for law, colour in LAWS:
        here = [row for row in rows if row["tissue"] == law and row["trusted"] == "1"]
        for valve in each_once(row["valve"] for row in here):
            series = [row for row in here if row["valve"] == valve]
            reduction = [100.0 * float(row["reduction"]) for row in series]
            style = {"color": colour, "lw": 0.8, "alpha": 0.5, "label": law if valve == "0" else None}
            axes[0].plot(reduction, [100.0 * float(row["coaptation_area_index"]) for row in series], **style)
            axes[1].plot(reduction, [float(row["leak_mm2"]) for row in series], **style)
    axes[0].axhline(INDEX_PERCENT, color=GREY, lw=0.8)
    for (mean, sd), words in ((MODELLED, "models"), (DONE, "surgery")):
        axes[0].axvspan(mean - sd, mean + sd, color=ORANGE, alpha=0.2, lw=0)
        axes[0].text(mean, axes[0].get_ylim()[1], words, ha="center", va="top", fontsize=8)
    axes[0].set(ylabel="coaptation area index, %")
    axes[1].set(ylabel="leak, mm²")
    for axis in axes:
        axis.set(xlabel="annular area less, %")
    axes[1].legend(fontsize=8, title="law of the tissue")
    return figure
