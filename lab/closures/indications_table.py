#!/usr/bin/python3
"""Whether the first plan is one of those that a valve's disease indicates: indications.csv.

  indications_table.py [OUTPUT] [--members 12] [--population-seed 7] [--evaluations 600] [--seed 1] [--coapt build/release/bin/coapt]

Presets, remodelled presets, and members of the population of adults, all of known disease; one that closes all the same counts as competent. A first plan is `indicated` if it has no step for a
competent valve; else a ring, 3 : 4 unless leaflets are tethered, neochordae or a resection on every leaflet that was made to prolapse, and papillary
sutures for tethered leaflets alone; and if it carries no warning of practice that can be avoided.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

from table_file import write_table

PRESETS = (
    ("human-normal", "competent"),
    ("hypertrophic", "competent"),
    ("human-functional-mr", "IIIb"),
    ("secondary-mr", "IIIb"),
    ("human-p2-prolapse", "II"),
    ("fibroelastic-flail", "II"),
    ("barlow", "II"),
    ("marfan", "II"),
)
REMODELLED = (
    ("atrial", "I", "human-normal", ("--ap-dilation", "30", "--annular-height", "50")),
    ("ischaemic", "IIIb", "human-normal", ("--ap-dilation", "20", "--displace-pm", "6,5,6")),
    ("dilated", "IIIb", "human-normal", ("--ap-dilation", "12", "--displace-al", "4,4,5", "--displace-pm", "5,5,6")),
    (
        "flail-dilated",
        "II",
        "human-p2-prolapse",
        (
            "--ap-dilation",
            "18",
        ),
    ),
)
TYPES = {"ischaemic": "IIIb", "dilated": "IIIb", "p2_flail": "II", "barlow": "II"}
AVOIDABLE = (
    "filling",
    "systolic_anterior_motion",
    "ring_stenosis",
    "opening_area",
    "mean_gradient",
    "papillary_movement",
    "undersizing",
    "ring_width",
)
DEGENERATIVE = ("generic-classic",)


def is_indicated(steps, kind):
    kinds = [step["step"] for step in steps]
    if kind == "competent":
        return not steps
    rings = [step.get("shape") for step in steps if step["step"] == "annuloplasty"]
    if kind != "IIIb" and ("papillary_approximation" in kinds or any(ring not in DEGENERATIVE for ring in rings)):
        return False
    if kind == "II" and not {"neochorda", "leaflet_resection"} & set(kinds):
        return False
    return len(rings) == 1 and rings != ["own"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("docs/figures/indications.csv"))
    parser.add_argument("--members", type=int, default=12)
    parser.add_argument("--population-seed", type=int, default=7)
    parser.add_argument("--evaluations", type=int, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    options = parser.parse_args()
    rows = []

    def run(*arguments):
        command = [options.coapt, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        valves = [(preset, kind, preset) for preset, kind in PRESETS]
        for made, kind, preset, changes in REMODELLED:
            run("valve", "remodel", preset, *changes, "-o", folder / f"{made}.json")
            valves.append((made, kind, folder / f"{made}.json"))
        if options.members:
            where = folder / "population"
            run("population", "make", "-n", options.members, "--seed", options.population_seed, "-o", where)
            members = json.loads((where / "population.json").read_text())["members"]
            for member in members:
                file = folder / f"member-{member['index']}.json"
                run("population", "valve", where, member["index"], "-o", file)
                valves.append((f"member-{member['index']}", TYPES[member["aetiology"]], file))
        for valve, kind, file in valves:
            search = ("--evaluations", options.evaluations, "--seed", options.seed, "--plans", 3, "--region-points", 17)
            result = json.loads(run("plan", file, *search, "--json"))
            found = result["diagnosis"]
            if found["competent"]:  # a disease that does not leak
                kind = "competent"
            first = result["plans"][0] if result["plans"] else None
            warnings = (
                [gate["rule"] for gate in first["gates"] if gate["severity"] == "warn" and gate["rule"] in AVOIDABLE]
                if first
                else []
            )
            steps = first["plan"]["steps"] if first else []
            rows.append(
                {
                    "valve": valve,
                    "type": kind,
                    "diagnosed": found["type"] or "competent",
                    "sure": found["type_sure"],
                    "leak_mm2": round(found["leak_mm2"], 1),
                    "first_plan": "; ".join(first["description"]) if steps else "no operation",
                    "of_class": sum(plan["class"] == first["class"] for plan in result["plans"]) if first else 0,
                    "acceptable": round(first["acceptable_probability"], 3) if first else "",
                    "warnings": " ".join(warnings),
                    "indicated": bool(first) and is_indicated(steps, kind) and (not warnings or not steps),
                    "closures": result["closures"],
                }
            )
            print(rows[-1], flush=True)
            write_table(options.output, rows)  # a run that is cut leaves what it has


if __name__ == "__main__":
    main()
