"""Tries plans at random and marks those that no other beats in both leak and chordal tension (Pareto-optimal)."""

from matplotlib import pyplot

import coapt
from coapt import PapillaryApproximation, Ring

steps = Ring("generic-classic", 34), PapillaryApproximation("posteromedial", 24)
space = coapt.preset("human-functional-mr").space(*steps)
trials = [trial for trial in space.evaluate_many(space.random(80, seed=1)) if trial.closure and trial.closure.trusted]
points = [(trial.closure.measure.leak_mm2, trial.closure.measure.tension_max_n) for trial in trials]
best = sorted(p for p in points if not any(q[0] <= p[0] and q[1] <= p[1] and q != p for q in points))
figure, ax = pyplot.subplots()
ax.plot(*zip(*points), "o", alpha=0.5, label=f"{len(points)} plans")
ax.plot(*zip(*best), "D-", label="Pareto-optimal")
ax.set(xlabel="leak, mm²", ylabel="highest chordal tension, N")
ax.legend()
figure.savefig("pareto_optimal.png")
