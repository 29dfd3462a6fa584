#!/usr/bin/env python3
"""Closes one leaking preset on five meshes by both membranes and writes docs/figures/membranes.csv.

Usage: lab/closures/membranes_table.py [build/release/bin/coapt] [docs/figures/membranes.csv]
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESET = "human-functional-mr"
TRIANGLES = [650, 1300, 2600, 5200, 10400]
MEMBRANES = ["springs", "continuum"]


def close(coapt, triangles, membrane):
    with tempfile.NamedTemporaryFile(suffix=".json") as valve:
        subprocess.run([coapt, "valve", "make", PRESET, "--triangles", str(triangles), "-o", valve.name], check=True)
        run = subprocess.run(
            [coapt, "close", valve.name, "--membrane", membrane, "--json"], capture_output=True, text=True
        )
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    closed = json.loads(run.stdout)
    return {
        "valve": PRESET,
        "membrane": membrane,
        "triangles": closed["triangles"],
        "status": closed["status"],
        "crossing": str(closed["crossing"]).lower(),
        "leak_mm2": round(closed["leak_mm2"], 2),
    }


def main():
    coapt = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/membranes.csv"
    rows = [close(coapt, triangles, membrane) for membrane in MEMBRANES for triangles in TRIANGLES]
    write_table(output, rows)


if __name__ == "__main__":
    main()
