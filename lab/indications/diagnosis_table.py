#!/usr/bin/env python3
"""diagnosis_table.py VALVES [--number 120] [--seed 1] [--unseen] [--coapt build/release/bin/coapt]
    [-o TABLE.csv]

Whether `coapt diagnose` names the type of valves whose lesion is known, because it was made. Each valve of a population, which is written
to the folder VALVES, is diagnosed with its own disease, before it but with an annulus that is 30 % deeper and half as high
(type I), and before it but with the marginal chordae of one segment ruptured (type II; P2, A2, P1, P3, A1 and A3 in turn), each if
it leaks more than 5 mm2. Valves of even number are those that thresholds were chosen on, the others are held out. Printed: types that
were diagnosed by type that was made, and of ruptured valves how often the diagnosis names the segment, and how many others. --unseen:
ruptured chordae are left out of the valves, as where nobody has seen them.
"""

import argparse
import csv
import json
import subprocess
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
LEAKS_MM2 = 5
RUPTURED = ("P2", "A2", "P1", "P3", "A1", "A3")
TYPE_OF = {"ischaemic": "IIIb", "dilated": "IIIb", "barlow": "II", "p2_flail": "II"}
TYPES = ("I", "IIIb", "II", "IIIa")
HALVES = ("chosen on", "held out")


def without_ruptured(path):
    valve = json.loads(path.read_text())
    valve["chordae"] = [chorda for chorda in valve["chordae"] if not chorda.get("ruptured")]
    path.write_text(json.dumps(valve))


def remodelled(run, healthy, name, *disease):
    sick = healthy.with_name(f"{healthy.stem}-{name}.json")
    run("valve", "remodel", healthy, *disease, "-o", sick)
    return sick


def cases_of(run, folder, index, aetiology):
    """Type that was made, segment that was ruptured or none, and file."""
    own, healthy = folder / f"{index}.json", folder / f"{index}-healthy.json"
    run("population", "valve", folder, index, "-o", own)
    run("population", "valve", folder, index, "--healthy", "-o", healthy)
    segment = RUPTURED[index // 2 % len(RUPTURED)]
    wide = remodelled(run, healthy, "wide", "--ap-dilation", 30, "--annular-height", 50)
    return [
        (TYPE_OF[aetiology], None, own),
        ("I", None, wide),
        ("II", segment, remodelled(run, healthy, segment, "--rupture", segment)),
    ]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("valves", type=Path)
    arguments.add_argument("--number", type=int, default=120)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--unseen", action="store_true")
    arguments.add_argument("--coapt", type=Path, default=SOURCE / "build/release/bin/coapt")
    arguments.add_argument("-o", "--output", type=Path)
    arguments = arguments.parse_args()

    def run(*words):
        command = [arguments.coapt, *map(str, words)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    run("population", "make", "-n", arguments.number, "--seed", arguments.seed, "-o", arguments.valves)
    with open(arguments.valves / "members.csv", encoding="utf-8") as file:
        members = [(int(row["index"]), row["aetiology"]) for row in csv.DictReader(file)]

    def judged(member):
        rows = []
        for made, segment, path in cases_of(run, arguments.valves, *member):
            if arguments.unseen:
                without_ruptured(path)
            found = json.loads(run("diagnose", path, "--json"))
            if found["leak_mm2"] <= LEAKS_MM2:
                continue
            named = [s["name"] for s in found["segments"] if s["finding"] in ("prolapse", "flail")]
            rows.append(
                {
                    "index": member[0],
                    "half": HALVES[member[0] % 2],
                    "made": made,
                    "ruptured": segment or "",
                    "leak_mm2": round(found["leak_mm2"], 1),
                    "diagnosed": found["type"],
                    "sure": found["type_sure"],
                    "prolapsing": " ".join(named),
                }
            )
        return rows

    with ThreadPoolExecutor() as pool:
        rows = [row for of_member in pool.map(judged, members) for row in of_member]
    if arguments.output:
        with open(arguments.output, "w", encoding="utf-8", newline="") as file:
            table = csv.DictWriter(file, rows[0])
            table.writeheader()
            table.writerows(rows)
    for half in HALVES:
        of_half = [row for row in rows if row["half"] == half]
        counts = Counter((row["made"], row["diagnosed"]) for row in of_half)
        print(f"{half:<10} {'made':>6}" + "".join(f"{name:>7}" for name in TYPES))
        for made in TYPES[:3]:
            print(f"{'':<10} {made:>6}" + "".join(f"{counts[made, found]:>7}" for found in TYPES))
        right = [row for row in of_half if row["made"] == row["diagnosed"]]
        sure = [row for row in of_half if row["sure"]]
        right_sure = [row for row in sure if row["made"] == row["diagnosed"]]
        ruptured = [row for row in of_half if row["ruptured"]]
        named = [row for row in ruptured if row["ruptured"] in row["prolapsing"].split()]
        print(f"  types {len(right)} of {len(of_half)}; of the sure ones {len(right_sure)} of {len(sure)}")
        others = sum(len(set(row["prolapsing"].split()) - {row["ruptured"]}) for row in ruptured)
        print(f"  ruptured segments {len(named)} of {len(ruptured)}, and {others} others")


if __name__ == "__main__":
    main()
