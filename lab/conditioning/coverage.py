#!/usr/bin/python3
"""How often intervals conditioned on what was observed of a valve hold its true repaired leak, on draws whose truth is known.

  coapt study model VALVE --draws 64 --plan PLAN -o drawn
  coverage.py drawn/draws.csv [of more valves] [--share 0.25] [--repeats 8]
  coverage.py --information drawn/draws.csv

Each draw is the truth once: its unrepaired leak is observed with an error of SHARE (at least 1 mm2), the other draws are
weighed by that as search/conditioning.cpp does, and their 5 to 95 % interval of the repaired leak holds the true one or does
not. --information prints what each measurement of `coapt study information` removes of the repaired leak's variance, by such
weights alone: what the weighed mean misses of each truth. Needs python3-numpy.
"""

import argparse
import csv

import numpy as np

LEAST_SD_MM2 = 1.0
LEAST_EFFECTIVE = 20.0
LEAK, TENTING, GAP = "unrepaired_leak_mm2", "unrepaired_tenting_area_mm2", "unrepaired_widest_gap_mm"
# Figures and their standard deviations, as in search/studies/information.cpp; of None the share of the leak.
MEASUREMENTS = {
    "regurgitant area to 25 %": {LEAK: None},
    "widest gap to 0.5 mm": {GAP: 0.5},
    "tenting area to 20 mm2": {TENTING: 20.0},
    "regurgitant area, widest gap and tenting area": {LEAK: None, GAP: 0.5, TENTING: 20.0},
    "closed shape (coapt fit)": {"unrepaired_tenting_height_mm": 0.3, TENTING: 5.0, "unrepaired_coaptation_mm": 0.3},
}


def draws_of(path):
    """Columns by name; only of draws that were closed before and after, and are to be trusted."""
    with open(path, encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["trusted"] == "true" and row[LEAK]]
    return {
        name: np.array([float(row[name]) for row in rows])
        for name in rows[0]
        if name not in ("trusted",) and rows[0][name]
    }


def lightest_weight(weights):
    """As of core/metrics/quantile.h."""
    ordered = np.sort(weights)
    light = (np.cumsum(ordered)[:-1] <= 1e-3 * ordered.sum()) & (ordered[:-1] < ordered[1:])
    return ordered[:-1][light].max(initial=0.0)


def quantile(values, weights, share, counted=True):
    """As predicted_quantile() of core/metrics/quantile.h; where it is not `counted` how few the values are, between first and last."""
    order = np.argsort(values)
    values, weights = values[order], weights[order] / weights.sum()
    kept = weights > (lightest_weight(weights) if counted else 0.0)
    values, weights = values[kept], weights[kept] / weights[kept].sum()
    middles = np.cumsum(weights) - 0.5 * weights
    if counted:
        return np.interp(share + (share - 0.5) * (weights**2).sum(), middles, values)
    return np.interp(middles[0] + share * (middles[-1] - middles[0]), middles, values)


def weights_of(draws, figures, truth, share, noise):
    """Of all draws but the truth, whose figures are seen with noise."""
    square = np.zeros(len(draws[LEAK]))
    for name, sd in figures.items():
        sd = sd or max(LEAST_SD_MM2, share * draws[name][truth])
        seen = draws[name][truth] + sd * noise.standard_normal()
        square += ((draws[name] - seen) / sd) ** 2
    square[truth] = np.inf
    weights = np.exp(-0.5 * (square - square.min()))
    return weights / weights.sum()


def observed_draws(draws, share, repeats, noise):
    """Of each draw and each time that it is observed: whether each of both intervals holds it, their widths, effective draws."""
    leak, rows = draws["leak_mm2"], []
    for truth in range(len(leak)):
        for _ in range(repeats):
            weights = weights_of(draws, {LEAK: None}, truth, share, noise)
            row = [1.0 / (weights**2).sum()]
            for counted in (True, False):
                low, high = (quantile(leak, weights, at, counted) for at in (0.05, 0.95))
                row += [low <= leak[truth] <= high, high - low]
            rows.append(row)
    return np.array(rows)


def tell_information(draws, share, repeats, noise):
    leak = draws["leak_mm2"]
    for name, figures in MEASUREMENTS.items():
        left = []
        for truth in range(len(leak)):
            for _ in range(repeats):
                weights = weights_of(draws, figures, truth, share, noise)
                effective = 1.0 / (weights**2).sum()
                left.append((leak[truth] - weights @ leak) ** 2 * effective / (effective + 1.0))
        print(f"{name}: removes {100 * max(0.0, 1.0 - np.mean(left) / leak.var()):.0f} % of the variance")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="+", metavar="draws.csv")
    parser.add_argument("--share", type=float, default=0.25)
    parser.add_argument("--repeats", type=int, default=8, help="observations of each draw")
    parser.add_argument("--information", action="store_true")
    arguments = parser.parse_args()
    noise = np.random.default_rng(1)
    if arguments.information:
        for path in arguments.tables:
            tell_information(draws_of(path), arguments.share, arguments.repeats, noise)
        return
    of_valves = [observed_draws(draws_of(path), arguments.share, arguments.repeats, noise) for path in arguments.tables]
    shares = [100 * rows[:, 1].mean() for rows in of_valves]
    print(f"{len(of_valves)} valves: {min(shares):.0f} to {max(shares):.0f} % of their intervals hold the true leak")
    rows = np.concatenate(of_valves)
    effective = rows[:, 0]
    for name, which in (
        ("all", np.full(len(rows), True)),
        (f"{LEAST_EFFECTIVE:.0f} effective draws or more", effective >= LEAST_EFFECTIVE),
    ):
        if which.any():
            _, held, width, plain, plain_width = rows[which].T
            print(
                f"{name}: {which.sum()} observations, {100 * held.mean():.1f} % of 90 % intervals hold the true leak, median width "
                f"{np.median(width):.1f} mm2 (by plain quantiles {100 * plain.mean():.1f} %, {np.median(plain_width):.1f} mm2), "
                f"median {np.median(effective[which]):.0f} effective draws"
            )


if __name__ == "__main__":
    main()
