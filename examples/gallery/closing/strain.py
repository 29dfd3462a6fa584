"""Colours the closed leaflets, seen from the atrium, by their circumferential and their radial strain."""

import numpy
from matplotlib import pyplot

import coapt

closure = coapt.preset("human-normal").close()
points, faces = closure.closed_mm, closure.leaflets().faces
upwards = numpy.argsort(points[faces][:, :, 2].mean(axis=1))  # what is higher hides what is lower
figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8), sharey=True)
for way, (name, ax) in enumerate(zip(("along the fibres", "across the fibres"), axes)):
    strain = 100 * closure.strain[upwards, way]
    drawn = ax.tripcolor(*points.T[:2], faces[upwards], strain, cmap="coolwarm", vmin=-25, vmax=25)
    ax.set(title=name, aspect="equal", xlabel="to the posteromedial commissure, mm")
    print(f"{name}: median {numpy.median(strain):.1f} %, nine of ten below {numpy.quantile(strain, 0.9):.1f} %")
axes[0].set_ylabel("anterior, mm")
figure.colorbar(drawn, ax=axes, label="strain, %", extend="both")
figure.savefig("strain.png")
