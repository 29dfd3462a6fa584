"""Draws the height of coaptation from commissure to commissure, in a healthy valve and in a leaking one."""

from matplotlib import pyplot

import coapt
from coapt import plots

figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8), sharey=True)
for name, ax in zip(("human-normal", "human-functional-mr"), axes):
    closure = coapt.preset(name).close()
    plots.coaptation(closure, ax=ax)
    ax.set_title(f"{name}: {closure.measure.coaptation_height_mean_mm:.1f} mm in the mean")
figure.savefig("coaptation.png")
