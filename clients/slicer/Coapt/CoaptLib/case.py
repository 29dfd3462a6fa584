"""A patient's valve from the segmentation to plans, as steps for a service.Task. Standard library and numpy; no Slicer.

Frames, all in mm: Slicer's nodes have coordinates in RAS below their transform ("local": of SlicerHeart the probe's axes, below its
ProbeToRAS), which leads to the world's RAS. What goes to coapt is in the world's LPS, so that lengths and axes are the patient's;
what comes back goes below the same transform, and follows it like the echo.
"""

import base64
import gzip
import re
from dataclasses import dataclass, field

import numpy

from .service import Cancelled, Refused, Trouble, followed

FLIP = numpy.diag([-1.0, -1.0, 1.0, 1.0])  # RAS to LPS, and back
MARGIN_MM = 15.0  # of the map about its segments: closed leaflets and what a repair adds lie in it
FRAMES = 24  # of a closing
PARTS = ("anterior", "posterior", "annulus")
VALVE_MASK = "ValveMask"  # id of a segment in which SlicerHeart has no leaflet
_LEAFLET = re.compile(r"\bsh-leaflet-([a-z]+)-([a-z]+)\b")  # in SlicerHeart's terminology
_ENTRY = (
    "SlicerHeart segmentation category and type~SCT^91134007^Mitral Valve~SlicerHeart^sh-leaflet-mv-{0[0]}^mitral {0} "
    "leaflet~^^~Anatomic codes - DICOM master list~^^~^^"
)


def moved(points, matrix):
    """Points, N x 3, by a 4 x 4 matrix."""
    return numpy.asarray(points, float).reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


@dataclass
class Segment:
    name: str
    mask: numpy.ndarray  # K x J x I, as Slicer has arrays; not 0 is inside
    entry: str = ""  # of its terminology
    id: str = ""

    def part(self):
        """By SlicerHeart's terminology, None where it does not say.

        :raises Trouble: it is a leaflet of another valve
        """
        found = _LEAFLET.search(self.entry)
        if found is None:
            return None
        if found[1] != "mv":
            raise Trouble(
                f'Segment "{self.name}" is a leaflet of another valve (SlicerHeart\'s {found[0]}); coapt plans for mitral valves.'
            )
        return {"a": "anterior", "p": "posterior"}.get(found[2])


@dataclass
class Segmentation:
    """Segments on one grid. ijk_to_local: 4 x 4, RAS; to_world: of its transform."""

    segments: list
    ijk_to_local: numpy.ndarray
    to_world: numpy.ndarray = field(default_factory=lambda: numpy.eye(4))

    def cropped(self):
        """The map that is sent: segments that hold something, on voxels of the same places, and MARGIN_MM about them.

        :raises Trouble: nothing can be sent
        """
        kept = [one for one in self.segments if one.id != VALVE_MASK and one.mask.any()]
        if all(
            part in [one.part() for one in kept] for part in PARTS[:2]
        ):  # then others are known to be something else
            kept = [one for one in kept if one.part() or "annul" in one.name.lower()]
        if not kept:
            raise Trouble("The segmentation is empty: draw the anterior and the posterior leaflet as segments.")
        inside = numpy.any([one.mask != 0 for one in kept], axis=0)
        corners = [
            (found.min(), found.max() + 1) for found in (numpy.flatnonzero(inside.any(axis=rest)) for rest in _RESTS)
        ]
        steps_mm = numpy.linalg.norm((self.to_world @ self.ijk_to_local)[:3, :3], axis=0)  # along i, j, k
        margins = numpy.ceil(MARGIN_MM / steps_mm - 1e-6).astype(int)  # the same on every machine
        low = numpy.array([corner[0] for corner in corners[::-1]]) - margins  # i, j, k
        size = numpy.array([corner[1] for corner in corners[::-1]]) + margins - low
        shift = numpy.eye(4)
        shift[:3, 3] = low
        of_old = tuple(slice(*corner) for corner in corners)
        of_new = tuple(slice(m, m + c[1] - c[0]) for m, c in zip(margins[::-1], corners))
        layers, numbers = [], []
        for number, segment in enumerate(kept, 1):
            mask = numpy.zeros(tuple(size[::-1]), bool)
            mask[of_new] = segment.mask[of_old] != 0
            layer = next((i for i, one in enumerate(layers) if not one[mask].any()), len(layers))
            if layer == len(layers):
                layers.append(numpy.zeros(mask.shape, numpy.uint8))
            layers[layer][mask] = number
            numbers.append((number, layer, segment))
        return Map(layers, numbers, self.ijk_to_local @ shift, self.to_world)


