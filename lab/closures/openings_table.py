#!/usr/bin/python3
"""Opening and leak of six valves by the size of their ring: openings.csv.

  openings_table.py [OUTPUT] [--coapt build/release/bin/coapt]

Rings of shape generic-classic, and none. Areas in cm2: `opening_cm2` of the least surface, `projected_cm2` as seen along the annulus's normal;
mean gradients at rest and at exercise, of the opening.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

from table_file import write_table

VALVES = ("human-normal", "human-functional-mr", "human-p2-prolapse", "secondary-mr", "barlow", "porcine-1")
SIZES_MM = (None, 24, 26, 28, 30, 32, 34, 36)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("docs/figures/openings.csv"))
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        plan = pathlib.Path(folder) / "plan.json"

        def answer(command, valve):
            result = subprocess.run(
                [options.coapt, command, valve, "--plan", plan, "--json"], capture_output=True, text=True, check=False
            )
            return json.loads(result.stdout)

        for valve in VALVES:
            for size in SIZES_MM:
                ring = [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": size}] if size else []
                plan.write_text(json.dumps({"schema": "coapt.plan/1", "steps": ring}))
                opened, closed = answer("open", valve), answer("close", valve)
                known = opened["status"] == "converged"
                row = {"valve": valve, "ring_mm": size or "none", "opened": opened["status"]}
                for name, key in (("opening", "opening_area_mm2"), ("projected", "projected_area_mm2")):
                    row[f"{name}_cm2"] = round(0.01 * opened[key], 2) if known else ""
                for key in ("gradient_mmhg", "gradient_exercise_mmhg"):
                    row[key] = round(opened[key], 1) if known else ""
                row["leak_mm2"] = round(closed["leak_mm2"], 1)
                rows.append(row)
                print(row, flush=True)
    write_table(options.output, rows)


if __name__ == "__main__":
    main()
