#!/usr/bin/env python3
"""check_includes.py [ROOT]: fails if an #include goes against the arrows of ARCHITECTURE.md."""
import os
import re
import sys
from pathlib import Path


def rows(table):
    """The table's rows: what stands before the colon, and the words after it."""
    return [(name.strip(), words.split()) for name, words in (line.split(":") for line in table.strip().splitlines())]


# Folder, then the folders whose headers it may include besides its own. A slash at the end: files right in that folder.
ARROWS = rows(
    """
core/valve       :
core/repair      : core/valve
core/closure     : core/valve
core/metrics     : core/closure core/valve
core/closed      : core/repair core/metrics core/closure core/valve
core/opened      : core/metrics core/closure core/valve
core/live        : core/closure core/valve
core/presets     : core/closure core/valve
search/          : core
search/plans     : core search/ search/fit
search/studies   : core search/ search/plans
search/fit       : core search/
search/preference : core search/ search/plans
search/training  : core search/
search/population : core search/ search/plans search/studies search/training
search/rings     : core search/ search/plans search/population
io/command_line  : core/valve
io/json          : core search
io/mesh          : core io/json
io/image         : core io/mesh
io/dicom         : core io/mesh io/image
io/exchange      : core search io/json io/mesh io/image
io/picture       : core search io/json io/mesh
io/store         : core search io/json
farm/work        : core search io
farm/ask         : core search io farm/work
farm/database    : core/valve farm/work
farm/program     : core/valve io farm/work farm/database clients/cli
server/          : core search io farm/work farm/ask server/endpoints server/jobs
server/jobs      : core search io farm/work farm/ask server/
server/endpoints : core search io server/ server/jobs
clients/cli      : core search io farm/work farm/ask
clients/engine   : core search io/json
clients/live     : core io clients/cli
clients/python   : core search io farm/ask server/ server/jobs
lab/comparators  : core
lab/rivals       : core
lab/closures     : core search io
lab/lattices     : core search io lab/rivals
lab/verdicts     : core search lab/closures
lab/twins        : core search lab/closures
lab/diseases     : core search
lab/preference   : core search
lab/charts       : core search io lab/closures
lab/farm         : core/valve io/command_line farm/database farm/work clients/cli
lab/cli          : core search io clients/cli lab
"""
)
# Pattern of what only one folder may include, then that folder.
RESERVED = rows(
    """
nlopt           : search lab/rivals
clipper[.]hpp   : core/metrics
cairo           : io/picture
httplib[.]h     : server clients/cli
CLI/            : io/command_line
nlohmann/       : io farm server clients/cli clients/engine clients/live clients/python lab
sqlite3[.]h     : io/store
libpq           : farm/database
lzma[.]h        : io/mesh
dcmtk/          : io/dicom
boost/          : clients/live
pybind11/       : clients/python
pagmo/          : lab/rivals
dlib/           : lab/rivals
"""
)
# core and the comparators are pure: no threads, clock, randomness, files or streams.
PURE = ("core", "lab/comparators")
IMPURE = (
    r"thread|mutex|atomic|future|condition_variable|chrono|ctime|time[.]h|random|filesystem|fstream|iostream|omp[.]h"
)
ROOMS = ("core", "search", "io", "farm", "server", "clients", "lab")


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
    allowed = [[folder, *others] for folder, others in ARROWS if within(file, [folder])]
    if not allowed:
        yield f"{file}: its folder has no row in cmake/check_includes.py"
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
            for pattern, owners in RESERVED:
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