_RESTS = ((1, 2), (0, 2), (0, 1))  # axes besides k, j, i


@dataclass
class Map:
    """A label map as it goes to coapt. numbers: (label, layer, segment)."""

    layers: list
    numbers: list
    ijk_to_local: numpy.ndarray
    to_world: numpy.ndarray

    def to_lps(self):
        return FLIP @ self.to_world @ self.ijk_to_local

    def grid(self):
        """As exports take it."""
        return {"size": list(self.layers[0].shape[::-1]), "to_lps_mm": self.to_lps()[:3].tolist()}

    def nrrd(self):
        """As Slicer writes segmentations; layers where segments overlap."""
        several = len(self.layers) > 1
        sizes = [*self.layers[0].shape[::-1], *([len(self.layers)] if several else [])]
        header = [
            "NRRD0004",
            "type: unsigned char",
            f"dimension: {len(sizes)}",
            "space: left-posterior-superior",
            "sizes: " + " ".join(map(str, sizes)),
            *_directions(self.to_lps(), " none" if several else ""),
            "kinds: domain domain domain" + (" list" if several else ""),
            "encoding: gzip",
        ]
        for i, (number, layer, segment) in enumerate(self.numbers):
            name = " ".join(segment.name.split()) or f"Segment {number}"
            header += [f"Segment{i}_Name:={name}", f"Segment{i}_LabelValue:={number}", f"Segment{i}_Layer:={layer}"]
        voxels = gzip.compress(b"".join(layer.tobytes() for layer in self.layers), 6, mtime=0)
        return "\n".join([*header, "", ""]).encode() + voxels

    def placed(self, nrrd):
        """A label map that coapt drew on this grid, below the transform of the segmentation; its leaflets in SlicerHeart's terms."""
        head, voxels = nrrd.split(b"\n\n", 1)
        lines = [
            line for line in head.decode().split("\n") if not line.startswith(("space directions:", "space origin:"))
        ]
        lines[4:4] = _directions(FLIP @ self.ijk_to_local)
        lines += [f"Segment{i}_Tags:=TerminologyEntry:{_ENTRY.format(part)}|" for i, part in enumerate(PARTS[:2])]
        return "\n".join([*lines, "", ""]).encode() + voxels


def _directions(to_lps, rest=""):
    vectors = ["(" + ",".join(f"{number:.12g}" for number in to_lps[:3, k]) + ")" for k in range(4)]
    return ["space directions: " + " ".join(vectors[:3]) + rest, "space origin: " + vectors[3]]


def table(columns, rows):
    return "\n".join([columns, *(",".join(map(str, row)) for row in rows)]) + "\n"


def annulus_file(points_world):
    """A closed curve as it is drawn, N x 3 in the world's RAS."""
    if len(points_world) < 3:
        raise Trouble("The annulus curve has no points yet.")
    return {"name": "annulus.csv", "text": table("x,y,z", moved(points_world, FLIP).tolist())}


def tips_file(labels, points_world):
    """Papillary tips labelled by their side (AL, PM, antero-lateral, ...)."""
    sides = [_side(label) for label in labels]
    rows = [[side, *point] for side, point in zip(sides, moved(points_world, FLIP).tolist())]
    return {"name": "tips.csv", "text": table("papillary,x,y,z", rows)}


def _side(label):
    letters = re.sub(r"[^a-z]", "", label.lower())
    if letters.startswith(("al", "antero")):
        return "AL"
    if letters.startswith(("pm", "postero")):
        return "PM"
    raise Trouble(f'Papillary tip "{label}" must be labelled AL or PM, after its muscle.')


@dataclass
class Control:
    """What a person may say against a decision. options: (text, value) of each."""

    text: str
    key: str
    options: tuple
    value: object


