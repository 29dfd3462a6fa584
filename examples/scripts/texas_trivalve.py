#!/usr/bin/python3
"""The Texas TriValve closed by coapt, beside the state that Abaqus/Explicit found: figures and a picture.

  coapt valve import --abaqus Healthy_QuasiStatic.inp -o trivalve.json
  coapt close trivalve.json --closed closed.ply
  texas_trivalve.py Healthy_QuasiStatic_0.vtu Healthy_QuasiStatic_20.vtu closed.ply picture.png

Needs python3-numpy and python3-vtk9 (Debian). Nodes are compared one by one: vertex i of closed.ply is point i of the
frames. Data: SoftTissueBiomechanicsLab/Texas_TriValve_1.1 (CC BY 4.0), Mathur et al. 2022.
"""

import struct
import sys
import zlib

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

LEAFLETS = {
    2: ("anterior", (0.86, 0.47, 0.42)),
    3: ("septal", (0.47, 0.62, 0.86)),
    1: ("posterior", (0.56, 0.76, 0.52)),
}
CONTACT_MM = 0.25  # mid-surfaces rest 0.16 mm apart
FAR_AT_REST_MM = 1.2  # neighbours in the mesh are no contact
LARGEST_SHOWN_MM = 1.5


def read_frame(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    quads = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return points, quads, vtk_to_numpy(grid.GetCellData().GetArray("element_sets"))


def read_ply(path):
    lines = open(path, encoding="ascii").read().split("\n")
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    first = lines.index("end_header") + 1
    return np.array([line.split()[:3] for line in lines[first : first + count]], float)


def stretches(quads, rest, now):
    """Principal stretches at the centre of each quadrilateral, the smaller first."""

    def sides(points):
        p = points[quads]
        return (p[:, 1] + p[:, 2] - p[:, 0] - p[:, 3]) / 4, (p[:, 2] + p[:, 3] - p[:, 0] - p[:, 1]) / 4

    def unit(v):
        return v / np.linalg.norm(v, axis=1)[:, None]

    a0, b0 = sides(rest)
    a, b = sides(now)
    e1 = unit(a0)
    e2 = unit(np.cross(np.cross(a0, b0), e1))
    rows = [np.stack([(a0 * e).sum(1), (b0 * e).sum(1)], -1) for e in (e1, e2)]
    inverse = np.linalg.inv(np.stack(rows, 1))
    metric = np.stack([np.stack([(u * a).sum(1), (u * b).sum(1)], -1) for u in (a, b)], 1)
    return np.sqrt(np.linalg.eigvalsh(np.einsum("nij,nik,nkl->njl", inverse, metric, inverse)))


def distance_to_surface(triangles, surface, points):
    mesh, vertices, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    vertices.SetData(numpy_to_vtk(surface.copy(), deep=1))
    for triangle in triangles:
        cells.InsertNextCell(3)
        for corner in triangle:
            cells.InsertCellPoint(int(corner))
    mesh.SetPoints(vertices)
    mesh.SetPolys(cells)
    locator = vtk.vtkCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    nearest, cell, part, squared = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
    result = np.empty(len(points))
    for i, point in enumerate(points):
        locator.FindClosestPoint(point, nearest, cell, part, squared)
        result[i] = np.sqrt(float(squared))
    return result


def contact_share(triangles, rest, now):
    """Share of nodes nearer than CONTACT_MM to a triangle that is not near them at rest (by the triangles' corners and
    middles, half an edge apart)."""

    def samples(points):
        corners = points[triangles]
        sides = [(corners[:, k] + corners[:, (k + 1) % 3]) / 2 for k in range(3)]
        return np.concatenate([points, corners.mean(1)] + sides)

    places, places_rest = samples(now), samples(rest)
    cloud, points = vtk.vtkPolyData(), vtk.vtkPoints()
    points.SetData(numpy_to_vtk(places.copy(), deep=1))
    cloud.SetPoints(points)
    locator = vtk.vtkStaticPointLocator()
    locator.SetDataSet(cloud)
    locator.BuildLocator()
    near, touching = vtk.vtkIdList(), 0
    for place, place_rest in zip(now, rest):
        locator.FindPointsWithinRadius(CONTACT_MM, place, near)
        ids = [near.GetId(i) for i in range(near.GetNumberOfIds())]
        touching += bool((np.linalg.norm(places_rest[ids] - place_rest, axis=1) > FAR_AT_REST_MM).any())
    return touching / len(now)


def draw(triangles, points, colours, view, size=480, scale_mm=17.5):
    """Orthographic, nearest triangle on top, lit from the eye. view: rows are right, up, to the eye."""
    p = (points - np.array([0.0, 0.0, -6.0])) @ view.T
    pixels = np.empty((len(p), 2))
    pixels[:, 0] = size / 2 * (1 + p[:, 0] / scale_mm)
    pixels[:, 1] = size / 2 * (1 - p[:, 1] / scale_mm)
    image, depth = np.ones((size, size, 3)), np.full((size, size), -np.inf)
    for triangle, colour in zip(triangles, colours):
        a, b, c = pixels[triangle]
        low = np.maximum(np.floor(np.minimum(np.minimum(a, b), c)).astype(int), 0)
        high = np.minimum(np.ceil(np.maximum(np.maximum(a, b), c)).astype(int), size - 1)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if (low > high).any() or abs(area) < 1e-9:
            continue
        x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
        v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        z = (
            p[triangle[0], 2]
            + v * (p[triangle[1], 2] - p[triangle[0], 2])
            + w * (p[triangle[2], 2] - p[triangle[0], 2])
        )
        inside = (v >= -1e-6) & (w >= -1e-6) & (v + w <= 1 + 1e-6) & (z > depth[y, x])
        normal = np.cross(p[triangle[1]] - p[triangle[0]], p[triangle[2]] - p[triangle[0]])
        light = 0.35 + 0.65 * abs(normal[2]) / np.linalg.norm(normal)
        depth[y[inside], x[inside]] = z[inside]
        image[y[inside], x[inside]] = light * np.asarray(colour)
    return image


def write_png(path, image):
    rows = (np.clip(image, 0, 1) * 255).astype(np.uint8)
    raw = b"".join(b"\0" + row.tobytes() for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")
        )


def main(rest_path, frame_path, closed_path, picture_path=None):
    rest, quads, leaflet = read_frame(rest_path)
    theirs, _, _ = read_frame(frame_path)
    ours = read_ply(closed_path)
    rest, theirs = rest[: len(ours)], theirs[: len(ours)]
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    distance = np.linalg.norm(ours - theirs, axis=1)

    def say(name, d):
        print(f"{name}: rms {np.sqrt((d**2).mean()):.3f}, p95 {np.percentile(d, 95):.3f}, max {d.max():.3f} mm")

    say("node to node", distance)
    say("node to surface", distance_to_surface(triangles, theirs, ours))
    print(
        f"nodes in contact: {contact_share(triangles, rest, ours):.3f}, reference {contact_share(triangles, rest, theirs):.3f}"
    )
    strains = [np.log(stretches(quads, rest, x)[:, 1]) for x in (ours, theirs)]
    for key, (name, _) in list(LEAFLETS.items()) + [(None, ("all", None))]:
        chosen = leaflet == key if key else leaflet > 0
        nodes = np.unique(quads[chosen])
        print(
            f"{name}: rms {np.sqrt((distance[nodes] ** 2).mean()):.3f} mm; largest log strain, median "
            f"{np.median(strains[0][chosen]):.3f}, reference {np.median(strains[1][chosen]):.3f}"
        )
    if not picture_path:
        return
    plain = np.array([LEAFLETS[k][1] for k in np.concatenate([leaflet, leaflet])])
    share = np.clip(distance[triangles].mean(1) / LARGEST_SHOWN_MM, 0, 1)[:, None]
    coloured = (1 - share) * np.array([0.95, 0.95, 0.97]) + share * np.array([0.75, 0.05, 0.1])
    eye = np.array([0.55, -0.75, -0.37])
    right = np.cross([0, 0, 1], eye)
    right /= np.linalg.norm(right)
    eye /= np.linalg.norm(eye)
    views = [np.eye(3), np.array([right, np.cross(eye, right), eye])]
    panels = [(theirs, plain), (ours, plain), (ours, coloured)]
    write_png(picture_path, np.vstack([np.hstack([draw(triangles, x, c, view) for x, c in panels]) for view in views]))


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
