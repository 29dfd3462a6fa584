"""Uses the protocol of pygmo, bounds and a batch of fitness values, in a loop of differential evolution that knows no valve."""

import numpy
from matplotlib import pyplot

import coapt


def leak_and_pull(closure):
    return closure.measure.leak_mm2 + closure.measure.tension_sum_n


space = coapt.preset("secondary-mr").space(objective=leak_and_pull)
low, high = map(numpy.array, space.get_bounds())
chance, best = numpy.random.default_rng(1), []
points = low + (high - low) * chance.random((12, len(low)))
values = space.batch_fitness(points.ravel())
for _ in range(8):
    a, b = chance.permutation(12), chance.permutation(12)
    moved = numpy.clip(points[values.argmin()] + 0.7 * (points[a] - points[b]), low, high)
    trials = numpy.where(chance.random(points.shape) < 0.7, moved, points)
    worth = space.batch_fitness(trials.ravel())
    points[worth < values] = trials[worth < values]
    values = numpy.minimum(values, worth)
    best.append(values.copy())
print(space.plan(points[values.argmin()]), f"{values.min():.2f} mm² and newtons")
figure, ax = pyplot.subplots()
ax.plot(range(1, 9), [generation.min() for generation in best], "o-", label="best")
ax.plot(range(1, 9), [numpy.median(generation) for generation in best], "s--", label="median")
ax.set(xlabel="generation of 12 plans", ylabel="leak, mm², plus pull of the chordae, N")
ax.legend()
figure.savefig("differential_evolution.png")
