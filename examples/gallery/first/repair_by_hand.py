"""Repairs a valve with a ring and a papillary suture, and draws the atrial view before and after."""

from matplotlib import pyplot

import coapt
from coapt import PapillaryApproximation, Plan, Ring, plots

valve = coapt.preset("human-functional-mr")
plan = Plan(Ring("generic-classic", size_mm=32), PapillaryApproximation("posteromedial", suture_length_mm=24))
figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.4), sharex=True, sharey=True)
for title, repair, ax in (("before", None, axes[0]), ("after", plan, axes[1])):
    closure = valve.close(repair)
    measure = closure.measure
    plots.atrial_view(closure, ax=ax)
    ax.set_title(f"{title}: {measure.leak_mm2:.1f} mm²")
    print(f"{title}: leak {measure.leak_mm2:.1f} mm², coaptation {measure.coaptation_height_mean_mm:.1f} mm")
figure.savefig("repair_by_hand.png")
