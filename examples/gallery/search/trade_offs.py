"""Searches repair plans in few closures and draws what the ranked ones trade: tension of the chordae over the leak left."""

import coapt
from coapt import plots

valve = coapt.preset("human-functional-mr")
options = {"evaluations": 100, "seed": 1, "plans": 6, "region_points": 9, "model_draws": 0, "fine_levels": 0}
result = valve.search(evidence=False, forbidden=["annuloplasty"], **options).result()
for plan in result.plans:
    print(f"{plan.rank}. leak {plan.leak_mm2.mean:.1f} ± {plan.leak_mm2.sd:.1f} mm²", *plan.description, sep="\n   ")
plots.plans(result).figure.savefig("trade_offs.png")
