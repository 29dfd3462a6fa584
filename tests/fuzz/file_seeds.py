#!/usr/bin/env python3
"""file_seeds.py FOLDER: what fuzz_mesh, fuzz_image, fuzz_roles and fuzz_forms start from: the files that other programs
wrote for the tests, each behind the byte that chooses its reader, and small ones of kinds that these are not."""

import bz2
import gzip
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
MESH_READERS = {".vtk": 3, ".vtu": 8, ".vtp": 9}  # fuzz_mesh.cpp

SPACED = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 1\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
META = (
    b"ObjectType = Image\nNDims = 4\nDimSize = 2 2 1 2\nElementSpacing = 1 1 1 1\nOffset = 0 0 0 0\nHeaderSize = -1\n"
)
META += b"CompressedData = False\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n\0\1\2\3\0\1\2\3"
FORM = b'boundary=x\n--x\r\nContent-Disposition: form-data; name="leaflets"; filename="a.obj"\r\n\r\nv 0 0 0\r\n'
FORM += b'--x\r\nContent-Disposition: form-data; name="fit.side"\r\n\r\nmiddle\r\n--x--\r\n'
LINES = b'<VTKFile type="PolyData"><PolyData><Piece><Points><DataArray type="Float32" format="ascii">0 0 0 1 0 0 0 1 0'
LINES += b'</DataArray></Points><Lines><DataArray Name="connectivity" format="ascii">0 1 2 0</DataArray><DataArray '
LINES += b'Name="offsets" format="ascii">4</DataArray></Lines></Piece></PolyData></VTKFile>'
BLOCKS = b'<VTKFile type="vtkMultiBlockDataSet"><Block name="valve"><DataSet name="anterior" file="m/0.vtp"/></Block></VTKFile>'
OBJECTS = b"o anterior\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no posterior\nv 0 0 2\nv 1 0 2\nv 0 1 2\nf 4 5 6\nl 1 2 3\n"
OTHERS = {
    "image/phases.mha": bytes([8]) + META,
    "image/header.mhd": bytes([24]) + META.replace(b"LOCAL", b"x.raw"),
    "image/header.nhdr": bytes([1]) + b"NRRD0004\nsizes: 1 1 1\ndata file: x.raw\nencoding: raw\n",
    "image/packed.nrrd": bytes([1]) + SPACED + b"encoding: bzip2\n\n" + bz2.compress(b"\0\1\2\3"),
    "image/whole.nrrd.bz2": bytes([9]) + bz2.compress(SPACED + b"encoding: raw\n\n\0\1\2\3"),
    "image/whole.mha.gz": bytes([9]) + gzip.compress(META, mtime=0),
    "forms/form": FORM,
    "mesh/lines.vtp": bytes([14]) + LINES,
    "mesh/blocks.vtm": bytes([10]) + BLOCKS,
    "mesh/ring.csv": bytes([11]) + b"\xef\xbb\xbf# of a ring\nid;x;y;z\n1;1,5;2,5;3,5\n2;2,5;3,5;4,5\n",
    "mesh/objects.obj": bytes([12]) + OBJECTS,
    "roles/files": b"\0AMVL.obj\0" + OBJECTS + b"\0P2.stl\0\0annulus.mrk.json\0{}\0tips.csv\0AL,1,2,3\nPM,4,5,6\n\0",
    "roles/name": b"\1PM papillary tip",
    "roles/table": b"\2# units: cm\nlabel;x [cm];y;z\nALC;1,5;2,5;3,5\nPMC;2,5;3,5;4,5\n",
    "roles/surface": b"\3a.obj\0" + OBJECTS,
    "roles/curve": b"\3ring.csv\0x,y,z\n1,2,3\n2,3,4\n3,4,6\n",
}


def main():
    folder = Path(sys.argv[1])
    for name in ("mesh", "image", "roles", "forms"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for path in sorted((TESTS / "io/mesh/vtk_files").iterdir()):
        reader = MESH_READERS.get(path.suffix)
        if reader is not None:
            (folder / "mesh" / path.name).write_bytes(bytes([reader]) + path.read_bytes())
            if path.suffix == ".vtp":  # as far as its reader goes, which names another type
                grid = path.read_bytes().replace(b"PolyData", b"UnstructuredGrid")
                (folder / "mesh" / f"{path.name}.vtu").write_bytes(bytes([MESH_READERS[".vtu"]]) + grid)
    for path in sorted((TESTS / "io/image/files").iterdir()):
        if path.is_file():
            nrrd = path.suffix == ".nrrd"
            (folder / "image" / path.name).write_bytes(bytes([6 + nrrd]) + path.read_bytes())
    for name, content in OTHERS.items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
