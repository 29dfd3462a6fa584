#!/usr/bin/env python3
"""Closes the healthy human preset and the five of diseases and writes docs/figures/diseases.csv.

Usage: lab/closures/diseases_table.py [build/release/bin/coapt] [docs/figures/diseases.csv]

The same bits on any machine.
"""
import json
import pathlib
import subprocess
import sys

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESETS = ("human-normal", "barlow", "fibroelastic-flail", "marfan", "secondary-mr", "hypertrophic")


def row(coapt, valve):
    run = subprocess.run([coapt, "close", valve, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 3):
        sys.exit(run.stderr)
    closed = json.loads(run.stdout)
    return {
        "valve": valve,
        "status": closed["status"],
        "leak_mm2": round(closed["leak_mm2"], 2),
        "leak_error_mm2": round(closed["leak"]["error_mm2"], 2),
        "coaptation_area_percent": round(100 * closed["coaptation_area_index"], 1),
        "tenting_height_mm": round(closed["tenting_height_mm"], 2),
    }


def main():
    coapt = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/diseases.csv"
    write_table(output, [row(coapt, valve) for valve in PRESETS])


if __name__ == "__main__":
    main()
