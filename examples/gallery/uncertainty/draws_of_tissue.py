"""Closes a valve under draws of tissue and chordae that no image shows, before and after a ring: how far the leak may be off."""

import csv
import subprocess

from matplotlib import pyplot

figure, ax = pyplot.subplots()
for title, plan in (("as it is", []), ("with a ring", ["--plan", "examples/plans/ring.json"])):
    study = ["coapt", "study", "model", "human-functional-mr", "--draws", "64", "-o", "model", *plan]
    subprocess.run(study, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open("model/draws.csv") as table:
        leaks = sorted(float(row["leak_mm2"]) for row in csv.DictReader(table) if row["leak_mm2"])
    ax.step(leaks, [(i + 1) / len(leaks) for i in range(len(leaks))], where="post", label=title)
    print(f"{title}: half of the draws leak less than {leaks[len(leaks) // 2]:.0f} mm²")
ax.set(xlabel="leak, mm²", ylabel="share of the draws that leak less", ylim=(0, 1))
ax.legend()
figure.savefig("draws_of_tissue.png")
