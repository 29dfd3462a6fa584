"""Tells a story of the page, functional regurgitation in pictures: what each slide does to the valve, from the atrium."""

import json

from matplotlib import pyplot

import coapt
from coapt import plots

with open("examples/stories/functional.json") as file:
    slides = [slide for slide in json.load(file)["slides"] if slide["view"] in ("valve", "repair")]
figure, axes = pyplot.subplots(2, 3, figsize=(10, 6))
for slide, ax in zip(slides, axes.flat):
    steps = slide.get("steps")
    plan = {"schema": "coapt.plan/1", "steps": steps} if steps else None
    closure = coapt.engine().close(slide["valve"], plan)
    plots.atrial_view(closure, ax=ax)
    ax.collections[0].colorbar.remove()
    ax.set_title(f"{slide['title']}\n{closure.measure.leak_mm2:.1f} mm²", fontsize=10)
for ax in axes.flat:
    ax.axis("off")
figure.savefig("functional.png")
