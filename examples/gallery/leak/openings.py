"""Outlines every opening of a leak and says where it is, how large and how wide."""

from matplotlib import pyplot

import coapt
from coapt import plots

closure = coapt.read_valve("examples/valves/bodyparts3d-leaking.json").close()
figure, ax = pyplot.subplots()
plots.atrial_view(closure, ax=ax)
for opening in closure.measure.leak.openings:
    x, y, _ = opening.centroid_mm
    words = f"{opening.area_mm2:.0f} mm²\n{', '.join(opening.segments)}"
    ax.annotate(
        words, (x, y), (x, -16), ha="center", arrowprops={"arrowstyle": "-"}, bbox={"fc": "white", "alpha": 0.9}
    )
    print(f"{opening.area_mm2:5.1f} mm², {opening.width_mm:.1f} mm wide, at {', '.join(opening.segments)}")
figure.savefig("openings.png")
