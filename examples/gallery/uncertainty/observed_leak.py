"""Tells a valve what an image showed of its leak; draws of the tissue that look otherwise count less from then on."""

import json
import pathlib
import subprocess

from matplotlib import pyplot

import coapt

NAME = "human-functional-mr"


def tissue(valve):
    command = ["coapt", "close", valve, "--draws", "64", "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["leak"]["tissue"]


figure, ax = pyplot.subplots(figsize=(7, 2.6))
rows = [("nothing observed", None), ("70 ± 10 mm² observed", 70), ("40 ± 10 mm² observed", 40)]
for place, (title, leak) in enumerate(rows):
    if leak is not None:
        seen = coapt.engine().observe(NAME, {"leak_mm2": {"value": leak, "sd": 10, "source": "3D planimetry"}})
        pathlib.Path("seen.json").write_text(json.dumps(seen))
    low, high = tissue(NAME if leak is None else "seen.json")
    ax.plot([low, high], [place, place], linewidth=9, solid_capstyle="butt")
    print(f"{title}: {low:.0f} to {high:.0f} mm² (5 to 95 %)")
ax.set_yticks(range(len(rows)), [title for title, _ in rows])
ax.set(xlabel="leak by what is not known of the tissue, 5 to 95 %, mm²", xlim=(0, None), ylim=(2.6, -0.6))
figure.savefig("observed_leak.png")
