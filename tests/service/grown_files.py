"""Files that grow where they are taken apart without a count, kilobytes to gigabytes or polygons to millions of triangles, and voxels to
be written, as requests."""

import base64
import gzip
import zlib


def named(name, content):
    return {"name": name, "base64": base64.b64encode(content).decode()}


def checkerboard(side):
    """A label map in which every voxel has six neighbours of the other label."""
    header = f"NRRD0004\ntype: uchar\ndimension: 3\nsizes: {side} {side} {side}\nencoding: gzip\n"
    header += "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n"
    row = bytes(1 + i % 2 for i in range(side + 1))
    plane = [b"".join(row[(y + z) % 2 :][:side] for y in range(side)) for z in (0, 1)]
    voxels = gzip.compress(b"".join(plane[z % 2] for z in range(side)), 9)
    return {"labels": named("map.nrrd", header.encode() + voxels), "chordae_seed": 1}


def repeated_arrays(arrays, megabytes):
    """A .vtp of many arrays that are the same bytes."""
    block = zlib.compress(bytes(megabytes << 20), 9)
    data = b"".join(n.to_bytes(4, "little") for n in (1, megabytes << 20, 0, len(block))) + block
    lines = "".join(f'<DataArray type="UInt8" Name="a{i}" format="appended" offset="0"/>' for i in range(arrays))
    head = '<VTKFile type="PolyData" byte_order="LittleEndian" compressor="vtkZLibDataCompressor"><PolyData>'
    head += (
        f'<Piece NumberOfPoints="3" NumberOfPolys="1"><PointData>{lines}</PointData><Points><DataArray type="Float32" '
    )
    head += (
        'NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type="Int32" '
    )
    head += (
        'Name="connectivity" format="ascii">0 1 2</DataArray><DataArray type="Int32" Name="offsets" format="ascii">3'
    )
    head += '</DataArray></Polys></Piece></PolyData><AppendedData encoding="raw">_'
    return {"leaflets": [named("bomb.vtp", head.encode() + data + b"</AppendedData></VTKFile>")], "chordae_seed": 1}


def compared(text):
    """A comparison with a surface of OBJ, which is refused before the valve beside it is closed."""
    return {"closed": {"file": {"name": "grown.obj", "text": text}}, "reference": {"valve": "human-normal"}}


def fans(polygons):
    """Polygons of 997 triangles each, in 2 kB."""
    return compared("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + ("f 1" + " 2 3" * 499 + "\n") * polygons)


def equal_faces(faces):
    """On three vertices, of as many as there are faces."""
    return compared("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "v 1 2 3\n" * (faces - 3) + "f 1 2 3\n" * faces)


def label_maps(valve, side, formats):
    """A valve that fits into 48 mm, on a grid of so many voxels each way."""
    step = 48.0 / side
    to_lps_mm = [[step if row == column else 0.0 for column in range(3)] + [-24.0] for row in range(3)]
    placed = valve | {"patient_frame": [[float(row == column) for column in range(4)] for row in range(4)]}
    return {"valve": placed, "formats": formats, "grid": {"size": [side] * 3, "to_lps_mm": to_lps_mm}}
