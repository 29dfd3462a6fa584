#!/usr/bin/env python3
"""Fails if a wheel is not what its name says: tags, hashes of RECORD, and the rules of manylinux if it has that tag.

Usage: check_wheel.py WHEEL
"""
import base64
import csv
import hashlib
import io
import pathlib
import sys
import tempfile
import zipfile

from wheel_rules import TAG, folder_problems


def record_problems(archive, info):
    """Each file but RECORD stands there with its size and hash, and nothing else does."""
    problems = []
    rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(archive.read(f"{info}/RECORD").decode()))}
    names = {name for name in archive.namelist() if not name.endswith("/")}
    for name in sorted(names ^ set(rows)):
        problems.append(f"{name}: {'not in RECORD' if name in names else 'in RECORD alone'}")
    for name in sorted(names & set(rows) - {f"{info}/RECORD"}):
        content = archive.read(name)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        if rows[name] != [f"sha256={digest}", str(len(content))]:
            problems.append(f"{name}: has changed since RECORD was written")
    return problems


def wheel_problems(path):
    name, version, *tags = path.stem.split("-")
    info = f"{name}-{version}.dist-info"
    with zipfile.ZipFile(path) as archive, tempfile.TemporaryDirectory() as folder:
        if archive.testzip():
            return [f"{path.name}: is damaged"]
        problems = record_problems(archive, info)
        said = archive.read(f"{info}/WHEEL").decode().splitlines()
        if f"Tag: {'-'.join(tags)}" not in said:
            problems.append(f"{path.name}: WHEEL has other tags")
        if f"Version: {version}" not in archive.read(f"{info}/METADATA").decode().splitlines():
            problems.append(f"{path.name}: METADATA has another version")
        archive.extractall(folder)
        if tags[-1] == TAG:
            problems += folder_problems(folder)
        elif tags[-1].startswith("manylinux"):
            problems.append(f"{path.name}: {tags[-1]} is checked by no rules here, {TAG} is")
        return problems


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    problems = wheel_problems(pathlib.Path(sys.argv[1]))
    for problem in problems:
        print(problem, file=sys.stderr)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
