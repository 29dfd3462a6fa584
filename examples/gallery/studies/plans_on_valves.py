"""Closes four valves with five plans and draws the leaks as a table: no one plan suits them all."""

from matplotlib import pyplot

import coapt

VALVES = ("human-functional-mr", "secondary-mr", "human-p2-prolapse", "barlow")
PLANS = ("ring", "own-ring", "edge-to-edge", "neochorda", "resection-triangular")
table = coapt.engine().map(VALVES, [f"examples/plans/{name}.json" for name in PLANS]).to_frame()
leaks = table.pivot(index="valve", columns="plan", values="leak_mm2").reindex(index=VALVES, columns=PLANS)
print(leaks.round(1).to_string())
figure, ax = pyplot.subplots()
cells = ax.imshow(leaks, cmap="viridis_r", vmin=0, vmax=40)
for row, name in enumerate(VALVES):
    for column, plan in enumerate(PLANS):
        leak = leaks.loc[name, plan]
        ax.text(column, row, f"{leak:.0f}", ha="center", va="center", color="white" if leak > 20 else "black")
ax.set_xticks(range(len(PLANS)), PLANS, rotation=20)
ax.set_yticks(range(len(VALVES)), VALVES)
ax.spines[:].set_visible(False)
figure.colorbar(cells, label="leak, mm²")
figure.savefig("plans_on_valves.png")
