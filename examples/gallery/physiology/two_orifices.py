"""Opens a valve behind a clip: the one opening becomes two, and the gradient rises."""

from matplotlib import pyplot

import coapt
from coapt import EdgeToEdge, Plan

valve = coapt.preset("human-p2-prolapse")
figure, axes = pyplot.subplots(1, 2, figsize=(8, 3.6), sharex=True, sharey=True)
for title, plan, ax in (("as it is", None, axes[0]), ("with a clip", Plan(EdgeToEdge(width_mm=6)), axes[1])):
    opening = valve.open(plan)
    ax.fill(*valve.annulus_mm.T[:2], color="#ecd9c6")
    for one in opening.leak.openings:
        ax.fill(*list(zip(*one.outline_mm))[:2], color="#1437d8")
    ax.set(title=f"{title}: {opening.opening_area_mm2 / 100:.1f} cm², {opening.gradient_mmhg:.1f} mmHg", aspect="equal")
    print(f"{title}:", *(f"{one.area_mm2:.0f} mm²" for one in opening.leak.openings))
figure.supxlabel("to the posteromedial commissure, mm")
figure.savefig("two_orifices.png")
