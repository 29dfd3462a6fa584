#!/usr/bin/python3
"""The version of coapt is the same wherever it stands."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACES = {
    "CMakeLists.txt": r"project\(coapt VERSION (\S+)",
    "CITATION.cff": r"^version: (\S+)",
    "CHANGELOG.md": r"^## (\S+?),? ",
    "clients/python/pyproject.toml": r'^version = "(.+)"',
    "clients/python/coapt/__init__.py": r'^__version__ = "(.+)"',
    "debian/changelog": r"^coapt \((.+?)\)",
    "server/openapi.json": r'"version": "(.+?)"',
}


def main():
    found = {}
    for place, pattern in PLACES.items():
        match = re.search(pattern, (ROOT / place).read_text(), re.MULTILINE)
        found[place] = match.group(1) if match else "none"
    if len(set(found.values())) > 1:
        sys.exit("\n".join(f"{place}: version {version}" for place, version in found.items()))


if __name__ == "__main__":
    main()
