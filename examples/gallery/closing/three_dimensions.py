"""Draws closed leaflets with their chordae and the rims of what leaks in three dimensions, by VTK without a display."""

from matplotlib import pyplot
from matplotlib.image import imread

import coapt

valve = coapt.preset("human-p2-prolapse")
figure, axes = pyplot.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
for ax, (name, seen_from) in zip(axes, {"from behind": (0.4, -1.0, 0.5), "from the atrium": (0, 0, 1)}.items()):
    valve.close().render("strain_radial", seen_from=seen_from).write("view.png")
    ax.imshow(imread("view.png"))
    ax.set_title(name)
    ax.set_axis_off()
figure.savefig("three_dimensions.png", dpi=160)
