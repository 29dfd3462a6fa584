#!/usr/bin/env python3
"""Measures what the parts of a closure cost on growing meshes and writes docs/figures/growth.csv; lab/charts/plot.py draws it.

Usage: lab/closures/growth_table.py [build/release/bin/closure_benchmark] [docs/figures/growth.csv]

human-normal after 100 steps, on the way, and after 250, when the leaflets touch; processor time of one core.
"""
import json
import pathlib
import subprocess
import sys

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Benchmark: name of the part, and how many of it one run times.
PARTS = {
    "Layout": ("set-up", 1),
    "ListOfPairs": ("list of pairs", 1),
    "LookForCrossings": ("look for crossings", 1),
    "TenSteps": ("step", 10),
    "TenStepsWithoutContact": ("step without contact", 10),
}


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/closure_benchmark"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/growth.csv"
    command = [program, f"--benchmark_filter=^({'|'.join(PARTS)})/", "--benchmark_format=json"]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    rows = []
    for measured in json.loads(run.stdout)["benchmarks"]:
        name, triangles, *steps = measured["name"].split("/")
        part, times = PARTS[name]
        rows.append(
            {
                "part": part,
                "triangles": triangles,
                "steps_before": steps[0] if steps else 0,
                "microseconds": round(measured["cpu_time"] / times, 2),
            }
        )
    write_table(output, rows)


if __name__ == "__main__":
    main()
