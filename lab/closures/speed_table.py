#!/usr/bin/env python3
"""Measures varied closures of the eight presets on one core and writes docs/figures/speed.csv. Wants a quiet machine.

Usage: lab/closures/speed_table.py [build/release/bin/coapt-lab] [docs/figures/speed.csv]
"""
import json
import pathlib
import subprocess
import sys

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRESETS = ["human-normal", "human-functional-mr", "human-p2-prolapse"] + [f"porcine-{i}" for i in range(1, 6)]
COUNT = 250
FIELDS = [
    "method",
    "warm",
    "count",
    "seed",
    "median_ms",
    "p90_ms",
    "closures_per_second_per_core",
    "median_steps",
    "second_attempts",
    "unconverged",
    "crossed",
]


def bench(program, preset, *options):
    run = subprocess.run(
        [
            program,
            "bench",
            "closures",
            preset,
            "--count",
            str(COUNT),
            "--threads",
            "1",
            "--no-accuracy",
            "--json",
            *options,
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    measured = json.loads(run.stdout)
    return {"preset": preset} | {field: written(measured[field]) for field in FIELDS}


def written(value):
    if isinstance(value, bool):
        return str(value).lower()
    return round(value, 2) if isinstance(value, float) else value


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt-lab"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/speed.csv"
    rows = [bench(program, preset, *start) for preset in PRESETS for start in ((), ("--warm",))]
    rows.append(bench(program, "human-normal", "--method", "thesis"))
    write_table(output, rows)


if __name__ == "__main__":
    main()
