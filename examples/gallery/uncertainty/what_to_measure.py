"""Asks which measurement of a valve would say most about its leak."""

from matplotlib import pyplot

import coapt

told = coapt.engine().information("human-functional-mr", draws=64)
rows = [row for row in told["rows"] if row["remaining_mm2"] is not None][::-1]
figure, ax = pyplot.subplots(figsize=(8, 3.2))
ax.barh([row["measurement"] for row in rows], [row["remaining_mm2"] for row in rows])
ax.axvline(told["leak"]["sd_mm2"], color="grey", linestyle="--")
ax.set_title(f"{told['leak']['sd_mm2']:.0f} mm² (dashed) if nothing is measured", loc="left")
ax.set_xlabel("standard deviation of the leak that remains, mm²")
figure.savefig("what_to_measure.png")
