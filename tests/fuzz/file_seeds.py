#!/usr/bin/env python3
"""file_seeds.py FOLDER: what fuzz_mesh and fuzz_image start from: the files that other programs wrote for the tests, each
behind the byte that chooses its reader."""

import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
MESH_READERS = {".vtk": 3, ".vtu": 8, ".vtp": 9}  # fuzz_mesh.cpp


def main():
    folder = Path(sys.argv[1])
    for name in ("mesh", "image"):
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


if __name__ == "__main__":
    main()
