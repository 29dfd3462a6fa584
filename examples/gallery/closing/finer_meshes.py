"""Makes a valve on finer and finer meshes and draws how its leak settles, with the error that coapt states."""

import subprocess

from matplotlib import pyplot

import coapt

figure, ax = pyplot.subplots()
for name in ("human-functional-mr", "barlow"):
    leaks = []
    for triangles in (300, 650, 1300, 2600):
        made = ["coapt", "valve", "make", name, "--triangles", str(triangles), "-o", "valve.json"]
        subprocess.run(made, check=True, stderr=subprocess.DEVNULL)
        valve = coapt.read_valve("valve.json")
        leaks.append((len(valve.faces), valve.close().measure.leak))
    sizes, leaks = zip(*leaks)
    ax.errorbar(
        sizes, [one.area_mm2 for one in leaks], [one.error_mm2 for one in leaks], fmt="o-", capsize=3, label=name
    )
ax.set_xscale("log")
ax.set_xticks(sizes, sizes)
ax.minorticks_off()
ax.set(xlabel="triangles", ylabel="leak, mm²", ylim=(0, None))
ax.legend()
figure.savefig("finer_meshes.png")
