#!/usr/bin/env python3
"""The numbers of core/metrics/area_error.cpp from `coapt-lab chart mesh`, and how well they hold on valves kept aside.

The error of a printed leak on n triangles against the finest mesh is bounded for nine scenes of ten by
(closed + rim * sqrt(area)) * (650 / n)^q: an opening's error is that of its rim. closed is chosen over scenes that leak less
than 0.5 mm2, rim over the others, q from the mean errors.

Usage: lab/closures/area_error_table.py [docs/figures/mesh*.csv]
"""

import csv
import math
import pathlib
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASIDE = {"human-normal", "porcine-4"}  # and every second anatomy
OPEN_MM2 = 0.5
TRIANGLES = 650
KEPT = 0.9


class Point(NamedTuple):
    triangles: int
    finest: int
    area: float
    error: float


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, math.ceil(share * len(values)) - 1)]


def read(paths):
    """Points of the valves that the numbers are chosen on, and of those kept aside."""
    rows = []
    for path in paths:
        with open(path, newline="") as file:
            rows += [row for row in csv.DictReader(file) if row["trusted"] == "true"]
    anatomies = sorted({row["valve"] for row in rows if row["valve"].startswith("random-")})
    aside = ASIDE | set(anatomies[1::2])
    points = {False: [], True: []}
    for row in rows:
        here, there = float(row["leak_mm2"]), float(row["reference_leak_mm2"])
        point = Point(int(row["triangles"]), int(row["reference_triangles"]), here, abs(here - there))
        points[row["valve"] in aside].append(point)
    return points[False], points[True]


def power(points):
    """q by least squares on the logarithm of the mean error, of meshes at least four times coarser than the finest."""
    points = [p for p in points if 4 * p.triangles <= p.finest and p.area >= OPEN_MM2]
    xs, ys = [], []
    for n in sorted({p.triangles for p in points}):
        errors = [p.error for p in points if p.triangles == n]
        xs.append(math.log(n))
        ys.append(math.log(sum(errors) / len(errors)))
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    return -sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / sum((x - mean_x) ** 2 for x in xs)


def at_650(point, q):
    """The error as it would be with 650 triangles."""
    return point.error * (point.triangles / TRIANGLES) ** q


def numbers(points):
    q = power(points)
    closed = quantile([at_650(p, q) for p in points if p.area < OPEN_MM2], KEPT)
    rim = quantile([(at_650(p, q) - closed) / math.sqrt(p.area) for p in points if p.area >= OPEN_MM2], KEPT)
    return q, closed, rim


def share_kept(points, q, closed, rim):
    kept = [at_650(p, q) <= closed + rim * math.sqrt(p.area) for p in points]
    return f"{sum(kept)} of {len(kept)}" if kept else "none"


def main():
    chosen_on, aside = read(sys.argv[1:] or sorted((ROOT / "docs/figures").glob("mesh*.csv")))
    found = numbers(chosen_on)
    print("chosen on half of the valves: q {:.2f}, closed {:.2f} mm2, rim {:.2f} mm".format(*found))
    for n in sorted({p.triangles for p in aside}):
        here = [p for p in aside if p.triangles == n]
        leaking = [p for p in here if p.area >= OPEN_MM2]
        print(f"  kept by the others, {n} triangles: {share_kept(here, *found)}, leaking {share_kept(leaking, *found)}")
    print("of all valves: q {:.2f}, closed {:.2f} mm2, rim {:.2f} mm".format(*numbers(chosen_on + aside)))


if __name__ == "__main__":
    main()
