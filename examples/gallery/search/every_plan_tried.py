"""Searches plans without a ring and draws every plan that was tried, ranked or not: its leak and the pull of its chordae."""

import coapt

valve = coapt.preset("human-functional-mr")
options = {"evaluations": 150, "seed": 1, "plans": 1, "region_points": 2, "model_draws": 0, "fine_levels": 0}
job = valve.search(evidence=False, openings=False, forbidden=["annuloplasty"], **options)
tried = job.wait().evaluations().to_frame()
print(tried[["leak_mm2", "tension_max_n"]].describe().round(1).to_string())
ax = tried.plot.scatter("leak_mm2", "tension_max_n", alpha=0.6)
ax.set(xlabel="leak (estimate of the search), mm²", ylabel="highest chordal tension, N")
ax.figure.savefig("every_plan_tried.png")
