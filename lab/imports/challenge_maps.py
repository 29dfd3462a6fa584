#!/usr/bin/env python3
"""challenge_maps.py VALVES -o MAPS [--share 0.1] [--per-valve 1] [--half tuned|held-out]

Label maps of known valves, on which imports are judged (judge_imports.py): each valve of the folder VALVES (coapt.valve/1, made by
`coapt population valve`) as a segmentation of TEE would have it, in an oblique frame of its own, in half of the maps as hearts lie in a
patient, in half as in the axes of a probe; with rough surfaces, on voxels of 0.5, 0.75 or 1 mm; its labels numbered by one of four conventions; a share of the maps damaged in one of twenty ways, in turn.
Maps of the same options are the same. truth.json says of each what it shows. Valves of even number are tuned on, the others held out.

    coapt population make -n 100 -o adults
    for i in $(seq 0 99); do coapt population valve adults $i -o valves/$i.json; done
    lab/imports/challenge_maps.py valves/ -o maps/ --per-valve 12
    coapt study imports maps/ -o study/
    lab/imports/judge_imports.py maps/ study/
"""

import argparse
import gzip
import json
import struct
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples" / "scripts"))
from label_map import distances, loop_points, points_on  # noqa: E402

VOXELS_MM = (0.5, 0.75, 1.0)
THICKNESS_MM = 1.6  # as segmented: tissue and the blur of the image
ANNULUS_RADIUS_MM = 1.2
MARGIN_MM = 9.0
SPREAD_DEG = 20.0  # of hearts in patients, root mean square; assumed
ROUGHNESS = 0.35  # of a voxel, by which surfaces are moved
ANTERIOR, POSTERIOR, ANNULUS = 1, 2, 3
CONVENTIONS = ("coapt", "mvseg", "slicer", "nifti")
NUMBERS = {"coapt": (1, 2, 3), "mvseg": (2, 1, None), "slicer": (2, 3, 1), "nifti": (21, 20, 22)}
NAMES = ("Mitral anterior leaflet", "Mitral posterior leaflet", "Mitral annulus")
DAMAGES = (
    "names-exchanged one-leaflet merged third-leaflet annulus-open scaled stretched mirrored centimetres cropped hole islands thick "
    "intensities contradiction truncated annulus-moved annulus-twice chamber empty"
).split()


def turned(random):
    """A rotation, columns i, j, k."""
    q, r = numpy.linalg.qr(random.normal(size=(3, 3)))
    q *= numpy.sign(numpy.diag(r))
    return q if numpy.linalg.det(q) > 0 else q[:, [1, 0, 2]]


def as_in_a_patient(random):
    """Columns x, y, z of a valve in LPS: the apex to the left, in front and below, the aortic root to the right; hearts differ."""
    z = numpy.array([-0.65, 0.5, 0.55]) / numpy.linalg.norm([-0.65, 0.5, 0.55])
    x = numpy.cross([-0.6, -0.7, 0.0], z)
    x /= numpy.linalg.norm(x)
    by = random.normal(scale=numpy.radians(SPREAD_DEG / numpy.sqrt(3)), size=3)
    angle, cross = numpy.linalg.norm(by), numpy.array([[0, -by[2], by[1]], [by[2], 0, -by[0]], [-by[1], by[0], 0]])
    turn = numpy.eye(3) + numpy.sin(angle) / angle * cross + (1 - numpy.cos(angle)) / angle**2 * cross @ cross
    return turn @ numpy.column_stack([x, numpy.cross(z, x), z])


def blurred_noise(random, size):
    noise = random.normal(size=size)
    for axis in range(3):
        noise = (noise + numpy.roll(noise, 1, axis) + numpy.roll(noise, -1, axis)) / 3
    return noise / noise.std()


def read_valve(path):
    valve = json.loads(path.read_text())
    vertices = numpy.array(valve["vertices_mm"])
    faces = numpy.array(valve["faces"])
    marks = valve["landmarks"]
    lateral, medial = (vertices[marks[f"{side}_commissure"]] for side in ("anterolateral", "posteromedial"))
    middles = vertices[faces].mean(axis=1) - lateral
    along = medial - lateral
    front = along[0] * middles[:, 1] - along[1] * middles[:, 0] > 0  # of the commissures' line
    segments = numpy.array(valve["segments"])
    anterior = numpy.where(numpy.char.endswith(segments, "C"), front, numpy.char.startswith(segments, "A"))
    annulus = vertices[valve["annulus"]["vertices"]]
    return vertices, faces, anterior, annulus


