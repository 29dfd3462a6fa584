"""Shows how the leak changes with the pressure across the closed valve, for three kinds of valve."""

from matplotlib import pyplot

import coapt

PRESSURES = range(60, 201, 20)
figure, ax = pyplot.subplots()
for name in ("human-normal", "human-functional-mr", "human-p2-prolapse"):
    valve = coapt.preset(name)
    leaks = [valve.close(pressure_mmhg=pressure).measure.leak_mm2 for pressure in PRESSURES]
    ax.plot(PRESSURES, leaks, "o-", label=name)
ax.set(xlabel="pressure, mmHg", ylabel="leak, mm²", ylim=(0, None))
ax.legend()
figure.savefig("pressure.png")
