"""Makes another valve of a preset (a wider annulus, a displaced papillary muscle), saves it, reads it and closes it."""

from matplotlib import pyplot

import coapt
from coapt import plots

normal = coapt.preset("human-normal")
wider = normal.with_arrays(annulus_mm=normal.annulus_mm * [1.0, 1.15, 1.0])
tip = normal.papillary_mm["posteromedial"]
both = wider.replace(name="wider and tethered", papillary_mm={"posteromedial": tip + [4, -3, -3]})
both.save("mine.json")
assert coapt.read_valve("mine.json") == both

figure, axes = pyplot.subplots(1, 3, figsize=(9, 2.3), sharex=True, sharey=True)
for title, valve, ax in zip(("healthy", "wider", "wider, tethered"), (normal, wider, both), axes):
    closure = valve.close()
    plots.section(closure, ax=ax)
    ax.set_title(f"{title}: {closure.measure.leak_mm2:.0f} mm²")
figure.savefig("a_valve_of_your_own.png")
