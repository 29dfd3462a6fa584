#!/usr/bin/env python3
"""The table of closures in the README: every preset and the real valve, as Markdown.

Usage: bench/closures_table.py [build/release/bin/coapt]
"""
import json
import pathlib
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
coapt = sys.argv[1] if len(sys.argv) > 1 else root / "build/release/bin/coapt"
presets = [f"porcine-{i}" for i in range(1, 6)]
presets += ["human-normal", "human-functional-mr", "human-p2-prolapse"]
files = ["bodyparts3d", "bodyparts3d-1400", "bodyparts3d-2600", "bodyparts3d-leaking"]
valves = [(name, name) for name in presets]
valves += [(name, str(root / f"examples/valves/{name}.json")) for name in files]

print("| valve | triangles | status | crossing | orifice mm² | raw mm² | gap mm² | coaptation mean / min mm "
      "| sections in contact | steps | s |")
print("|---|---|---|---|---|---|---|---|---|---|---|")
for name, valve in valves:
    run = subprocess.run([coapt, "close", valve, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    r = json.loads(run.stdout)
    c = r["coaptation"]
    touching = sum(s["contact"] for s in c["sections"])
    print(f"| {name} | {r['triangles']} | {r['status']} | {'yes' if r['crossing'] else 'no'} "
          f"| {r['orifice_area_mm2']:.1f} | {r['orifice_area_raw_mm2']:.0f} | {c['gap_area_mm2']:.1f} "
          f"| {c['height_mean_mm']:.1f} / {c['height_min_mm']:.1f} | {touching} of 9 | {r['steps']} "
          f"| {r['seconds']:.2f} |")
