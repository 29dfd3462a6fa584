"""The rules of manylinux_2_36 for x86-64: what a wheel may ask of the machine that it is installed on.

PEP 600 says that such a wheel runs on every Linux whose glibc is 2.36 or newer, and leaves the rest to auditwheel, whose list for
manylinux_2_36 (github.com/pypa/auditwheel, src/auditwheel/policy/manylinux-policy.json, version of 2025) stands below. 2.36 is Debian
12's own glibc. Not looked for: symbols of zlib that are meant for itself alone.
"""

import pathlib

from shared_libraries import elf_files, read_elf

TAG = "manylinux_2_36_x86_64"
ALLOWED_LIBRARIES = {
    "ld-linux-x86-64.so.2",  # auditwheel takes the loader for granted
    "libatomic.so.1",
    "libgcc_s.so.1",
    "libstdc++.so.6",
    "libm.so.6",
    "libmvec.so.1",
    "libanl.so.1",
    "libdl.so.2",
    "librt.so.1",
    "libc.so.6",
    "libnsl.so.1",
    "libutil.so.1",
    "libpthread.so.0",
    "libX11.so.6",
    "libXext.so.6",
    "libXrender.so.1",
    "libICE.so.6",
    "libSM.so.6",
    "libGL.so.1",
    "libgobject-2.0.so.0",
    "libgthread-2.0.so.0",
    "libglib-2.0.so.0",
    "libresolv.so.2",
    "libexpat.so.1",
    "libz.so.1",
}
NEWEST = {"GLIBC": "2.36", "GLIBCXX": "3.4.30", "CXXABI": "1.3.13", "GCC": "12.0.0", "ZLIB": "1.2.12"}
OTHER_VERSIONS = {"GLIBC_ABI_DT_RELR", "CXXABI_FLOAT128", "CXXABI_TM_1"}


def _number(version):
    return tuple(int(part) for part in version.split("."))


def too_new(version):
    """Whether the symbols' version is one that a library of the list need not have."""
    name, _, number = version.partition("_")
    if name not in NEWEST or version in OTHER_VERSIONS:
        return False
    return not all(part.isdigit() for part in number.split(".")) or _number(number) > _number(NEWEST[name])


def problems_of(path, elf, bundled):
    """:param bundled: names of libraries that come along, a file of which may ask for anything"""
    problems = []
    if elf.machine != "x86-64":
        problems.append(f"{path}: is for {elf.machine}, not x86-64")
    for name in elf.needed:
        if name.startswith("libpython"):
            problems.append(f"{path}: is linked against {name}, which not every Python has")
        elif name not in ALLOWED_LIBRARIES and name not in bundled:
            problems.append(f"{path}: needs {name}, which is neither in the wheel nor allowed")
    for version in sorted(filter(too_new, elf.versions)):
        problems.append(f"{path}: needs symbols of {version}, newer than {TAG} allows")
    for folder in elf.run_path:
        if not folder.startswith("$ORIGIN"):
            problems.append(f"{path}: looks for libraries in {folder}, outside the wheel")
    if bundled & set(elf.needed) and not elf.run_path:
        problems.append(f"{path}: does not say where its libraries are")
    return problems


def folder_problems(folder):
    """What speaks against the tag, for a wheel of these files."""
    folder = pathlib.Path(folder)
    files = {path: read_elf(path) for path in elf_files(folder)}
    bundled = {elf.soname for elf in files.values() if elf.soname}
    return [one for path, elf in files.items() for one in problems_of(path.relative_to(folder), elf, bundled)]
