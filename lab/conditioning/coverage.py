#!/usr/bin/python3
"""How often intervals conditioned on what was observed of a valve hold its true repaired leak, on draws whose truth is known.

  coapt study model VALVE --draws 256 -o before
  coapt study model VALVE --draws 256 --plan PLAN -o after
  coverage.py before/draws.csv after/draws.csv [before and after of more valves] [--share 0.25] [--repeats 8]

Both studies have the same draws. Each draw is the truth once: its unrepaired leak is observed with an error of SHARE (at least 1 mm2), the
other draws are weighed by that as search/conditioning.cpp does, and their 5 to 95 % interval of the repaired leak holds the
true one or does not. Needs python3-numpy.
"""

import argparse
import csv

import numpy as np

LEAST_SD_MM2 = 1.0
LEAST_EFFECTIVE = 20.0


def leaks(path):
    """NaN of draws that are not to be trusted."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return np.array([float(row["leak_mm2"]) if row["trusted"] in ("1", "true") else np.nan for row in rows])


def quantile(values, weights, share):
    """As core/metrics/quantile.h."""
    order = np.argsort(values)
    values, weights = values[order], weights[order]
    kept = weights > 0.0
    values, weights = values[kept], weights[kept]
    middles = np.cumsum(weights) - 0.5 * weights
    return np.interp(middles[0] + share * (middles[-1] - middles[0]), middles, values)


def observed_draws(before, after, share, repeats, noise):
    """Of each draw and each time that it is observed: whether the interval holds it, its width, effective draws."""
    known = np.isfinite(before) & np.isfinite(after)
    before, after = before[known], after[known]
    rows = []
    for truth in range(len(before)):
        others = np.arange(len(before)) != truth
        sd = max(LEAST_SD_MM2, share * before[truth])
        for _ in range(repeats):
            seen = before[truth] + sd * noise.standard_normal()
            square = ((before[others] - seen) / sd) ** 2
            weights = np.exp(-0.5 * (square - square.min()))
            weights /= weights.sum()
            low, high = (quantile(after[others], weights, at) for at in (0.05, 0.95))
            rows.append((low <= after[truth] <= high, high - low, 1.0 / (weights**2).sum()))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "tables", nargs="+", metavar="before after", help="draws.csv of a valve, unrepaired and repaired"
    )
    parser.add_argument("--share", type=float, default=0.25)
    parser.add_argument("--repeats", type=int, default=8, help="observations of each draw")
    arguments = parser.parse_args()
    if len(arguments.tables) % 2:
        parser.error("each valve has two tables")
    noise = np.random.default_rng(1)
    rows, per_valve = [], []
    for before, after in zip(*[iter(map(leaks, arguments.tables))] * 2):
        if len(before) != len(after):
            parser.error("the studies have different numbers of draws")
        own = observed_draws(before, after, arguments.share, arguments.repeats, noise)
        rows += own
        per_valve.append(np.mean([held for held, _, _ in own]))
        alike = after[np.isfinite(before) & np.isfinite(after)]
        low, high = (quantile(alike, np.ones(len(alike)), at) for at in (0.05, 0.95))
        print(
            f"{len(alike)} draws closed before and after; repaired leak {low:.1f} to {high:.1f} mm2 without an "
            f"observation; {100 * per_valve[-1]:.0f} % of 90 % intervals hold the true leak"
        )
    held, widths, effective = map(np.array, zip(*rows))
    held = held.astype(bool)
    if len(per_valve) > 1:
        print(
            f"{len(per_valve)} valves: {100 * min(per_valve):.0f} to {100 * max(per_valve):.0f} % of their intervals hold"
        )
    enough = effective >= LEAST_EFFECTIVE
    for name, which in (("all", np.full(len(held), True)), (f"{LEAST_EFFECTIVE:.0f} effective draws or more", enough)):
        if which.any():
            print(
                f"{name}: {which.sum()} observations, {100 * held[which].mean():.0f} % of 90 % intervals hold the true leak, "
                f"median width {np.median(widths[which]):.1f} mm2, median {np.median(effective[which]):.0f} effective draws"
            )


if __name__ == "__main__":
    main()
