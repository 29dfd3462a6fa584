"""Opens a valve in diastole with rings of five sizes: the smaller the ring, the less it leaks and the more it obstructs."""

from matplotlib import pyplot

import coapt
from coapt import Plan, Ring

SIZES = (26, 28, 30, 32, 36)
valve = coapt.preset("human-functional-mr")
plans = [Plan(Ring("generic-classic", size)) for size in SIZES]
gradients = [valve.open(plan).gradient_mmhg for plan in plans]
leaks = [valve.close(plan).measure.leak_mm2 for plan in plans]
figure, ax = pyplot.subplots()
ax.plot(SIZES, leaks, "o-")
ax.set(xlabel="ring, mm", ylim=(0, None))
ax.set_ylabel("leak, mm²", color="C0")
other = ax.twinx()
other.plot(SIZES, gradients, "s--", color="C1")
other.set_ylabel("mean gradient at rest, mmHg", color="C1")
other.set_ylim(0, None)
figure.savefig("ring_and_gradient.png")
