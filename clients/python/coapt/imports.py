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

_BINARY = (
    ".raw",
    ".zraw",
    ".bin",
    ".ply",
    ".stl",
    ".glb",
    ".vtk",
    ".vtp",
    ".vtu",
    ".nrrd",
    ".nii",
    ".gz",
    ".bz2",
    ".mha",
)  # may be
_MOST_MIB = 1040  # 2^27 voxels of 8 bytes, and a header
_TEXTS = (".obj", ".csv", ".tsv", ".txt", ".fcsv", ".json", ".gltf", ".vtm", ".nhdr", ".mhd")
_OF_A_FOLDER = (*_BINARY, *_TEXTS)
OF_SLICERHEART = (".vtk", ".csv", ".json")
_NO_PARTS = (".", "license", "readme", "copying", "notice")


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


def packed_folder(path: str | os.PathLike[str], suffixes: tuple[str, ...] = _OF_A_FOLDER) -> list[dict[str, Any]]:
    """Its files with such suffixes, but hidden ones and those that say whose they are.

    :raises NoSuchFile: it is no folder
    """
    folder = pathlib.Path(path)
    if not folder.is_dir():
        raise NoSuchFile(f"{path}: is no folder")
    return [
        packed(file)
        for file in sorted(folder.iterdir())
        if file.is_file() and file.suffix.lower() in suffixes and not file.name.lower().startswith(_NO_PARTS)
    ]


def packed_files(
    files: Iterable[str | os.PathLike[str] | Any] | str | os.PathLike[str],
) -> list[dict[str, Any]]:
    """Files, folders of them, or what packed_geometry() takes."""
    given = [files] if isinstance(files, str | os.PathLike) else list(files)
    packs: list[dict[str, Any]] = []
    for i, one in enumerate(given, 1):
        is_folder = isinstance(one, str | os.PathLike) and pathlib.Path(one).is_dir()
        packs += packed_folder(one) if is_folder else [packed(one, f"file-{i}")]
    return packs


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
