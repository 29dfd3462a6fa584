"""Compares what a valve does with what was measured in hearts: a point within the bar lies within the measured range."""

from matplotlib import pyplot

import coapt

rows = [row for row in coapt.preset("human-normal").physiology()["rows"] if row["low"] is not None and row["value"]]
figure, ax = pyplot.subplots(figsize=(8, 5.6))
for place, row in enumerate(rows):
    low, high = row["low"], row["high"] or max(2 * row["low"], row["value"])
    width = high - low or 1.0
    colour = {"met": "#009e73"}.get(row["verdict"], "#d55e00")
    ax.plot([0, 1], [place, place], color="#ccd4dc", linewidth=7, solid_capstyle="butt")
    ax.plot((row["value"] - low) / width, place, "o", color=colour)
ax.set_yticks(range(len(rows)), [f"{row['what']}, {row['unit']}" for row in rows], fontsize=8)
ax.set_xticks([0, 1], ["lowest", "highest"])
ax.set(xlim=(-0.6, 1.6), xlabel="measured in healthy hearts")
ax.invert_yaxis()
print(*(f"{row['what']}: {row['value']:.3g} {row['unit']} ({row['source']})" for row in rows), sep="\n")
figure.savefig("beside_hearts.png")