class Map:
    """Labels on voxels, and where they are."""

    def __init__(self, path, voxel, random):
        self.random, self.voxel = random, voxel
        vertices, faces, anterior, loop = read_valve(path)
        self.lies = "patient" if random.random() < 0.5 else "probe"
        self.axes = as_in_a_patient(random) if self.lies == "patient" else turned(random)
        self.shift = random.normal(scale=40.0, size=3)
        step = 0.7 * voxel
        place = lambda points: points @ self.axes.T + self.shift  # noqa: E731
        self.place = place
        self.frame = turned(random)
        sheets = [place(points_on(vertices, faces[side], step)) for side in (anterior, ~anterior)]
        self.ring = place(loop_points(loop, step))
        self.valve_up = self.axes[:, 2]
        inside = numpy.concatenate([*sheets, self.ring]) @ self.frame
        low, high = inside.min(axis=0) - MARGIN_MM, inside.max(axis=0) + MARGIN_MM
        self.size = tuple(int(n) for n in numpy.ceil((high - low) / voxel))
        self.origin = self.frame @ low
        self.sheets = sheets
        self.edges = numpy.full(3, voxel)
        self.labels = numpy.zeros(self.size, numpy.uint8)

    def near(self, points, reach):
        return distances(points, self.origin, self.frame, self.size, self.voxel, reach)

    def draw(self):
        half = max(THICKNESS_MM / 2, self.voxel)
        rough = ROUGHNESS * self.voxel * blurred_noise(self.random, self.size)
        rough = numpy.minimum(rough, half - 0.87 * self.voxel)  # no segmentation has holes in every leaflet
        found = [self.near(sheet, half + self.voxel) + rough for sheet in self.sheets]
        ring = self.near(self.ring, max(ANNULUS_RADIUS_MM, 0.9 * self.voxel))
        leaflet = numpy.minimum(*found) <= half
        self.labels[:] = 0
        self.labels[numpy.isfinite(ring)] = ANNULUS
        self.labels[leaflet] = numpy.where(found[0] <= found[1], ANTERIOR, POSTERIOR)[leaflet]

    def centres(self):
        grid = numpy.stack(numpy.meshgrid(*map(numpy.arange, self.size), indexing="ij"), axis=-1)
        return self.origin + (grid * self.voxel) @ self.frame.T

    def ball(self, centre, radius):
        return numpy.linalg.norm(self.centres() - centre, axis=-1) <= radius


def damage(made, kind):
    """Changes the map; what is left to its file is returned."""
    labels, centres = made.labels, made.centres()
    own = (centres - made.shift) @ made.axes  # in the valve's frame
    angle = numpy.degrees(numpy.arctan2(own[..., 1], own[..., 0])) % 360  # 90: anterior
    if kind == "one-leaflet":
        labels[labels == ANTERIOR] = 0
    elif kind == "merged":
        labels[labels == POSTERIOR] = ANTERIOR
    elif kind == "third-leaflet":
        labels[(labels == POSTERIOR) & (own[..., 0] > 0)] = 4
    elif kind == "annulus-open":
        labels[(labels == ANNULUS) & (angle > 200) & (angle < 320)] = 0
    elif kind == "scaled":
        made.edges = made.edges * 2.2
    elif kind == "stretched":
        made.edges = made.edges * (1.0, 1.0, 1.7)
    elif kind == "mirrored":
        labels[:] = labels[::-1].copy()
    elif kind == "centimetres":
        made.edges = made.edges / 10
    elif kind == "cropped":
        labels[own[..., 1] < 0.5 * own[..., 1][labels > 0].min()] = 0
    elif kind == "hole":
        middle = made.sheets[0].mean(axis=0)
        at = made.sheets[0][numpy.linalg.norm(made.sheets[0] - middle, axis=1).argmin()]
        labels[made.ball(at, 4.5) & (labels == ANTERIOR)] = 0
    elif kind == "islands":
        for _ in range(12):
            at = made.shift + made.random.normal(scale=14.0, size=3)
            labels[made.ball(at, made.random.uniform(1.0, 2.0)) & (labels == 0)] = ANTERIOR
    elif kind == "thick":
        for _ in range(round(2.0 / made.voxel)):
            grown = labels.copy()
            for axis in range(3):
                for way in (-1, 1):
                    beside = numpy.roll(labels, way, axis)
                    grown[(grown == 0) & (beside > 0) & (beside < ANNULUS)] = beside[
                        (grown == 0) & (beside > 0) & (beside < ANNULUS)
                    ]
            labels[:] = grown
    elif kind == "annulus-moved":
        labels[labels == ANNULUS] = 0
        ring = made.near(made.ring + 8.0 * made.valve_up, ANNULUS_RADIUS_MM)
        labels[numpy.isfinite(ring) & (labels == 0)] = ANNULUS
    elif kind == "annulus-twice":
        ring = made.near(made.ring + 7.0 * made.valve_up, ANNULUS_RADIUS_MM)
        labels[numpy.isfinite(ring) & (labels == 0)] = ANNULUS
    elif kind == "chamber":
        above = (numpy.linalg.norm(own - (0, 0, 12), axis=-1) < 9) & (labels == 0)
        labels[above] = 4
    elif kind == "empty":
        labels[:] = 0


