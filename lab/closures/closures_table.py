#!/usr/bin/env python3
"""Closes every preset and the real valve by both methods and writes docs/figures/closures.csv.

Usage: lab/closures/closures_table.py [build/release/bin/coapt] [docs/figures/closures.csv]

The same bits on any machine; times are measured by coapt-lab bench closures.
"""
import json
import pathlib
import subprocess
import sys

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESETS = [f"porcine-{i}" for i in range(1, 6)] + ["human-normal", "human-functional-mr", "human-p2-prolapse"]
FILES = ["bodyparts3d", "bodyparts3d-1400", "bodyparts3d-2600", "bodyparts3d-leaking"]
METHODS = ["fast", "thesis"]


def close(coapt, valve, method):
    run = subprocess.run([coapt, "close", valve, "--method", method, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    return json.loads(run.stdout)


def row(name, method, closed):
    coaptation = closed["coaptation"]
    return {
        "valve": name,
        "triangles": closed["triangles"],
        "method": method,
        "status": closed["status"],
        "crossing": str(closed["crossing"]).lower(),
        "leak_mm2": round(closed["leak_mm2"], 2),
        "openings": len(closed["leak"]["openings"]),
        "coaptation_mean_mm": round(coaptation["height_mean_mm"], 2),
        "coaptation_min_mm": round(coaptation["height_min_mm"], 2),
        "sections_in_contact": sum(section["contact"] for section in coaptation["sections"]),
        "steps": closed["steps"],
    }


def main():
    coapt = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/closures.csv"
    valves = [(name, name) for name in PRESETS]
    valves += [(name, str(ROOT / f"examples/valves/{name}.json")) for name in FILES]
    rows = [row(name, method, close(coapt, valve, method)) for name, valve in valves for method in METHODS]
    write_table(output, rows)


if __name__ == "__main__":
    main()
