#!/usr/bin/python3
"""The Texas TriValve's chordae, their slack unknown, fitted to its closed frame: trivalve_slack.csv, trivalve_chordae.csv.

  trivalve_slack.py DATA OUTPUT [--coapt build/release/bin/coapt] [--rounds 3]

DATA has Healthy_QuasiStatic.inp and Healthy_QuasiStatic_20.vtu; OUTPUT is a folder. The fit starts from trees of chordae only as long as straight
lines from head to insertions in the open valve, as one who saw no chordae would draw them. Groups (leaflet and muscle) are fitted to those closed
nodes that the atrium sees in every other cube of 4 mm; the others, hidden ones too, judge. Needs python3-numpy and python3-vtk9.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "examples" / "scripts"), str(ROOT / "lab" / "closures")]
from closed_import_table import seen_from_the_atrium  # noqa: E402
from table_file import write_table  # noqa: E402
from texas_trivalve import distance_to_surface, read_frame, read_ply  # noqa: E402

CUBE_MM = 4.0
SLACK_SD = 0.2  # of the lengths, as the fit is told: the most that it takes
ONE_MUSCLE_MM = 5.0  # as search/fit/fit_parameters.cpp has it


def muscle_names(heads):
    """Name of each head's muscle: that of its first head."""
    names = [None] * len(heads)
    for first, head in enumerate(heads):
        if names[first]:
            continue
        names[first], queue = head["id"], [first]
        for at in queue:
            for other, candidate in enumerate(heads):
                apart = np.linalg.norm(np.subtract(candidate["rest_mm"], heads[at]["rest_mm"]))
                if not names[other] and apart < ONE_MUSCLE_MM:
                    names[other] = head["id"]
                    queue.append(other)
    return names


def group_names(valve):
    muscles = muscle_names(valve["papillary_heads"])

    def name(chorda):
        face = next(s["insertion"]["face"] for s in chorda["segments"] if "insertion" in s)
        leaflet = valve["leaflets"][valve["face_leaflets"][face]]["name"]
        return f"slack_{leaflet}_{muscles[chorda['head']]}"

    return [name(chorda) for chorda in valve["chordae"]]


def slack(valve, chorda):
    """Length along a tree over the straight distance from its head, mean of its insertions."""
    points, faces, segments = valve["vertices_mm"], valve["faces"], chorda["segments"]
    head, ratios = np.array(valve["papillary_heads"][chorda["head"]]["rest_mm"]), []
    for segment in segments:
        if "insertion" not in segment:
            continue
        face, weights = segment["insertion"]["face"], segment["insertion"]["weights"]
        end = np.array(weights) @ np.array([points[v] for v in faces[face]])
        length, at = segment["rest_length_mm"], segment["parent"]
        while at >= 0:
            length, at = length + segments[at]["rest_length_mm"], segments[at]["parent"]
        ratios.append(length / np.linalg.norm(end - head))
    return sum(ratios) / len(ratios)


def scaled(valve, factors):
    """With the lengths of each chorda times its factor."""
    changed = json.loads(json.dumps(valve))
    for chorda, factor in zip(changed["chordae"], factors):
        for segment in chorda["segments"]:
            segment["rest_length_mm"] *= factor
    return changed


def straightened(valve, groups):
    """The valve to fit from and, by group, the factors that lead back to the known lengths."""
    slacks = [slack(valve, chorda) for chorda in valve["chordae"]]
    back = {name: [s for g, s in zip(groups, slacks) if g == name] for name in sorted(set(groups))}
    return scaled(valve, [1.0 / s for s in slacks]), back


class Judge:
    """Distances of a closed state from Abaqus's, on all nodes, on those that were fitted and on the others."""

    def __init__(self, data, faces):
        self.theirs, quads, leaflet = read_frame(str(data / "Healthy_QuasiStatic_20.vtu"))
        self.theirs = self.theirs[: quads.max() + 1]
        self.triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        self.leaflet = {"anterior": 2, "septal": 3, "posterior": 1}
        self.nodes = {n: np.unique(quads[leaflet == k]) for n, k in self.leaflet.items()}
        seen = np.zeros(len(self.theirs), bool)
        seen[faces[seen_from_the_atrium(self.theirs, faces)]] = True
        even = np.floor(self.theirs / CUBE_MM).astype(int).sum(axis=1) % 2 == 0
        self.fitted = seen & even
        self.held_out_seen = seen & ~even

    def rows(self, label, closed):
        nodes = np.linalg.norm(closed - self.theirs, axis=1)
        surface = distance_to_surface(self.triangles, closed, self.theirs)
        parts = {"all": np.ones(len(nodes), bool), "fitted": self.fitted, "held out": ~self.fitted}
        parts["held out, seen"] = self.held_out_seen
        for name, members in self.nodes.items():
            parts[name] = np.isin(np.arange(len(nodes)), members)
        rms = lambda d: round(float(np.sqrt((d**2).mean())), 3)  # noqa: E731
        return [
            label
            | {"part": part, "nodes": int(of.sum()), "node_rms_mm": rms(nodes[of]), "surface_rms_mm": rms(surface[of])}
            for part, of in parts.items()
        ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    distances, chordae = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def coapt(*arguments):
            command = [str(options.coapt.resolve()), *map(str, arguments)]
            result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
            if result.returncode not in (0, 3, 4):  # 3 and 4: out of rounds, it leaks
                raise SystemExit(f"{command}: {result.stderr}")
            return result.stdout

        def judged(valve, label):
            coapt("close", valve, "--closed", "closed.ply")
            distances.extend(judge.rows(label, read_ply(folder / "closed.ply")))
            print(distances[-7], distances[-5], flush=True)

        coapt("valve", "import", "--abaqus", (options.data / "Healthy_QuasiStatic.inp").resolve(), "-o", "known.json")
        known = json.loads((folder / "known.json").read_text())
        groups, judge = group_names(known), Judge(options.data, np.array(known["faces"]))
        np.savetxt(folder / "seen.csv", judge.theirs[judge.fitted], delimiter=",", fmt="%.5f")
        judged("known.json", {"start": "known", "state": "as measured"})
        start, back = straightened(known, groups)
        (folder / "start.json").write_text(json.dumps(start))
        judged("start.json", {"start": "straight", "state": "before"})
        unknown = ["--known", "tips", "--slack-sd", SLACK_SD, "--rounds", options.rounds, "--seconds", 7200]
        surface = ["--closed", "seen.csv", "--side", "middle"]
        fit = json.loads(coapt("fit", "start.json", *surface, *unknown, "-o", "fitted.json", "--json"))
        judged("fitted.json", {"start": "straight", "state": "fitted"})
        for found in fit["parameters"]:
            factors = back[found["name"]]
            row = {"start": "straight", "group": found["name"], "chordae": len(factors)}
            row |= {"known": round(float(np.mean(factors)), 4), "known_spread": round(float(np.std(factors)), 4)}
            row |= {k: round(found[k], 4) for k in ("value", "sd")} | {"identifiable": int(found["identifiable"])}
            chordae.append(row)
            print(row, flush=True)
        print(fit["closures"], "closures,", fit["rounds"], "rounds", flush=True)
    write_table(options.output / "trivalve_slack.csv", distances)
    write_table(options.output / "trivalve_chordae.csv", chordae)


if __name__ == "__main__":
    main()
