#!/usr/bin/python3
"""Where and how densely the chordae of the Texas TriValve insert: shares of the leaflets, distances from the free edge,
radii of fans. A fan is the set of trusses that reach the leaflet from one branch point.

  count_insertions.py Healthy_QuasiStatic.inp

Needs python3-numpy and python3-scipy (Debian). Distances are those along edges and diagonals of the mesh.
"""

import sys
from collections import Counter, defaultdict

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

PERCENTILES = [10, 25, 50, 75, 90, 100]


def read(path):
    nodes, shells, trusses, sets, prescribed = {}, [], [], defaultdict(list), set()
    keyword, options = "", {}
    for line in open(path, encoding="ascii"):
        line = line.strip()
        if line.startswith("**") or not line:
            continue
        if line.startswith("*"):
            parts = [part.strip().upper() for part in line[1:].split(",")]
            keyword, options = parts[0], dict(part.split("=") for part in parts[1:] if part.count("=") == 1)
            continue
        values = [value.strip() for value in line.split(",") if value.strip()]
        if keyword == "NODE":
            nodes[int(values[0])] = [float(value) for value in values[1:4]]
        elif keyword == "ELEMENT":
            (trusses if options["TYPE"] == "T3D2" else shells).append([int(value) for value in values[1:]])
        elif keyword == "NSET":
            sets[options["NSET"]] += [int(value) for value in values]
        elif keyword == "BOUNDARY":
            prescribed.add(int(values[0].split(".")[1]))
    points = np.zeros((max(nodes) + 1, 3))
    for number, place in nodes.items():
        points[number] = place
    return points, shells, trusses, set(sets["FREE_EDGE_NODES"]), set(sets["ANNULAR_NODES"]), prescribed


def strands(trusses, shell_nodes, heads):
    """(head, branch point, leaflet node) of each truss that ends in a leaflet."""
    around = defaultdict(list)
    for a, b in trusses:
        around[a].append(b)
        around[b].append(a)
    parent, found = {head: None for head in heads}, []
    for head in heads:
        open_nodes = [head]
        while open_nodes:
            node = open_nodes.pop()
            for other in around[node]:
                if other in shell_nodes:
                    branch = node
                    while parent[branch] is not None and len(around[branch]) == 2:
                        branch = parent[branch]
                    found.append((head, branch, other))
                elif other != parent[node]:
                    parent[other] = node
                    open_nodes.append(other)
    return found


def main(path):
    points, shells, trusses, free_edge, annulus, prescribed = read(path)
    shell_nodes = {node for shell in shells for node in shell}
    found = strands(trusses, shell_nodes, sorted(prescribed - annulus))
    area = np.zeros(len(points))
    pairs = set()
    for shell in shells:
        a, b, c, d = points[shell]
        whole = 0.5 * (np.linalg.norm(np.cross(b - a, c - a)) + np.linalg.norm(np.cross(c - a, d - a)))
        area[shell] += whole / 4
        pairs |= {(shell[i], shell[j]) for i in range(4) for j in range(i)}
    pairs = np.array(sorted(pairs))
    lengths = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    graph = csr_matrix((lengths, pairs.T), (len(points),) * 2)
    from_edge = dijkstra(graph, directed=False, indices=sorted(free_edge), min_only=True)
    held = sorted({node for _, _, node in found})
    print(
        f"{len(found)} insertions on {len(held)} of {len(shell_nodes)} nodes: {len(held) / len(shell_nodes):.1%} of the "
        f"nodes, {area[held].sum() / area.sum():.1%} of the area; {Counter(Counter(n for *_, n in found).values())}"
    )
    distances = [from_edge[node] for *_, node in found]
    print("distance from the free edge, mm:", dict(zip(PERCENTILES, np.percentile(distances, PERCENTILES).round(2))))
    for low, high in ((0, 1), (1, 2), (2, 4), (4, 6), (6, 20)):
        band = [n for n in shell_nodes if low <= from_edge[n] < high]
        print(
            f"  {low} to {high} mm: {area[list(set(band) & set(held))].sum() / area[band].sum():.0%} of the area held"
        )
    fans, trees = defaultdict(list), defaultdict(set)
    for head, branch, node in found:
        fans[branch].append(node)
        trees[head].add(branch)
    print(f"{len(fans)} fans in {len(trees)} trees: {sorted(len(t) for t in trees.values())}")
    single = {next(iter(branches)) for branches in trees.values() if len(branches) == 1}
    for name, chosen in (("trees of one fan", single), ("large trees", set(fans) - single)):
        places = [points[fans[branch]] for branch in sorted(chosen)]
        radii = [np.linalg.norm(place - place.mean(0), axis=1) for place in places]
        for what, values in (
            ("strands", [len(r) for r in radii]),
            ("rms radius, mm", [np.sqrt((r**2).mean()) for r in radii]),
            ("largest radius, mm", [r.max() for r in radii]),
        ):
            print(f"  {name}, {what}:", dict(zip(PERCENTILES, np.percentile(values, PERCENTILES).round(2))))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
