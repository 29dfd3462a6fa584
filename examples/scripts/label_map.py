#!/usr/bin/env python3
"""label_map.py -o FILE.seg.nrrd [--voxel 0.6] [--thickness 1.5] [--bare] [SOURCE]

A label map such as a segmentation of an echo or CT leaves: the anterior leaflet (1), the posterior one (2) and the annulus
(3) of a real valve, drawn as thick as --thickness mm on voxels of --voxel mm in an oblique frame (LPS). SOURCE is a folder
with anterior_leaflet_sheet.obj, posterior_leaflet_sheet.obj and annulus_centerline.csv; left out, that of BodyParts3D in
examples/valves/source. --bare leaves the labels without names and the annulus out. Then, from this to a report:

    coapt valve import FILE.seg.nrrd -o valve.json
    coapt plan valve.json -o report.html
"""

import argparse
import gzip
import sys
from pathlib import Path

import numpy

SOURCE = Path(__file__).resolve().parents[1] / "valves" / "source" / "bodyparts3d"
ANNULUS_RADIUS_MM = 1.2
MARGIN_MM = 6.0
NAMES = ["Anterior leaflet", "Posterior leaflet", "Annulus"]


def read_obj(path):
    vertices, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return numpy.array(vertices), numpy.array(faces)


def points_on(vertices, faces, step):
    """Points of every triangle no further apart than step."""
    corners = vertices[faces]
    longest = numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=1), axis=2).max(axis=1)
    cuts = numpy.ceil(longest / step).astype(int) + 1  # of each triangle's sides
    found = []
    for n in numpy.unique(cuts):
        weights = numpy.array([(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]) / n
        found.append(numpy.einsum("wk,fkx->wfx", weights, corners[cuts == n]).reshape(-1, 3))
    return numpy.concatenate(found)


def loop_points(loop, step):
    following = numpy.roll(loop, -1, axis=0)
    n = int(numpy.ceil(numpy.linalg.norm(following - loop, axis=1).max() / step)) + 1
    return numpy.concatenate([loop + (following - loop) * k / n for k in range(n)])


def oblique_axes():
    """Columns i, j, k: turned by 25 degrees about x, then 35 about z."""
    x, z = numpy.radians([25, 35])
    about_x = [[1, 0, 0], [0, numpy.cos(x), -numpy.sin(x)], [0, numpy.sin(x), numpy.cos(x)]]
    about_z = [[numpy.cos(z), -numpy.sin(z), 0], [numpy.sin(z), numpy.cos(z), 0], [0, 0, 1]]
    return numpy.array(about_z) @ numpy.array(about_x)


def distances(points, origin, axes, size, voxel, reach):
    """Of every voxel's centre from the nearest point, up to reach; beyond it infinite."""
    nearest = numpy.full(size, numpy.inf)
    places = (points - origin) @ axes / voxel
    steps = int(numpy.ceil(reach / voxel)) + 1
    base = numpy.rint(places).astype(int)
    for i in range(-steps, steps + 1):
        for j in range(-steps, steps + 1):
            for k in range(-steps, steps + 1):
                at = base + (i, j, k)
                distance = numpy.linalg.norm(at - places, axis=1) * voxel
                near = distance <= reach
                numpy.minimum.at(nearest, tuple(at[near].T), distance[near])
    return nearest


def write_nrrd(path, labels, origin, axes, voxel, named):
    def vector(numbers):
        return "(" + ",".join(f"{number:.12g}" for number in numbers) + ")"

    header = [
        "NRRD0004",
        "type: unsigned char",
        "dimension: 3",
        "space: left-posterior-superior",
        "sizes: " + " ".join(map(str, labels.shape)),
        "space directions: " + " ".join(vector(voxel * axes[:, k]) for k in range(3)),
        "kinds: domain domain domain",
        "encoding: gzip",
        "space origin: " + vector(origin),
    ]
    if named:
        for i, name in enumerate(NAMES):
            header += [f"Segment{i}_Name:={name}", f"Segment{i}_LabelValue:={i + 1}", f"Segment{i}_Layer:=0"]
    data = gzip.compress(labels.ravel(order="F").tobytes(), mtime=0)
    path.write_bytes(("\n".join(header) + "\n\n").encode() + data)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", nargs="?", type=Path, default=SOURCE)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--voxel", type=float, default=0.6)
    parser.add_argument("--thickness", type=float, default=1.5)
    parser.add_argument("--bare", action="store_true")
    asked = parser.parse_args()
    step = asked.voxel / 2
    sheets = [
        points_on(*read_obj(asked.source / f"{side}_leaflet_sheet.obj"), step) for side in ("anterior", "posterior")
    ]
    loop = numpy.loadtxt(asked.source / "annulus_centerline.csv", delimiter=",", comments="#", usecols=(0, 1, 2))
    ring = loop_points(loop, step)
    axes = oblique_axes()
    inside = numpy.concatenate([*sheets, ring]) @ axes
    low, high = inside.min(axis=0) - MARGIN_MM, inside.max(axis=0) + MARGIN_MM
    size = tuple(int(n) for n in numpy.ceil((high - low) / asked.voxel))
    origin = axes @ low
    reaches = [asked.thickness / 2, asked.thickness / 2, ANNULUS_RADIUS_MM]
    found = [distances(p, origin, axes, size, asked.voxel, r) for p, r in zip([*sheets, ring], reaches)]
    labels = numpy.zeros(size, numpy.uint8)
    leaflets = numpy.minimum(found[0], found[1])
    if not asked.bare:
        labels[numpy.isfinite(found[2])] = 3
    labels[numpy.isfinite(leaflets)] = numpy.where(found[0] <= found[1], 1, 2)[numpy.isfinite(leaflets)]
    write_nrrd(asked.output, labels, origin, axes, asked.voxel, not asked.bare)
    counts = [int((labels == value).sum()) for value in (1, 2, 3)]
    print(
        f"{asked.output}: {' x '.join(map(str, size))} voxels of {asked.voxel} mm; labels 1 to 3 have {counts}",
        file=sys.stderr,
    )


if __name__ == "__main__":
    main()
