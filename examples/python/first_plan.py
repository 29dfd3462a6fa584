#!/usr/bin/env python3
"""A leaking valve, a repair by hand, and what a search finds instead.

    coapt-server --db coapt.sqlite &
    PYTHONPATH=clients/python examples/python/first_plan.py [VALVE.json]

COAPT_SERVER and COAPT_TOKEN say where the service is. Pictures and a report go into the present folder.
"""

import pathlib
import sys

from coapt import NOTICE, Client, CoaptError, PapillaryApproximation, Plan, Ring, show_progress


def main(valve: str | pathlib.Path) -> None:
    client = Client()
    before = client.close(valve)
    print(
        f"Before: leak {before.measure.leak_mm2:.1f} mm2, coaptation {before.measure.coaptation_height_mean_mm:.1f} mm"
    )

    by_hand = Plan(Ring("generic-classic", size_mm=38), PapillaryApproximation("posteromedial", suture_length_mm=24))
    after = client.close(valve, by_hand)
    print(f"By hand: leak {after.measure.leak_mm2:.1f} mm2")

    job = client.search(valve, evaluations=60, seed=1, plans=2, region_points=65)
    for plan in job.wait(progress=show_progress).result().plans:
        leak = plan.leak_mm2
        print(
            f"{plan.rank}. leak {leak.nominal:.1f} mm2 as planned, {leak.mean:.1f} (sd {leak.sd:.1f}) over its region"
        )
        print(*(f"   {line}" for line in plan.description), sep="\n")

    best = job.result().plans[0]
    best.picture().write("before-after.png")
    best.plan.write("best-plan.json")
    pathlib.Path("closed.stl").write_bytes(best.mesh("stl"))
    pathlib.Path("report.html").write_text(job.report())
    print("Written: before-after.png, best-plan.json, closed.stl, report.html")
    print(NOTICE, file=sys.stderr)


if __name__ == "__main__":
    try:
        main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else "human-functional-mr")
    except CoaptError as error:
        sys.exit(f"first_plan.py: {error}")
