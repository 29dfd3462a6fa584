"""Shortens a papillary suture to the trigone and to the saddle peak, behind a ring that does not suffice alone."""

from matplotlib import pyplot

import coapt
from coapt import PapillaryApproximation, Plan, Ring

RING, LENGTHS = Ring("generic-classic", 36), range(20, 37, 2)
valve = coapt.preset("human-functional-mr")
figure, ax = pyplot.subplots()
for anchor in ("ipsilateral_trigone", "saddle_peak"):
    leaks = []
    for length in LENGTHS:
        try:
            closure = valve.close(Plan(RING, PapillaryApproximation("posteromedial", length, anchor)))
            leaks.append(closure.measure.leak_mm2 if closure.trusted else float("nan"))
        except coapt.InvalidRequest:  # the suture would be longer than the way
            leaks.append(float("nan"))
    ax.plot(LENGTHS, leaks, "o-", label=anchor.replace("_", " "))
ax.axhline(valve.close(Plan(RING)).measure.leak_mm2, color="grey", linestyle="--", label="ring alone")
ax.set(xlabel="suture, mm", ylabel="leak, mm²", ylim=(0, None))
ax.legend()
figure.savefig("suture_length.png")
