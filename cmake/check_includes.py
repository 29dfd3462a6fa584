#!/usr/bin/env python3
"""check_includes.py [ROOT]: fails if an #include goes against the arrows of ARCHITECTURE.md."""
import functools
import os
import re
import sys
from pathlib import Path


@functools.cache
def table(name):
    """The block ```name of ARCHITECTURE.md, where the arrows stand, as rows: what stands before the colon, and the words after it."""
    block = re.search(
        f"^```{name}\n(.*?)^```",
        (Path(__file__).resolve().parents[1] / "ARCHITECTURE.md").read_text(),
        re.MULTILINE | re.DOTALL,
    )
    lines = (line.split(":") for line in block[1].strip().splitlines())
    return [(name.strip(), words.split()) for name, words in lines]


def arrows():
    """Folder, then the folders whose headers it may include besides its own. A slash at the end: files right in that folder."""
    return table("arrows")


def reserved():
    """Pattern of the libraries that only some folders may include, then those folders."""
    return table("libraries")


# core and the comparators are pure: no threads, clock, randomness, files or streams.
PURE = ("core", "lab/comparators")
IMPURE = (
    r"thread|mutex|atomic|future|condition_variable|chrono|ctime|time[.]h|random|filesystem|fstream|iostream|omp[.]h"
)
ROOMS = ("core", "search", "io", "operations", "farm", "server", "clients", "lab")


def within(file, folders):
    return any(os.path.dirname(file) + "/" == f if f.endswith("/") else file.startswith(f + "/") for f in folders)


def sources():
    """Every source of the rooms, as (file, lines)."""
    for room in ROOMS:
        for folder, subfolders, files in os.walk(room):
            subfolders[:] = sorted(name for name in subfolders if name != "node_modules")
            for name in sorted(files):
                if name.endswith((".h", ".cpp")):
                    file = f"{folder}/{name}"
                    yield file, Path(file).read_text().splitlines()


def complaints(file, lines):
    """What is wrong with the includes of a file of these lines."""
    allowed = [[folder, *others] for folder, others in arrows() if within(file, [folder])]
    if not allowed:
        yield f"{file}: its folder has no row among the arrows of ARCHITECTURE.md"
    for number, line in enumerate(lines, 1):
        if re.search(r"#\s*pragma\s+omp", line) and file != "search/parallel.h":
            yield f"{file}:{number}: OpenMP only in search/parallel.h"
        if not re.match(r"\s*#\s*include", line):
            continue
        for own in re.findall('"([^"]+)"', line):
            for folder, *others in allowed:
                if not within(own, [folder, *others]):
                    yield f"{file}:{number}: {folder} may not include {own}"
        for library in re.findall("<([^>]+)>", line):
            for pattern, owners in reserved():
                if re.match(pattern, library) and not within(file, owners):
                    yield f"{file}:{number}: only {' '.join(owners)} may include <{library}>"
            if within(file, PURE) and re.fullmatch(IMPURE, library):
                yield f"{file}:{number}: {file.split('/')[0]} may not include <{library}>"


def main():
    os.chdir(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    wrong = [text for file, lines in sources() for text in complaints(file, lines)]
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
