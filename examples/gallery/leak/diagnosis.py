"""Asks why valves leak, segment by segment, and draws the findings as a table of colours."""

from matplotlib import pyplot

import coapt

COLOURS = {
    "normal": "#e8edf2",
    "tethered": "#56b4e9",
    "prolapse": "#e69f00",
    "flail": "#d55e00",
    "billowing": "#f0e442",
}
NAMES = ("human-normal", "human-functional-mr", "secondary-mr", "human-p2-prolapse", "barlow", "fibroelastic-flail")
figure, ax = pyplot.subplots(figsize=(8, 3.6))
for row, name in enumerate(NAMES):
    found = coapt.preset(name).diagnose()
    for column, segment in enumerate(found["segments"]):
        ax.barh(row, 0.96, left=column, color=COLOURS.get(segment["finding"], "white"))
        ax.text(column + 0.48, row, segment["finding"], ha="center", va="center", fontsize=9)
    print(f"{name}: {found['sentence']}")
    ax.text(len(found["segments"]) + 0.1, row, found["type"] or "", va="center")
ax.set_xticks([0.48 + i for i in range(len(found["segments"]))], [one["name"] for one in found["segments"]])
ax.set_yticks(range(len(NAMES)), NAMES)
ax.invert_yaxis()
ax.spines[:].set_visible(False)
figure.savefig("diagnosis.png")
