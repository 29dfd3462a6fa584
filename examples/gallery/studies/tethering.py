"""Moves the posteromedial papillary muscle away, along each axis, and shows what a leak depends on."""

import numpy
from matplotlib import pyplot

import coapt

valve = coapt.preset("human-normal")
tip = valve.papillary_mm["posteromedial"]
ways = {"outwards": (1, 0, 0), "posterior": (0, -1, 0), "apical": (0, 0, -1), "all three": (1, -1, -1)}
steps = numpy.arange(0, 11, 2)
figure, ax = pyplot.subplots()
for name, way in ways.items():
    moved = [tip + step * numpy.array(way) / numpy.linalg.norm(way) for step in steps]
    valves = [valve.replace(papillary_mm={"posteromedial": place}) for place in moved]
    ax.plot(steps, [one.close().measure.leak_mm2 for one in valves], "o-", label=name)
ax.set(xlabel="displacement, mm", ylabel="leak, mm²", ylim=(0, None))
ax.legend()
figure.savefig("tethering.png")
