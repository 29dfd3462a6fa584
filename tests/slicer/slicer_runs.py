"""The Slicer module's parts, the example's segmentation, and a coapt-server to ask."""

import functools
import gzip
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from plan_runs import BARE
from programs import SOURCE
from server_runs import ServerTest

sys.path.insert(0, str(SOURCE / "clients/slicer/Coapt"))

from CoaptLib import case, service  # noqa: E402

EXAMPLE = SOURCE / "examples/scripts/label_map.py"
NAMES = ("Anterior leaflet", "Posterior leaflet", "Annulus")
VOXEL_MM = 0.6
SMALL = BARE | {"evaluations": 6, "plans": 1, "region_points": 2, "evidence": False}
COARSE = {"triangles": 200}  # of an import whose mesh does not matter


def read_nrrd(content):
    """Voxels (layers first, then k, j, i, if it has layers), 4 x 4 from i, j, k to LPS, and the lines of the header."""
    head, packed = content.split(b"\n\n", 1)
    lines = head.decode().split("\n")
    fields = dict(line.split(": ", 1) for line in lines if ": " in line)
    size = [int(number) for number in fields["sizes"].split()]
    to_lps = numpy.eye(4)
    vectors = [part for part in fields["space directions"].split() if part != "none"]
    for k, part in enumerate([*vectors, fields["space origin"]]):
        to_lps[:3, k] = [float(number) for number in part.strip("()").split(",")]
    return numpy.frombuffer(gzip.decompress(packed), numpy.uint8).reshape(size[::-1]), to_lps, lines


def probe_to_ras():
    """As SlicerHeart has it: it turns and moves the example to where a heart lies, along none of the image's axes."""
    to_the_atrium, to_the_aorta = numpy.array([-0.65, 0.5, 0.55]), numpy.array([-0.6, -0.7, 0.0])  # LPS
    z = to_the_atrium / numpy.linalg.norm(to_the_atrium)
    x = numpy.cross(to_the_aorta, z) / numpy.linalg.norm(numpy.cross(to_the_aorta, z))
    to_lps = numpy.eye(4)
    to_lps[:3, :3] = numpy.column_stack([x, numpy.cross(z, x), z])
    matrix = case.FLIP @ to_lps @ case.FLIP
    matrix[:3, 3] = 31.0, -47.0, 112.0
    return matrix


@functools.cache
def example_map():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "map.seg.nrrd"
        command = [sys.executable, EXAMPLE, "-o", path, "--voxel", str(VOXEL_MM)]
        subprocess.run(command, check=True, capture_output=True)
        return read_nrrd(path.read_bytes())


def example(to_world=None, names=NAMES):
    """The example as Slicer would hold it: the map's own axes are those below the transform."""
    labels, to_lps, _ = example_map()
    segments = [case.Segment(name, labels == i, id=f"Segment_{i}") for i, name in enumerate(names, 1)]
    return case.Segmentation(segments, case.FLIP @ to_lps, numpy.eye(4) if to_world is None else to_world)


def voxel_places(segmentation, numbers=(0, 1)):
    """N x 3, below the transform: the centres of the voxels of these segments."""
    inside = numpy.any([segmentation.segments[i].mask for i in numbers], axis=0)
    return case.moved(numpy.argwhere(inside)[:, ::-1], segmentation.ijk_to_local)


def nearest_mm(points, others):
    return numpy.array([numpy.linalg.norm(others - point, axis=1).min() for point in points])


class Asked(unittest.TestCase):
    def trouble(self, steps):
        """What is said of steps that end so."""
        with self.assertRaises(service.Trouble) as raised:
            service.waited(steps)
        return str(raised.exception)


class SlicerTest(Asked, ServerTest):
    def setUp(self):
        super().setUp()
        self.service = service.Service(self.url)
