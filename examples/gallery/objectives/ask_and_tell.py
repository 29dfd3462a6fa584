"""Asks coapt's searcher for plans to try and tells it their worth: a Gaussian process learns from each batch."""

from matplotlib import pyplot

import coapt

space = coapt.preset("human-functional-mr").space(objective=lambda closure: closure.measure.tension_max_n)
searcher, values = space.searcher(seed=1), []
for _ in range(6):
    points = searcher.ask(8)
    values.append([trial.value for trial in space.evaluate_many(points)])
    searcher.tell(points, values[-1])
print(space.plan(searcher.best[0]), f"{searcher.best[1]:.2f} N")
figure, ax = pyplot.subplots()
for batch, told in enumerate(values, 1):
    ax.plot([batch] * len(told), told, "o", color="C0", alpha=0.5)
ax.plot(range(1, 7), [min(sum(values[: batch + 1], [])) for batch in range(6)], color="C1", label="best so far")
ax.set(xlabel="batch of 8 plans", ylabel="highest chordal tension, N", ylim=(0, None))
ax.legend()
figure.savefig("ask_and_tell.png")
