"""How unique the closed state is, over the leaflets' rigidity: uniqueness.csv."""

import statistics

from style import BLUE, GREEN, VERMILION, each_once, figure_titled

ELSEWHERE_MM = 0.05  # rms distance from which on two ends are different equilibria (closure_study.h)
KINDS = {"known": BLUE, "new": GREEN, "anatomies": VERMILION}
NAMES = {"known": "presets, seed looked at", "new": "presets, another seed", "anatomies": "random anatomies"}


def quantile(values, share):
    """As coapt's: linear between order statistics."""
    values = sorted(values)
    position = share * (len(values) - 1)
    below = int(position)
    return values[below] + (position - below) * (values[min(below + 1, len(values) - 1)] - values[below])


def summary(rows):
    """Of scenes of one kind and rigidity."""
    compared = [row for row in rows if row["compared"] == "true"]
    leaks = [abs(float(row["leak_difference_mm2"])) for row in compared] or [0.0]
    return {
        "scenes": len(rows),
        "compared": len(compared),
        "elsewhere": sum(float(row["rms_mm"]) > ELSEWHERE_MM for row in compared),
        "leak_p90_mm2": quantile(leaks, 0.9),
        "leak_max_mm2": max(leaks),
        "second_attempts": sum(int(row["attempts"]) > 1 for row in rows),
        "median_steps": statistics.median(int(row["steps"]) for row in rows),
    }


def draw_uniqueness(rows):
    rigidities = sorted(each_once(float(row["bending_n_mm"]) for row in rows))
    kinds = [kind for kind in KINDS if any(row["kind"] == kind for row in rows)]
    figure, (share, leak, attempts, steps) = figure_titled(
        "Closed at full and at half the speed, at growing resistance to bending", 15, 3.6, ncols=4
    )
    places = range(len(rigidities))
    for kind in kinds:
        at = [
            summary([row for row in rows if row["kind"] == kind and float(row["bending_n_mm"]) == rigidity])
            for rigidity in rigidities
        ]
        look = {"color": KINDS[kind], "label": NAMES[kind]}
        share.plot(places, [100 * s["elsewhere"] / max(1, s["compared"]) for s in at], "o-", **look)
        leak.plot(places, [s["leak_max_mm2"] for s in at], "o:", color=KINDS[kind])
        leak.plot(places, [s["leak_p90_mm2"] for s in at], "o-", **look)
        attempts.plot(places, [100 * s["second_attempts"] / s["scenes"] for s in at], "o-", **look)
        steps.plot(places, [s["median_steps"] for s in at], "o-", **look)
    share.set_title("ends elsewhere, % of the scenes", loc="left")
    leak.set_title("leaks apart, mm² (90 %, largest)", loc="left")
    attempts.set_title("second attempts, % of the scenes", loc="left")
    steps.set_title("steps, median", loc="left")
    for axis in (share, leak, attempts, steps):
        axis.set_xticks(places, labels=[f"{rigidity:g}" for rigidity in rigidities])
        axis.set_xlabel("flexural rigidity, N mm (default 0.03)")
        axis.set_ylim(bottom=0)
    share.legend()
    return figure
