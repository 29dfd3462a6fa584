"""Files of segmentation tools, as they go to the service."""

from __future__ import annotations

import base64
import os
import pathlib
from collections.abc import Iterable
from typing import Any

from .errors import NoSuchFile
from .files import read_bounded
from .geometry import packed_geometry

_BINARY = (".ply", ".stl", ".glb", ".vtk", ".vtp", ".vtu", ".nrrd", ".nii", ".gz", ".bz2", ".mha")  # may be
_MOST_MIB = 1040  # 2^27 voxels of 8 bytes, and a header
_OF_A_FOLDER = (".vtk", ".csv", ".json")  # what SlicerHeart and coapt write there


def packed(path: str | os.PathLike[str] | Any, name: str = "surface") -> dict[str, Any]:
    """A file, or what packed_geometry() takes, under this name.

    :raises NoSuchFile: it is not there, or cannot be read
    """
    if not isinstance(path, str | os.PathLike):
        return packed_geometry(path, name)
    file = pathlib.Path(path)
    try:
        content = read_bounded(file, _MOST_MIB)
    except OSError as error:
        raise NoSuchFile(f"{path}: cannot be read: {error.strerror}") from error
    if file.suffix.lower() in _BINARY:
        return {"name": file.name, "base64": base64.b64encode(content).decode()}
    return {"name": file.name, "text": content.decode(errors="replace")}


def packed_folder(path: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """
    :raises NoSuchFile: it is no folder
    """
    folder = pathlib.Path(path)
    if not folder.is_dir():
        raise NoSuchFile(f"{path}: is no folder")
    return [packed(file) for file in sorted(folder.iterdir()) if file.suffix.lower() in _OF_A_FOLDER]


def files_to_import(
    leaflets: Iterable[str | os.PathLike[str] | Any] | str | os.PathLike[str],
    annulus: str | os.PathLike[str] | Any | None,
    chordae: str | os.PathLike[str] | int,
    tips: str | os.PathLike[str] | Any | None,
) -> dict[str, Any]:
    """leaflets: meshes, or one label map; chordae: a file, or the seed of those to be drawn."""
    files: dict[str, Any] = (
        {"labels": packed(leaflets)}
        if isinstance(leaflets, str | os.PathLike)
        else {"leaflets": [packed(leaflet, f"leaflet-{i}") for i, leaflet in enumerate(leaflets, 1)]}
    )
    if annulus is not None:
        files["annulus"] = packed(annulus, "annulus")
    if isinstance(chordae, int):
        files["chordae_seed"] = chordae
    else:
        files["chordae"] = packed(chordae)
    if tips is not None:
        files["tips"] = packed(tips, "tips")
    return files
