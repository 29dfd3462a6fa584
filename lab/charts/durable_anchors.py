"""How long repairs by either anchor last while the disease goes on: durable-anchors.csv."""

from style import BLUE, GREY, VERMILION, figure_titled

DISPLACED = (("AL", "anterolateral displaced"), ("PM", "posteromedial displaced"), ("both", "both displaced"))
LIMITS = (("5", BLUE, "tied until 5 mm²"), ("1", VERMILION, "tied until 1 mm²"))
FURTHEST_MM = 12.0
MARKS = (("0", "o", "sutures alone"), ("1", "^", "with a ring"))


def pairs_of(rows):
    """Of the anatomies that both anchors repair: saddle peak's, trigone's."""
    lasts = {(row["anchor"], row["anatomy"]): float(row["durability_mm"]) for row in rows}
    both = [anatomy for anchor, anatomy in lasts if anchor == "trigone" and ("saddle peak", anatomy) in lasts]
    return [lasts["saddle peak", anatomy] for anatomy in both], [lasts["trigone", anatomy] for anatomy in both]


def draw_durable_anchors(rows):
    figure, axes = figure_titled("Disease that a repair outlasts, mm of the posteromedial tip", 10.5, 3.9, ncols=3)
    repaired = [row for row in rows if row["repaired"] == "1"]
    for axis, (displaced, title) in zip(axes, DISPLACED):
        axis.plot([0, FURTHEST_MM], [0, FURTHEST_MM], color=GREY, lw=0.8)
        for limit, colour, label in LIMITS:
            for ring, marker, words in MARKS:
                pairs = pairs_of(
                    [r for r in repaired if (r["displaced"], r["limit_mm2"], r["ring"]) == (displaced, limit, ring)]
                )
                axis.scatter(*pairs, s=14, color=colour, marker=marker, alpha=0.6, lw=0, label=f"{words}, {label}")
        axis.set(title=title, xlabel="saddle peak, mm", ylabel="trigone, mm", aspect="equal")
        axis.set(xlim=(0, FURTHEST_MM + 0.3), ylim=(0, FURTHEST_MM + 0.3))
    axes[0].legend(fontsize=8)
    return figure
