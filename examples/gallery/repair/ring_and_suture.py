"""Maps the leak over ring size and suture length: the two can stand in for each other."""

import numpy
from matplotlib import pyplot

import coapt
from coapt import PapillaryApproximation, Plan, Ring

SIZES, LENGTHS = (30, 32, 34, 36, 38, 40), (20, 22, 24, 26, 28, 30)
valve = coapt.preset("human-functional-mr")
plans = [
    Plan(Ring("generic-classic", size), PapillaryApproximation("posteromedial", length))
    for size in SIZES
    for length in LENGTHS
]
items = coapt.close_many(valve, plans)
leaks = numpy.reshape([item.closure.measure.leak_mm2 if item.trusted else numpy.nan for item in items], (6, 6))
figure, ax = pyplot.subplots(figsize=(6, 4.4))
cells = ax.pcolormesh(LENGTHS, SIZES, leaks, shading="nearest", cmap="viridis_r", vmin=0)
for (i, j), leak in numpy.ndenumerate(leaks):
    ax.text(LENGTHS[j], SIZES[i], f"{leak:.0f}", ha="center", va="center", color="white" if leak > 12 else "black")
ax.set(xlabel="suture of the posteromedial muscle, mm", ylabel="ring, mm")
figure.colorbar(cells, label="leak, mm²")
figure.savefig("ring_and_suture.png")
