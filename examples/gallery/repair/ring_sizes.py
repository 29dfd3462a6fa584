"""Closes a valve with rings of three shapes in all sizes."""

from matplotlib import pyplot

import coapt
from coapt import Plan, Ring

SIZES = range(26, 41, 2)
valve = coapt.preset("human-functional-mr")
figure, ax = pyplot.subplots()
for shape in ("generic-classic", "generic-geoform-like", "generic-etlogix-like"):
    items = coapt.close_many(valve, [Plan(Ring(shape, size)) for size in SIZES])
    ax.plot(SIZES, [item.closure.measure.leak_mm2 for item in items], "o-", label=shape)
ax.axhline(valve.close().measure.leak_mm2, color="grey", linestyle="--", label="no ring")
ax.set(xlabel="ring, mm", ylabel="leak, mm²", ylim=(0, None))
ax.legend()
figure.savefig("ring_sizes.png")
