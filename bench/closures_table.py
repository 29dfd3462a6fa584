#!/usr/bin/env python3
"""The table of closures in the README: every preset and the real valve by both methods, as Markdown.

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



def close(valve, method):
    run = subprocess.run([coapt, "close", valve, "--method", method, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    return json.loads(run.stdout)


print("| valve | triangles | status | crossing | orifice mm² | raw mm² | gap mm² | coaptation mean / min mm "
      "| in contact | steps | ms | thesis: orifice mm² | steps | ms |")
print("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|")
for name, valve in valves:
    r, t = close(valve, "fast"), close(valve, "thesis")
    c = r["coaptation"]
    touching = sum(s["contact"] for s in c["sections"])
    print(f"| {name} | {r['triangles']} | {r['status']} | {'yes' if r['crossing'] else 'no'} "
          f"| {r['orifice_area_mm2']:.1f} | {r['orifice_area_raw_mm2']:.0f} | {c['gap_area_mm2']:.1f} "
          f"| {c['height_mean_mm']:.1f} / {c['height_min_mm']:.1f} | {touching} of 9 | {r['steps']} "
          f"| {1e3 * r['seconds']:.0f} | {t['orifice_area_mm2']:.1f}{' crossed' if t['crossing'] else ''} "
          f"| {t['steps']} | {1e3 * t['seconds']:.0f} |")
