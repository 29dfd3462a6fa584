#!/usr/bin/env python3
"""Charts speed against accuracy of two programs, one after the other, into one table with a column "release".

Each program's errors are distances from its own model's reference (membrane continuum, 5,200 triangles, residual 1e-6), and
each closes its own presets.

Usage: lab/closures/speed_accuracy_table.py OLD NEW OUTPUT.csv
OLD, NEW: programs that have `chart speed-accuracy`, such as release 0.1's coapt and build/release/bin/coapt-lab. The rows of
NEW come first, with an empty release.
"""
import argparse
import csv
import pathlib
import subprocess
import tempfile

from table_file import write_table


def charted(program, release):
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run([program, "chart", "speed-accuracy", "-o", directory], check=True)
        with open(pathlib.Path(directory) / "speed-accuracy.csv", newline="") as file:
            return [row | {"release": release} for row in csv.DictReader(file)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("output")
    parser.add_argument("--release", default="0.1", help="name of the old one (default: %(default)s)")
    arguments = parser.parse_args()
    old = charted(arguments.old, arguments.release)
    write_table(arguments.output, charted(arguments.new, "") + old)


if __name__ == "__main__":
    main()
