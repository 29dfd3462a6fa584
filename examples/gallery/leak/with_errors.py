"""Closes all presets and draws each leak with its numerical error: what the mesh and the stopping rule leave open."""

from matplotlib import pyplot

import coapt

items = coapt.close_many(coapt.engine().presets())
names = [item.valve for item in items]
leaks = [item.closure.measure.leak for item in items]
figure, ax = pyplot.subplots()
ax.errorbar([one.area_mm2 for one in leaks], names, xerr=[one.error_mm2 for one in leaks], fmt="o", capsize=3)
ax.axvline(5.0, color="grey", linestyle="--", linewidth=0.8)
ax.annotate("mild below 5 mm²", (6, -0.4), color="grey", fontsize=9)
ax.invert_yaxis()
ax.set_xlabel("leak, mm²")
figure.savefig("with_errors.png")
