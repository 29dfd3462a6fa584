#!/usr/bin/env python3
"""judge_imports.py MAPS STUDY [-o TABLE.csv]

Sets what `coapt study imports` made of the maps of challenge_maps.py beside the valves that they were drawn from. A valve is right if
its annulus and leaflets have the sizes of the true one, within 12 % of lengths and 25 % of areas, the same leaflet holds
the front, and they hang to the ventricle. Printed: wrong valves that passed with nothing to look at (to be none), right maps that
were refused (to be below 2 %), and both by kind of damage. Of a map that is mirrored no valve is right.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from challenge_maps import read_valve  # noqa: E402

LENGTHS, AREAS, SHARE = 0.12, 0.25, 0.1


def area(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2


def measures(path):
    vertices, faces, anterior, loop = read_valve(path)
    closed = numpy.roll(loop, -1, axis=0)
    level = loop[:, 2].mean()
    front = set(faces[anterior].ravel())
    ring = json.loads(Path(path).read_text())["annulus"]["vertices"]
    return {
        "circumference": numpy.linalg.norm(closed - loop, axis=1).sum(),
        "anteroposterior": numpy.ptp(loop[:, 1]),
        "transverse": numpy.ptp(loop[:, 0]),
        "anterior area": area(vertices, faces[anterior]),
        "posterior area": area(vertices, faces[~anterior]),
        "anterior share": sum(vertex in front for vertex in ring) / len(ring),
        "hanging": level - vertices[faces].mean(axis=(0, 1))[2],
    }


def wrong(truth, made):
    """What is wrong with a valve, in words."""
    off = []
    for name, value in truth.items():
        ratio = made[name] / value
        if name == "hanging":
            if made[name] < 0.0:
                off.append("upside down")
        elif name == "anterior share":
            if abs(made[name] - value) > SHARE:
                off.append(f"{name} {made[name]:.2f} for {value:.2f}")
        elif abs(ratio - 1) > (AREAS if name.endswith("area") else LENGTHS):
            off.append(f"{name} {ratio:.2f} times")
    return ", ".join(off)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("maps", type=Path)
    parser.add_argument("study", type=Path)
    parser.add_argument("-o", "--output", type=Path, help="a line for each map (CSV)")
    asked = parser.parse_args()
    truth = json.loads((asked.maps / "truth.json").read_text())
    rows = {row["name"]: row for row in json.loads((asked.study / "imports.json").read_text())["imports"]}
    lines, counts = [], {}
    for name, of in truth.items():
        if name not in rows:
            continue
        row, kind = rows[name], of["damage"] or "sound"
        if row["stage"] == "refused":
            verdict, why = "refused", row["reason"]
        else:
            looks = row["looks"]
            off = "mirrored" if kind == "mirrored" else ""
            off = off or wrong(measures(Path(of["valve"])), measures(asked.study / row["valve"]))
            verdict = ("wrong" if off else "right") + (", said" if looks else "")
            why = off or (looks[0] if looks else "")
        counts.setdefault(kind, {}).setdefault(verdict, []).append(name)
        lines.append((name, of["voxel_mm"], of["convention"], of["axes"], kind, verdict, row["stage"], why))
    of_verdict = lambda which: [line for line in lines if which(line)]  # noqa: E731
    sound = of_verdict(lambda line: line[4] == "sound")
    refused = [line for line in sound if line[5] == "refused"]
    silent = of_verdict(lambda line: line[5] == "wrong")
    print(f"{len(lines)} maps, {len(sound)} of them sound")
    print(f"wrong valves that passed silently: {len(silent)} of {len(lines)}")
    print(f"refused though right: {len(refused)} of {len(sound)}")
    unlooked = [line for line in sound if line[5] == "right"]
    print(f"sound maps that gave the right valve with nothing to look at: {len(unlooked)} of {len(sound)}")
    for lies in ("patient", "probe"):
        count = sum(line[3] == lies for line in sound)
        print(f"  of those in the axes of a {lies}: {sum(line[3] == lies for line in unlooked)} of {count}")
    for kind, verdicts in sorted(counts.items()):
        print(f"  {kind}: " + ", ".join(f"{len(names)} {verdict}" for verdict, names in sorted(verdicts.items())))
    for line in silent + refused:
        print("  " + "; ".join(map(str, line)))
    if asked.output:
        table = ["map,voxel_mm,convention,axes,damage,verdict,stage,why"]
        table += [",".join([*map(str, line[:-1]), '"' + line[-1].replace('"', '""') + '"']) for line in lines]
        asked.output.write_text("\n".join(table) + "\n")


if __name__ == "__main__":
    main()
