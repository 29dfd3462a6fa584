#!/usr/bin/env python3
"""Closes the same number of varied scenes by two programs in turn, round by round, and prints what the second takes of
the first's time: so load that comes and goes falls on both. Each closes its own presets.

Usage: lab/closures/releases_table.py OLD NEW [OUTPUT.csv] [--rounds N] [--count N]
OLD, NEW: programs that have `bench closures`, such as release 0.1's coapt and build/release/bin/coapt-lab.
"""
import argparse
import itertools
import json
import statistics
import subprocess
import sys

from table_file import write_table

PRESETS = ["human-normal", "human-functional-mr", "human-p2-prolapse"] + [f"porcine-{i}" for i in range(1, 6)]
FIRST_SEED = 101  # of none of the other tables
# By which options: release 0.1 starts from one neighbour at best.
STARTS = {"cold": ([], []), "warm": (["--warm"], ["--warm"]), "predicted": (["--warm"], ["--predicted"])}


def bench(program, preset, seed, count, options):
    command = [program, "bench", "closures", preset, "--count", str(count), "--seed", str(seed), "--threads", "1"]
    run = subprocess.run(command + ["--no-accuracy", "--json", *options], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def compared(start, preset, arguments):
    """Medians over the rounds; a round's ratio is of closures a second, rare slow ones included."""
    old, new = [], []
    for i in range(arguments.rounds):
        for program, measured, options in zip((arguments.old, arguments.new), (old, new), STARTS[start]):
            measured.append(bench(program, preset, FIRST_SEED + i, arguments.count, options))
    ratios = sorted(a["closures_per_second_per_core"] / b["closures_per_second_per_core"] for a, b in zip(old, new))

    def median(field, of):
        return round(statistics.median(measured[field] for measured in of), 2)

    return {
        "preset": preset,
        "start": start,
        "old_median_ms": median("median_ms", old),
        "new_median_ms": median("median_ms", new),
        "old_per_second": median("closures_per_second_per_core", old),
        "new_per_second": median("closures_per_second_per_core", new),
        "time": round(statistics.median(ratios), 3),
        "time_least": round(ratios[0], 3),
        "time_most": round(ratios[-1], 3),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("output", nargs="?")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--count", type=int, default=20, help="scenes a round")
    arguments = parser.parse_args()
    rows = []
    for start, preset in itertools.product(STARTS, PRESETS):
        rows.append(compared(start, preset, arguments))
        print(", ".join(f"{key} {value}" for key, value in rows[-1].items()), file=sys.stderr)
    if arguments.output:
        write_table(arguments.output, rows)


if __name__ == "__main__":
    main()
