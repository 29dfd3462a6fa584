"""Treats a flail P2 with two neochordae of different lengths: too short tethers it, too long leaves it flail."""

from matplotlib import pyplot

import coapt
from coapt import LeafletPoint, Neochorda, Plan, Ring

LENGTHS = range(13, 38, 3)
valve, ring = coapt.preset("human-p2-prolapse"), Ring("generic-classic", 32)
ends = (("AL1", LeafletPoint("posterior", 0.46)), ("PM1", LeafletPoint("posterior", 0.54)))
plans = [Plan(ring, *(Neochorda(head, point, length) for head, point in ends)) for length in LENGTHS]
measures = [item.closure.measure for item in coapt.close_many(valve, plans)]
figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8))
axes[0].plot(LENGTHS, [one.leak_mm2 for one in measures], "o-")
axes[0].axhline(valve.close(Plan(ring)).measure.leak_mm2, color="grey", linestyle="--")
axes[0].set(ylabel="leak, mm² (dashed: ring alone)", ylim=(0, None))
axes[1].plot(LENGTHS, [one.tension_max_n for one in measures], "o-", color="C1")
axes[1].set(ylabel="highest chordal tension, N", ylim=(0, None))
figure.supxlabel("length of the neochordae, mm")
figure.savefig("neochordae.png")
