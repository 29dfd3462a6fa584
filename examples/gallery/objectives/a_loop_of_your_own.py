"""Minimises an objective of one's own, tension of the chordae with a price on what leaks, in a loop of twelve lines."""

import random

import coapt

space = coapt.preset("human-functional-mr").space(
    objective=lambda closure: closure.measure.tension_max_n + max(0.0, closure.measure.leak_mm2 - 5.0)
)
chance, best = random.Random(1), space.evaluate(space.start)
lower, upper = space.get_bounds()
for _ in range(60):
    x = list(best.x)
    k = chance.randrange(len(x))
    x[k] = chance.uniform(lower[k], upper[k])
    trial = space.evaluate(x)
    if trial.value < best.value:  # infinite where the valve refuses the plan: trial.reason says why
        best = trial
print(f"{best.value:.2f} N: {best.plan}")
best.closure.render("strain_radial").write("a_loop_of_your_own.png")
