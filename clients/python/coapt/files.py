"""JSON files, and the documents that hold repair plans."""

from __future__ import annotations

import difflib
import json
import os
import pathlib
from collections.abc import Iterable, Mapping
from typing import Any, TypeGuard

from .errors import BadDocument, NoSuchFile

Path = str | os.PathLike[str]

GEOMETRY = (".obj", ".ply", ".stl", ".glb", ".gltf", ".vtk", ".vtp", ".vtu", ".nrrd", ".nii", ".gz", ".mha")
"""Endings of files of which a valve is made."""


def is_path(source: object) -> TypeGuard[Path]:
    """A pathlib.Path, or text that ends in ".json"; other text is a name or an id."""
    return isinstance(source, os.PathLike) or isinstance(source, str) and source.endswith(".json")


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """'; did you mean "..."?', empty if nothing known is near."""
    near = difflib.get_close_matches(word, list(known), n=1)
    return f'; did you mean "{near[0]}"?' if near else ""


def read_bounded(path: Path, most_mib: int = 64) -> bytes:
    """What is in it, up to what the command line reads.

    :raises OSError: it cannot be read
    :raises BadDocument: it is larger, or has no end
    """
    with open(path, "rb") as file:
        content = file.read((most_mib << 20) + 1)
    if len(content) > most_mib << 20:
        raise BadDocument(f"{path}: is larger than {most_mib} MiB")
    return content


def read_json(path: Path) -> Any:
    """
    :raises NoSuchFile: it is not there
    :raises BadDocument: it cannot be read, or is no JSON
    """
    file = pathlib.Path(path)
    try:
        content = read_bounded(file)
    except FileNotFoundError as error:
        beside = [one.name for one in file.parent.glob("*.json")] if file.parent.is_dir() else []
        raise NoSuchFile(
            f"{path}: there is no such file in {file.parent.resolve()}{did_you_mean(file.name, beside)}"
        ) from error
    except OSError as error:
        raise BadDocument(f"{path}: cannot be read: {error.strerror}") from error
    try:
        return json.loads(content)
    except ValueError as error:
        raise BadDocument(f"{path}: is no JSON: {error}") from error


def read_plan_entries(path: Path) -> list[tuple[str, Any]]:
    """plan_entries() of a file; a plan by itself is named like the file.

    :raises NoSuchFile, BadDocument: it holds no plan
    """
    document = read_json(path)
    try:
        return [(name or pathlib.Path(path).stem, plan) for name, plan in plan_entries(document)]
    except BadDocument as error:
        raise BadDocument(f"{path}: {error}") from error


def plan_entries(document: Any) -> list[tuple[str, Any]]:
    """Name and coapt.plan/1 of each plan of a document, in its order, as the command line reads them: a plan by itself (its
    name is empty), one under "plan", or a list under "plans" or "kept_plans". The plans are not checked.

    :raises BadDocument: it holds no plan
    """
    if not isinstance(document, Mapping):
        raise BadDocument("must be an object: a coapt.plan/1, or plans under one of plan, plans, kept_plans")
    for name in ("plans", "kept_plans"):
        if name in document:
            entries = document[name]
            if not isinstance(entries, list) or not entries:
                raise BadDocument(f"/{name}: must be a list of at least one plan")
            return [_entry(entry, i, f"/{name}/{i}") for i, entry in enumerate(entries)]
    return [_entry(document, 0, "")] if "plan" in document else [("", document)]


def _entry(entry: Any, index: int, path: str) -> tuple[str, Any]:
    if isinstance(entry, Mapping) and ("plan" in entry or "steps" in entry):
        name = entry.get("name")
        return name if isinstance(name, str) else f"plan {index + 1}", entry.get("plan", entry)
    raise BadDocument(f"{path}: holds no plan: neither plan nor steps")
