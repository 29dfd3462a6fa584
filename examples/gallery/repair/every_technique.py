"""Closes valves with each of the example plans, one of every technique, and draws what is left of the leak."""

import re

from matplotlib import pyplot

import coapt

table = open("examples/plans/README.md").read()
rows = re.findall(r"^\| \[(.*?)\.json\].*`(.*?)` \|$", table, re.MULTILINE)
figure, ax = pyplot.subplots()
for place, (plan, name) in enumerate(rows):
    valve = coapt.preset(name)
    before, after = (valve.close(one).measure.leak_mm2 for one in (None, f"examples/plans/{plan}.json"))
    ax.plot([before, after], [place, place], color="#ccd4dc", linewidth=3, zorder=1)
    ax.plot(before, place, "o", color="C1", label="before" if place == 0 else None)
    ax.plot(after, place, "o", color="C2", label="after" if place == 0 else None)
ax.set_yticks(range(len(rows)), [f"{plan} ({name})" for plan, name in rows], fontsize=8)
ax.invert_yaxis()
ax.set_xlabel("leak, mm²")
ax.legend()
figure.savefig("every_technique.png")
