#!/usr/bin/python3
"""Counts how chordae insert in the Texas TriValve, a human tricuspid valve with every chorda digitised.

    lab/anatomy/insertion_fans.py Healthy_QuasiStatic.inp

The Abaqus model is that of github.com/SoftTissueBiomechanicsLab/Texas_TriValve_1.1 (CC BY 4.0; Mathur et al. 2022,
doi 10.1007/s00366-022-01659-w). A fan is all strands from one branch point to the leaflet.
"""

import collections
import sys

import numpy


def read(path):
    """Node positions, leaflet quads and trusses of the file, by their numbers."""
    points, quads, trusses = {}, [], []
    rows = None
    with open(path) as file:
        for line in file:
            if line.startswith("**"):
                continue
            if line.startswith("*"):
                key = line.upper().replace(" ", "")
                rows = (
                    "node"
                    if key.startswith("*NODE,")
                    else "quad"
                    if key.startswith("*ELEMENT,TYPE=S4R")
                    else "truss"
                    if key.startswith("*ELEMENT,TYPE=T3D2")
                    else None
                )
            elif rows and line.strip():
                fields = [float(field) for field in line.split(",") if field.strip()]
                if rows == "node":
                    points[int(fields[0])] = fields[1:4]
                else:
                    (quads if rows == "quad" else trusses).append([int(node) for node in fields[1:]])
    where = numpy.zeros((max(points) + 1, 3))
    for node, point in points.items():
        where[node] = point
    return where, numpy.array(quads), trusses


def node_areas(where, quads):
    """A quarter of each face around a node, mm2."""
    areas = numpy.zeros(len(where))
    for corners in (quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]):
        a, b, c = (where[corners[:, k]] for k in range(3))
        third = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 6
        for k in range(3):
            numpy.add.at(areas, corners[:, k], third)
    return areas


def fans(trusses, leaflet):
    """For each branch point the leaflet nodes where its strands end."""
    beside = collections.defaultdict(list)
    for a, b in trusses:
        beside[a].append(b)
        beside[b].append(a)
    found = collections.defaultdict(set)
    for node in leaflet:
        for strand in beside.get(node, ()):
            before, at = node, strand
            while len(beside[at]) == 2:  # along the strand
                before, at = at, next(n for n in beside[at] if n != before)
            found[at].add(node)
    return [sorted(nodes) for nodes in found.values() if len(nodes) > 2]


def main():
    where, quads, trusses = read(sys.argv[1])
    leaflet = set(quads.ravel().tolist())
    areas = node_areas(where, quads)
    found = fans(trusses, leaflet)
    held = sorted({node for fan in found for node in fan})
    distances = [numpy.linalg.norm(where[fan] - where[fan].mean(axis=0), axis=1) for fan in found]
    rms = [float(numpy.sqrt((d * d).mean())) for d in distances]
    largest = [float(d.max()) for d in distances]
    print(f"fans of three strands and more: {len(found)}")
    for name, values in (
        ("strands", [len(fan) for fan in found]),
        ("rms radius mm", rms),
        ("largest radius mm", largest),
    ):
        low, middle, high = numpy.percentile(values, (10, 50, 90))
        print(f"{name}: median {middle:.2f}, 80 % between {low:.2f} and {high:.2f}")
    print(f"share of the leaflets' area that chordae hold: {areas[held].sum() / areas.sum():.3f}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
