"""Maps the leak of one plan over errors of the hand: suture lengths off by a millimetre, papillary tips off by degrees."""

import coapt
from coapt import PapillaryApproximation, Plan, Ring, plots

plan = Plan(Ring("generic-classic", 34), PapillaryApproximation("posteromedial", 26))
ranked = coapt.preset("human-functional-mr").evaluate([plan], region_points=289).plans[0]
leak = ranked.leak_mm2
print(
    f"as planned {leak.nominal:.1f} mm², over its region {leak.mean:.1f} ± {leak.sd:.1f}, at worst {leak.worst:.1f} mm²"
)
plots.leak_map(ranked).figure.savefig("errors_of_execution.png")
