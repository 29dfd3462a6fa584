"""What goes into the bill of materials of an artefact: its files, and whose software is in it."""

import functools
import hashlib
import io
import json
import pathlib
import re
import subprocess
import tarfile
import urllib.parse
import zipfile
from dataclasses import dataclass

# Names of Debian's copyright files, which are Debian's own, in SPDX's list.
SPDX_LICENSES = {
    "apache-2.0": "Apache-2.0",
    "bsd-2-clause": "BSD-2-Clause",
    "bsd-3-clause": "BSD-3-Clause",
    "bsl-1.0": "BSL-1.0",
    "boost": "BSL-1.0",
    "boost-1.0": "BSL-1.0",
    "expat": "MIT",
    "mit": "MIT",
    "gpl-2": "GPL-2.0-only",
    "gpl-2+": "GPL-2.0-or-later",
    "gpl-3+": "GPL-3.0-or-later",
    "isc": "ISC",
    "lgpl-2+": "LGPL-2.0-or-later",
    "lgpl-2.1": "LGPL-2.1-only",
    "lgpl-2.1+": "LGPL-2.1-or-later",
    "lgpl-3+": "LGPL-3.0-or-later",
    "mpl-2": "MPL-2.0",
    "mpl-2.0": "MPL-2.0",
    "postgresql": "PostgreSQL",
    "zlib": "Zlib",
}
# Headers and static archives whose code is in our binaries, and scripts of the site; what is linked dynamically has a file of its own.
COMPILED_IN = {
    "libeigen3-dev": "engine",
    "nlohmann-json3-dev": "documents",
    "pybind11-dev": "python",
    "libcli11-dev": "programs",
    "libboost-dev": "live",
    "libc++-19-dev-wasm32": "wasm",
    "libc++abi-19-dev-wasm32": "wasm",
    "libclang-rt-19-dev-wasm32": "wasm",
    "wasi-libc": "wasm",
    "furo": "site",
    "sphinx-common": "site",
    "python3-sphinx-copybutton": "site",
    "libjs-jquery": "site",
    "libjs-underscore": "site",
}
LIBRARY_TABLE = "libraries.tsv"  # bundle_libraries.py


@dataclass(frozen=True)
class Component:
    """Somebody else's software."""

    name: str
    version: str
    license: str  # SPDX's, or NOASSERTION
    url: str  # package URL: pkg:deb/debian/libcairo2@1.16.0-7?arch=amd64
    relation: str  # of the artefact to it
    files: tuple[str, ...] = ()  # that are it


def content_of(artefact):
    """Name -> bytes, of a wheel, a tar archive or a Debian package; links and folders are left out."""
    if artefact.suffix == ".whl":
        with zipfile.ZipFile(artefact) as archive:
            return {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}
    if artefact.suffix == ".deb":
        told = subprocess.run(["dpkg-deb", "--fsys-tarfile", artefact], check=True, capture_output=True).stdout
        return _of_tar(tarfile.open(fileobj=io.BytesIO(told)))
    return _of_tar(tarfile.open(artefact))


def _of_tar(archive):
    with archive:
        return {entry.name.removeprefix("./"): archive.extractfile(entry).read() for entry in archive if entry.isfile()}


def sha1(content):
    return hashlib.sha1(content, usedforsecurity=False).hexdigest()


def verification_code(contents):
    """SPDX 2.3, 7.9: SHA-1 of the files' sorted SHA-1s."""
    return sha1("".join(sorted(map(sha1, contents))).encode())


@functools.cache
def debian_license(package):
    """Of `Files: *`, as far as a machine can read it."""
    path = pathlib.Path(f"/usr/share/doc/{package}/copyright")
    if not path.exists():
        return "NOASSERTION"
    for paragraph in path.read_text(encoding="utf-8", errors="replace").split("\n\n"):
        if re.search(r"^Files:\s*\*\s*$", paragraph, re.MULTILINE):
            named = re.search(r"^License: *(\S+)\s*$", paragraph, re.MULTILINE)
            return SPDX_LICENSES.get(named[1].lower(), "NOASSERTION") if named else "NOASSERTION"
    return "NOASSERTION"


def debian_component(package, version, architecture, relation, files=()):
    url = f"pkg:deb/debian/{package}@{urllib.parse.quote(version, safe=':')}?arch={architecture}"
    return Component(package, version, debian_license(package), url, relation, tuple(files))


def installed(package):
    """Version and architecture; None if it is not installed."""
    told = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Version}\t${Architecture}\n", package], capture_output=True, text=True
    )
    return told.stdout.splitlines()[0].split("\t") if told.returncode == 0 else None


def bundled_components(content):
    """Libraries that came along, a package each."""
    files = {}
    for name in content:
        if pathlib.PurePath(name).name == LIBRARY_TABLE:
            for line in content[name].decode().splitlines():
                file, *package = line.split("\t")
                files.setdefault(tuple(package), []).append(str(pathlib.PurePath(name).parent / file))
    return [debian_component(*package, "CONTAINS", names) for package, names in sorted(files.items())]


def compiled_components(parts):
    """:param parts: of COMPILED_IN, which of ours are in the artefact"""
    found = []
    for package, part in COMPILED_IN.items():
        if part in parts and (known := installed(package)):
            found.append(debian_component(package, *known, "CONTAINS" if part == "site" else "STATIC_LINK"))
    return found


def required_components(artefact):
    """What a Debian package asks for, without versions: they are what apt finds."""
    if artefact.suffix != ".deb":
        return []
    field = subprocess.run(
        ["dpkg-deb", "--field", artefact, "Depends"], check=True, capture_output=True, text=True
    ).stdout
    names = sorted({re.split(r"[\s(:|]", one.strip())[0] for one in field.split(",") if one.strip()})
    return [Component(name, "", debian_license(name), f"pkg:deb/debian/{name}", "DEPENDS_ON") for name in names]


def page_components(lock):
    """Packages of npm whose code is in the page: those that are not for its developers alone."""
    packages = json.loads(lock.read_text(encoding="utf-8"))["packages"]
    return [
        Component(
            name.rpartition("node_modules/")[2],
            one["version"],
            one.get("license", "NOASSERTION"),
            f"pkg:npm/{name.rpartition('node_modules/')[2].replace('@', '%40')}@{one['version']}",
            "CONTAINS",
        )
        for name, one in packages.items()
        if name and not one.get("dev")
    ]
