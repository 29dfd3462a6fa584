#!/usr/bin/env python3
"""Puts the shared libraries that programs and modules need, and that a bare Debian 12 has not, beside them.

Usage: bundle_libraries.py FOLDER LIBRARIES [--rename]

Every ELF file below FOLDER is stripped and finds its libraries in FOLDER/LIBRARIES by a path relative to itself ($ORIGIN). With the
libraries lie libraries.tsv (file, Debian package, version, architecture) and licenses/ with the packages' own copyright files.

--rename gives each library a name with a part of its hash, as auditwheel does: in a process that has loaded another libcrypto.so.3,
such as Python's, the loader would take that one instead. The same input gives the same bytes.
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys

from shared_libraries import elf_files, loaded_libraries, read_elf

# Debian 12 has them before anything is installed: of libc6, libstdc++6, libgcc-s1 and zlib1g, which apt and dpkg need. Later
# releases of Debian have newer ones under the same names.
BASE = {
    "ld-linux-x86-64.so.2",
    "libc.so.6",
    "libdl.so.2",
    "libgcc_s.so.1",
    "libm.so.6",
    "libpthread.so.0",
    "libresolv.so.2",
    "librt.so.1",
    "libstdc++.so.6",
    "libz.so.1",
}

# In the place of a library, one of our own that says no; what it needed in turn is left out.
REPLACED = {"libicuuc.so.72": pathlib.Path(__file__).with_name("no_converters.c"), "libicudata.so.72": None}


def new_name(path, soname):
    """libnlopt_cxx.so.0 -> libnlopt_cxx-1a2b3c4d.so.0"""
    stem, ending, version = soname.partition(".so")
    return f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}{ending}{version}"


def owner(path):
    """Package, version and architecture of a file of Debian's."""
    # Debian 12 has /lib -> /usr/lib, and dpkg knows some libraries by the old path.
    real = path.resolve()
    for candidate in (real, pathlib.Path("/") / real.relative_to("/usr") if real.is_relative_to("/usr") else real):
        told = subprocess.run(["dpkg-query", "-S", candidate], capture_output=True, text=True)
        if told.returncode == 0:
            package = told.stdout.split(": ")[0]
            shown = subprocess.run(
                ["dpkg-query", "-W", "-f", "${Package}\t${Version}\t${Architecture}", package],
                check=True,
                capture_output=True,
                text=True,
            )
            return shown.stdout.split("\t")
    raise FileNotFoundError(f"{path} belongs to no package")


def patch(path, run_path, names, soname=None):
    """patchelf, once for each kind of change: 0.14 mixes their strings up where it makes several at once."""
    changes = [
        [part for name in read_elf(path).needed if name in names for part in ("--replace-needed", name, names[name])]
    ]
    if soname:
        changes.append(["--set-soname", soname])
    changes.append(["--set-rpath", run_path])
    for change in changes:
        if change:
            subprocess.run(["patchelf", *change, path], check=True)


def bundle(folder, libraries, rename=False):
    """:param libraries: folder below `folder`, made if need be"""
    own = elf_files(folder)
    target = folder / libraries
    target.mkdir(parents=True, exist_ok=True)
    found = {}
    for file in own:
        found |= {name: path for name, path in loaded_libraries(file).items() if name not in BASE}
    for name in REPLACED.keys() & found.keys():
        del found[name]
        if source := REPLACED[name]:
            subprocess.run(
                ["gcc", "-O2", "-shared", "-fPIC", f"-Wl,-soname,{name}", "-o", target / name, source], check=True
            )
    names = {name: new_name(path, name) for name, path in found.items()} if rename else {}

    table, licenses = [], target / "licenses"
    licenses.mkdir(exist_ok=True)
    for name, path in sorted(found.items()):
        copy = target / names.get(name, name)
        shutil.copyfile(path, copy)
        copy.chmod(0o644)
        patch(copy, "$ORIGIN", names, names.get(name))
        package, version, architecture = owner(path)
        shutil.copyfile(f"/usr/share/doc/{package}/copyright", licenses / f"{package}.txt")
        table.append("\t".join((copy.name, package, version, architecture)))
    (target / "libraries.tsv").write_text("".join(f"{line}\n" for line in table), encoding="utf-8")

    for file in own:
        subprocess.run(["strip", "--strip-unneeded", file], check=True)
        patch(file, f"$ORIGIN/{os.path.relpath(target, file.parent)}", names)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("libraries")
    parser.add_argument("--rename", action="store_true")
    asked = parser.parse_args()
    bundle(asked.folder, asked.libraries, asked.rename)


if __name__ == "__main__":
    sys.exit(main())
