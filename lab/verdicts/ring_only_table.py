#!/usr/bin/python3
"""Which repairs come first with and without a price for opening and durability: ring-only.csv.

  ring_only_table.py [OUTPUT] [--coapt build/release/bin/coapt] [--evaluations 600]

Six valves, each searched twice with the same seed: as systole alone would have it (no price for gradients and durability), and by
the default prices.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "lab" / "closures"))
from table_file import write_table  # noqa: E402

VALVES = ("human-functional-mr", "secondary-mr", "porcine-1", "human-p2-prolapse", "fibroelastic-flail", "barlow")
SYSTOLE_ALONE = {"gradient_above_3": 0.0, "gradient_above_5": 0.0, "durability": 0.0}


def kind(step):
    size = step.get("size_mm")
    return f"ring {size:g}" if size else {"annuloplasty": "own ring"}.get(step["step"], step["step"].replace("_", " "))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("docs/figures/ring-only.csv"))
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    parser.add_argument("--evaluations", type=int, default=600)
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        search = pathlib.Path(folder) / "options.json"
        for valve in VALVES:
            for prices, weights in (("systole alone", SYSTOLE_ALONE), ("default", {})):
                search.write_text(json.dumps({"weights": weights}))
                command = [options.coapt, "plan", valve, "--search", search, "--evaluations", str(options.evaluations)]
                result = subprocess.run([*command, "--json"], capture_output=True, text=True, check=False)
                first = json.loads(result.stdout)["plans"][0]
                steps = first["plan"]["steps"]
                opening = min(first["opening_area_mm2"], first["projected_area_mm2"])
                row = {"valve": valve, "prices": prices, "first plan": "; ".join(map(kind, steps))}
                row["ring alone"] = int([step["step"] for step in steps] == ["annuloplasty"])
                row["leak_mm2"] = round(first["leak_mm2"]["mean"] + first["leak_mm2"]["sd"], 2)
                row |= {"opening_cm2": round(0.01 * opening, 1), "gradient_mmhg": round(first["gradient_mmhg"], 1)}
                row |= {"durability_mm": round(first["durability_mm"], 1), "robust": int(first["closes_robustly"])}
                rows.append(row)
                print(row, flush=True)
    write_table(options.output, rows)


if __name__ == "__main__":
    main()
