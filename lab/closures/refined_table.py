#!/usr/bin/python3
"""Closes three valves on their own mesh, on that refined once, and made anew with as many triangles: refined.csv.

Usage: lab/closures/refined_table.py [build/release/bin/coapt] [docs/figures/refined.csv]

Leaks in mm2; two of the valves are dilated. The same bits on any machine.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from table_file import write_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
DILATION_PERCENT = {"human-functional-mr": 0, "porcine-1": 20, "human-normal": 20}
ONE_REFINEMENT = ("--converge", "--within", "0.001", "--most-vertices", "2000")


def main():
    coapt = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coapt"
    output = sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/figures/refined.csv"

    def run(*arguments):
        done = subprocess.run([coapt, *map(str, arguments)], capture_output=True, text=True)
        if done.returncode not in (0, 3):
            sys.exit(done.stderr)
        return done.stdout

    def row(valve, dilation, folder):
        made = {}
        for name, mesh in (("own", ()), ("anew", ("--triangles", 2600))):
            made[name] = folder / f"{name}.json"
            run("valve", "make", valve, *mesh, "-o", made[name])
            if dilation:
                run("valve", "remodel", made[name], "--ap-dilation", dilation, "-o", made[name])
        levels = json.loads(run("close", made["own"], *ONE_REFINEMENT, "--json"))["convergence"]["levels"]
        anew = json.loads(run("close", made["anew"], "--json"))
        return {
            "valve": valve,
            "dilation_percent": dilation,
            "triangles": levels[0]["triangles"],
            "leak_mm2": round(levels[0]["leak_mm2"], 2),
            "refined_triangles": levels[1]["triangles"],
            "refined_mm2": round(levels[1]["leak_mm2"], 2),
            "anew_triangles": anew["triangles"],
            "anew_mm2": round(anew["leak_mm2"], 2),
        }

    with tempfile.TemporaryDirectory() as folder:
        write_table(output, [row(valve, share, pathlib.Path(folder)) for valve, share in DILATION_PERCENT.items()])


if __name__ == "__main__":
    main()
