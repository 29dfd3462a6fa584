"""Files of some kilobytes that grow to gigabytes where they are taken apart without a count, as requests of an import."""

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
