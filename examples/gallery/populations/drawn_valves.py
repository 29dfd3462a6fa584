"""Draws diseased valves from published distributions of anatomy, and shows what each leaks before and after its disease."""

import subprocess

import pandas
from matplotlib import pyplot

make = ["coapt", "population", "make", "-n", "16", "--seed", "3", "-o", "adults"]
subprocess.run(make, check=True, capture_output=True)
members = pandas.read_csv("adults/members.csv").sort_values(["aetiology", "leak_mm2"], ignore_index=True)
print(members.groupby("aetiology")[["leak_healthy_mm2", "leak_mm2", "ap_mm", "al_pm_mm"]].mean().round(1).to_string())
figure, ax = pyplot.subplots()
ax.hlines(members.index, members.leak_healthy_mm2, members.leak_mm2, color="#ccd4dc", linewidth=3, zorder=1)
ax.plot(members.leak_healthy_mm2, members.index, "o", color="C2", label="healthy")
ax.plot(members.leak_mm2, members.index, "o", color="C1", label="diseased")
ax.set_yticks(members.index, members.aetiology)
ax.set(xlabel="leak, mm²", ylabel="one valve a line")
ax.legend()
figure.savefig("drawn_valves.png")