_CONTROLS = (
    ("Leaflets were imaged", "closed", (("as it looks", None), ("open", False), ("closed", True))),
    ("Atrium", "flip", (("on the side that it looks", None), ("on the other side", True))),
    ("Segmentation is", "mirrored", (("not a mirror image", None), ("a mirror image", True))),
    ("Names of the leaflets are", "trust_labels", (("judged by what they look like", None), ("right", True))),
    ("Lengths are in", "units", (("mm, or as it looks", None), *((unit, unit) for unit in ("cm", "in", "m")))),
)


@dataclass
class Shown:
    """A closed valve. markups and labels are None where the service makes no files."""

    scene: dict
    matrix: numpy.ndarray  # from the scene's coordinates to RAS below the transform
    markups: list = None  # (type, name, labels, points) below the transform
    labels: bytes = None  # a label map below the transform, as a .seg.nrrd

    def words(self):
        closure = self.scene["closure"]
        leak, error = closure["leak_mm2"], (closure.get("leak") or {}).get("error_mm2")
        if leak is None:
            return f"The closure cannot be trusted: {closure['status']}."
        words = f"Leak {leak:.1f}" + ("" if error is None else f" ± {error:.1f}") + " mm²"
        return words if closure["status"] == "converged" and not closure["crossing"] else f"{words}, not to be trusted"