def vector(numbers):
    return "(" + ",".join(f"{number:.12g}" for number in numbers) + ")"


def write_nrrd(path, made, labels, names, kind):
    header = [
        "NRRD0004",
        "type: " + ("float" if labels.dtype == numpy.float32 else "unsigned char"),
        "dimension: 3",
        "space: left-posterior-superior",
        "sizes: " + " ".join(map(str, labels.shape)),
        "space directions: " + " ".join(vector(made.edges[k] * made.frame[:, k]) for k in range(3)),
        "kinds: domain domain domain",
        "endian: little",
        "encoding: gzip",
        "space origin: " + vector(made.origin),
    ]
    for i, (value, name) in enumerate(names):
        header += [f"Segment{i}_Name:={name}", f"Segment{i}_LabelValue:={value}", f"Segment{i}_Layer:=0"]
    data = gzip.compress(labels.ravel(order="F").tobytes(), mtime=0)
    if kind == "truncated":
        data = data[: len(data) // 2]
    path.write_bytes(("\n".join(header) + "\n\n").encode() + data)


def write_nifti(path, made, labels, kind):
    rows = numpy.column_stack([made.frame * made.edges, made.origin])
    rows[:2] *= -1
    if kind == "contradiction":
        rows[:, :3] *= 1.7
    real = labels.dtype == numpy.float32
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, *labels.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 16 if real else 2, 32 if real else 8)
    struct.pack_into("<4f", head, 76, 1, *made.edges)
    struct.pack_into("<f", head, 108, 352)
    head[123] = 2
    struct.pack_into("<h", head, 254, 1)
    struct.pack_into("<12f", head, 280, *rows.ravel())
    head[344:348] = b"n+1\0"
    data = gzip.compress(bytes(head) + labels.ravel(order="F").tobytes(), mtime=0)
    if kind == "truncated":
        data = data[: len(data) // 2]
    path.write_bytes(data)


def write(path, made, convention, kind):
    numbers = NUMBERS[convention]
    if kind in ("annulus-open", "annulus-moved", "annulus-twice") and numbers[2] is None:
        numbers = (2, 1, 3)
    labels = numpy.zeros(made.size, numpy.uint8)
    for part, number in zip((ANTERIOR, POSTERIOR, ANNULUS), numbers):
        if number is not None:
            labels[made.labels == part] = number
    labels[made.labels == 4] = 4
    if kind == "intensities":
        labels = (labels * 37.3 + made.random.uniform(0, 9, made.size)).astype(numpy.float32)
    if convention == "nifti":
        return write_nifti(path, made, labels, kind)
    called = (NAMES[1], NAMES[0], NAMES[2]) if kind == "names-exchanged" else NAMES
    names = list(zip(numbers, called)) if convention == "slicer" else []
    write_nrrd(path, made, labels, names, kind)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("valves", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--share", type=float, default=0.1, help="of the maps that are damaged")
    parser.add_argument("--per-valve", type=int, default=1, help="1 to 12: resolutions by conventions")
    parser.add_argument("--half", choices=["tuned", "held-out"], help="only valves of even or of odd number")
    asked = parser.parse_args()
    asked.output.mkdir(parents=True, exist_ok=True)
    truth, damaged = {}, 0
    paths = sorted(asked.valves.glob("*.json"), key=lambda path: (len(path.stem), path.stem))
    for i, path in enumerate(paths):
        if asked.half and (i % 2 == 0) != (asked.half == "tuned"):
            continue
        for j in range(asked.per_valve):
            turn = (i // 2 + j) % 12
            voxel, convention = VOXELS_MM[turn % 3], CONVENTIONS[turn // 3]
            count = len(truth) + 1
            kind = None
            if round(count * asked.share) > damaged:
                kind = DAMAGES[damaged % len(DAMAGES)]
                damaged += 1
            convention = {"contradiction": "nifti", "names-exchanged": "slicer"}.get(kind, convention)
            file = asked.output / f"{i:03d}-{j:02d}.{'nii.gz' if convention == 'nifti' else 'nrrd'}"
            of = {"valve": str(path), "voxel_mm": voxel, "convention": convention, "damage": kind}
            made = Map(path, voxel, numpy.random.default_rng([i, j]))
            truth[file.name] = of | {"axes": made.lies}
            (asked.output / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")
            if file.exists():  # of a run that was stopped
                continue
            made.draw()
            if kind:
                damage(made, kind)
            write(file, made, convention, kind)
    print(f"{len(truth)} maps, {damaged} damaged", file=sys.stderr)


if __name__ == "__main__":
    main()
