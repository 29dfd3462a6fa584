"""Closes the presets of eight human valves and draws them side by side, each with its leak."""

from matplotlib import pyplot

import coapt
from coapt import plots

NAMES = "human-normal human-functional-mr secondary-mr human-p2-prolapse barlow fibroelastic-flail marfan hypertrophic"
figure, axes = pyplot.subplots(2, 4, figsize=(10, 5.2))
for name, ax in zip(NAMES.split(), axes.flat):
    closure = coapt.preset(name).close()
    plots.atrial_view(closure, ax=ax)
    ax.collections[0].colorbar.remove()
    ax.set_title(f"{name}\n{closure.measure.leak_mm2:.0f} mm²", fontsize=10)
    ax.set(xlim=(-21, 21), ylim=(-21, 17))
    ax.axis("off")
figure.savefig("eight_diseases.png", bbox_inches="tight")
