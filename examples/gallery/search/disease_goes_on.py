"""Lets the ventricle remodel further after two repairs and shows which of them keeps the valve closed."""

from matplotlib import pyplot

import coapt
from coapt import PapillaryApproximation, Plan, Ring, plots

ring, suture = Ring("generic-classic", 32), PapillaryApproximation("posteromedial", 26)
found = coapt.preset("human-functional-mr").evaluate([Plan(ring), Plan(ring, suture)], evidence=True)
figure, axes = pyplot.subplots(1, 2, figsize=(10, 4), sharey=True)
for plan, ax in zip(sorted(found.plans, key=lambda one: len(one.plan.steps)), axes):
    plots.remodelling(plan, ax=ax)
    ax.set_title("ring alone" if len(plan.plan.steps) == 1 else "ring and suture")
figure.savefig("disease_goes_on.png")