class Case:
    """What is known of one valve. says: of a person, fields of the import's request; roles: part of each label."""

    def __init__(self):
        self.map, self.files, self.says, self.roles = None, {}, {}, {}
        self.valve, self.imported, self.job, self.plans = None, None, None, []

    def take(self, segmentation, annulus=None, tips=None, closed=None, again=False):
        """annulus and tips are files.

        :param closed: whether they were imaged in systole, None: not known
        :param again: the same as before, perhaps drawn on: what was said of them holds
        """
        before, new = self.map, segmentation.cropped()
        says, roles = self.says, self.roles
        self.__init__()
        self.map = new
        self.files = {name: file for name, file in (("annulus", annulus), ("tips", tips)) if file}
        self.says = {} if closed is None else {"closed": closed}
        self.roles = {number: part for number, _, one in self.map.numbers if (part := one.part())}
        if again and before and [one.id for *_, one in before.numbers] == [one.id for *_, one in new.numbers]:
            self.says, self.roles = says, roles

    def take_valve(self, document):
        """A coapt.valve file instead."""
        if not isinstance(document, dict) or not str(document.get("schema", "")).startswith("coapt.valve/"):
            raise Trouble("This is no coapt.valve file.")
        self.__init__()
        self.valve = document

    def importing(self, service):
        """Steps: makes the valve of the inputs."""
        service.needs("import segmentations")
        yield "importing ..."
        labels = {"name": "segmentation.seg.nrrd", "base64": base64.b64encode(self.map.nrrd()).decode()}
        numbers = {part: [n for n, one in self.roles.items() if one == part] for part in PARTS}
        request = {"labels": labels, "chordae_seed": 1, **self.files, **self.says}
        if any(numbers.values()):
            request["label_numbers"] = {part: found for part, found in numbers.items() if found}
        try:
            job = (yield service.ask("POST", "/v1/imports", request)).json()
        except Refused as refusal:
            labels = ", ".join(f'{number} is "{segment.name}"' for number, _, segment in self.map.numbers)
            raise Trouble(f"{refusal}\nOf the labels {labels}.") from refusal
        job = yield from followed(service, job, lambda job: "drawing what was imported ...")
        if job["state"] == "CANCELLED":
            raise Cancelled("The import was cancelled.")
        self.imported = (yield service.ask("GET", job["links"]["result"])).json()
        self.valve = (yield service.ask("GET", f"/v1/valves/{self.imported['valve']}")).json()
        self.job, self.plans = None, []
        return self.imported

    def decisions(self):
        """(subject, value, reason, look), those to be checked against the images first."""
        found = self.imported["decisions"] if self.imported else []
        rows = [(one["subject"], one["value"], one["reason"], one["look"]) for one in found]
        return sorted(rows, key=lambda row: not row[3])

    def controls(self):
        """What may be said against decisions; None leaves it to the import."""
        if not self.map:
            return []
        taken = {one["number"]: one["part"] for one in self.imported["labels"]} if self.imported else self.roles
        rest = "not used" if self.imported else "as it looks"
        parts = ((rest, None), *((part, part) for part in PARTS))
        labels = [Control(f"{one.name} is", f"label {n}", parts, taken.get(n)) for n, _, one in self.map.numbers]
        return labels + [Control(*control, self.says.get(control[1])) for control in _CONTROLS]

    def say(self, key, value):
        """What a control was set to; the next import takes it."""
        if not key.startswith("label "):
            self.says = {name: said for name, said in {**self.says, key: value}.items() if said is not None}
            return
        number = int(key.split()[1])
        roles = {one["number"]: one["part"] for one in self.imported["labels"]} if self.imported else self.roles
        before, holders = roles.get(number), [n for n, part in roles.items() if part == value]
        if value and before and len(holders) == 1:  # then they exchange their parts
            roles[holders[0]] = before
        self.roles = {n: part for n, part in {**roles, number: value}.items() if part}

    def closing(self, service, plan=None):
        """Steps: the valve, repaired by a plan if there is one, Shown."""
        repaired = {"valve": self._need_valve(), **({"plan": plan} if plan else {})}
        yield "closing ..."
        scene = (yield service.ask("POST", "/v1/scenes", {**repaired, "frames": FRAMES})).json()
        back = numpy.linalg.inv(self.map.to_world) if self.map else numpy.eye(4)
        own = numpy.array(self.valve.get("patient_frame") or numpy.eye(4).tolist(), float)
        shown = Shown(scene, back @ FLIP @ own)
        if service.kind == "service" and scene["closed_mm"]:
            yield "writing markups ..."
            found = (yield service.ask("POST", "/v1/exports", {**repaired, "format": "mrk.json"})).json()
            shown.markups = [_markup(one, back @ FLIP) for one in found["markups"]]
            if self.map:
                yield "drawing the label map ..."
                request = {**repaired, "format": "nrrd", "grid": self.map.grid()}
                shown.labels = self.map.placed((yield service.ask("POST", "/v1/exports", request)).body)
        return shown

    def planning(self, service, **search):
        """Steps: the ranked plans; cancelled, the best so far."""
        yield "searching ..."
        request = {"valve": self._need_valve(), "search": search}
        self.job, self.plans = None, []
        job = (yield service.ask("POST", "/v1/plans", request)).json()
        self.job = yield from followed(service, job, _searched)
        self.plans = self.job["plans"] or []
        if not self.plans:
            cancelled = self.job["state"] == "CANCELLED"
            raise Trouble("The search was cancelled before it had a plan." if cancelled else "There is no plan to try.")
        return self.plans

    def rows(self):
        """Of the table of plans: rank, steps, leak, cost, remarks."""
        return [_row(plan) for plan in self.plans]

    def reporting(self, service):
        """Steps: the page on the search."""
        service.needs("write reports")
        if not self.plans:
            raise Trouble("There is no search to report on.")
        yield "drawing the report ..."
        return (yield service.ask("GET", self.job["links"]["report"])).body

    def _need_valve(self):
        if self.valve is None:
            raise Trouble("There is no valve yet: import a segmentation, or open a valve file.")
        return self.valve


def _searched(job):
    progress = job["progress"]
    planned = progress["closures_planned"]
    return f"{progress['stage']}: {progress['closures']}" + (f" of {planned} closures" if planned else " closures")


def _row(plan):
    leak, cost = plan["leak_mm2"], plan["cost"]
    known = leak["mean"] is not None
    remarks = [*(["not to be told from the next"] if plan["tie_with_next"] else []), *plan["warnings"]]
    return (
        str(plan["rank"]),
        "; ".join(plan["description"]) or "no repair",
        f"{leak['mean']:.1f} ± {leak['sd']:.1f} mm²" if known else "not known",
        "" if cost is None else f"{cost:.1f}",
        "; ".join(remarks),
    )


def _markup(markup, to_local):
    points = markup["controlPoints"]
    places = moved([point["position"] for point in points], to_local)
    return markup["type"], markup["name"], [point["label"] for point in points], places
