"""What the tests of coapt plan and coapt evaluate share: small searches, and how their answers compare."""

import contextlib
import sqlite3

VALVE = "human-functional-mr"
BARE = {"fine_levels": 0, "model_draws": 0}  # without what is closed once more at the end


def options(evidence=False, **changes):
    """Command-line options of a search of a few closures: options(plans=1) is "... --plans 1"."""
    values = {"evaluations": 12, "seed": 3, "plans": 2, "region_points": 2} | changes
    words = [word for name, value in values.items() for word in ("--" + name.replace("_", "-"), str(value))]
    return words if evidence else [*words, "--no-evidence"]


def rows(store):
    """All closures, by subject, plan and disturbance; none if there is no table yet."""
    try:
        with contextlib.closing(sqlite3.connect(f"file:{store}?mode=ro", uri=True)) as database:
            return database.execute(
                "SELECT subjects.name, plans.name, disturbance, status, crossing, leak_mm2, "
                "coaptation_mm, distance_max_mm, tension_max_n FROM closures "
                "JOIN subjects ON subjects.number = subject "
                "JOIN plans ON plans.number = plan ORDER BY 1, 2, 3"
            ).fetchall()
    except sqlite3.OperationalError:
        return []


def without_machine(value):
    """`value` without what depends on the machine and on earlier runs."""
    if isinstance(value, dict):
        return {k: without_machine(v) for k, v in value.items() if k not in ("seconds", "threads", "closures_known")}
    if isinstance(value, list):
        return [without_machine(entry) for entry in value]
    return value


def is_acceptable(plan):
    fine = plan["fine"]
    return (
        (fine is None or (fine["status"] == "converged" and not fine["crossing"] and fine["leak_mm2"] < 5.0))
        and plan["status"] == "converged"
        and not plan["crossing"]
        and plan["acceptable_probability"] >= 0.95
    )
