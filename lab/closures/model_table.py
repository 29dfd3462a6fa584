#!/usr/bin/env python3
"""Closes five presets under 256 draws of the model's own values and writes docs/figures/model.csv.

Usage: lab/closures/model_table.py [build/release/bin/coapt] [docs/figures/model.csv]

A row for each preset and parameter. The same bits on any machine.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESETS = ["human-normal", "human-functional-mr", "human-p2-prolapse", "porcine-1", "porcine-4"]


def study(coapt, preset):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([coapt, "study", "model", preset, "-o", folder, "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(run.stderr)
    return json.loads(run.stdout)


def rows_of(found):
    leak = found["leak"]
    for parameter in leak["parameters"]:
        yield {
            "valve": found["valve"],
            "draws": found["draws"],
            "untrusted": found["untrusted"],
            **{name: round(leak[name], 2) for name in leak if name.endswith("_mm2")},
            "predicted_share": round(leak["predicted_share"], 2),
            "parameter": parameter["name"],
            "lower": parameter["lower"],
            "upper": parameter["upper"],
            "sobol_first": round(parameter["first"], 3),
            "sobol_total": round(parameter["total"], 3),
            "effect_mm2": round(parameter["effect_mm2"], 2),
        }


def main():
    coapt = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/model.csv"
    rows = [row for preset in PRESETS for row in rows_of(study(coapt, preset))]
    write_table(output, rows)


if __name__ == "__main__":
    main()
