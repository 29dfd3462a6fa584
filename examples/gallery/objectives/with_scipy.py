"""Minimises an objective of one's own, leak plus a price on chordal tension, with scipy."""

from matplotlib import pyplot
from scipy.optimize import differential_evolution

import coapt
from coapt import PapillaryApproximation, Ring

told = []


def objective(closure):
    told.append(closure.measure.leak_mm2 + 20.0 * max(0.0, closure.measure.tension_max_n - 1.5))
    return told[-1]


steps = Ring("generic-classic", 34), PapillaryApproximation("posteromedial", 24)
space = coapt.preset("human-functional-mr").space(*steps, objective=objective)
bounds = list(zip(*space.get_bounds()))
found = differential_evolution(space, bounds, popsize=5, maxiter=8, seed=1, polish=False)
print(space.plan(found.x), f"objective {found.fun:.1f}")
figure, ax = pyplot.subplots()
ax.plot(told, "o", alpha=0.4, label="each closure")
ax.step(range(len(told)), [min(told[: i + 1]) for i in range(len(told))], where="post", label="best so far")
ax.set(xlabel="closure", ylabel="leak + 20 x tension above 1.5 N", ylim=(0, None))
ax.legend()
figure.savefig("with_scipy.png")
