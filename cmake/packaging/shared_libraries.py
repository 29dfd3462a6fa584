"""What ELF files ask of the machine that they run on, as objdump (binutils) tells it."""

import os
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

NEEDED = re.compile(r"^ +NEEDED +(\S+)$", re.MULTILINE)
SONAME = re.compile(r"^ +SONAME +(\S+)$", re.MULTILINE)
RUN_PATH = re.compile(r"^ +(?:RUNPATH|RPATH) +(\S+)$", re.MULTILINE)
FORMAT = re.compile(r"file format elf64-(\S+)")
# "    0x09691a75 0x00 09 GLIBC_2.2.5" under "Version References:"
VERSION = re.compile(r"^ +0x[0-9a-f]+ 0x[0-9a-f]+ \d+ (\S+)$", re.MULTILINE)


@dataclass
class Elf:
    """Of one file."""

    machine: str  # "x86-64", "littleaarch64"
    soname: str | None = None
    needed: list[str] = field(default_factory=list)
    run_path: list[str] = field(default_factory=list)
    versions: set[str] = field(default_factory=set)  # of symbols: "GLIBC_2.34"


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def elf_files(folder):
    """Below the folder, in the order of their names."""
    found = (path for path in pathlib.Path(folder).rglob("*") if path.is_file() and not path.is_symlink())
    return sorted(path for path in found if is_elf(path))


def read_elf(path):
    return parse_elf(_told(["objdump", "-p", path]))


def parse_elf(text):
    """:param text: of objdump -p"""
    machine = FORMAT.search(text)
    soname = SONAME.search(text)
    references = text.partition("Version References:")[2]
    return Elf(
        machine[1] if machine else "",
        soname[1] if soname else None,
        NEEDED.findall(text),
        [one for path in RUN_PATH.findall(text) for one in path.split(":")],
        set(VERSION.findall(references)),
    )


def loaded_libraries(path):
    """What the loader of this machine finds for a file, with what that needs in turn: name -> path."""
    found = {}
    for line in _told(["ldd", path]).splitlines():
        name, arrow, rest = line.strip().partition(" => ")
        if not arrow:
            continue  # the loader itself, and the kernel's library
        if rest.startswith("not found"):
            raise FileNotFoundError(f"{path} needs {name}, which is not installed")
        found[name] = pathlib.Path(rest.split(" (")[0])
    return found


def _told(command):
    return subprocess.run(command, check=True, capture_output=True, text=True, env=os.environ | {"LC_ALL": "C"}).stdout
