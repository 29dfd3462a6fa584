#!/usr/bin/env python3
"""mutants.py put TREE FAULTS [--count N] [--seed N]: puts small faults into a copy of the repository at TREE.
mutants.py run TREE FAULTS BUILD [--landing]: which of them the programs of tests in BUILD find.

A fault is a check left out, a bound that takes one more, a sign turned round, or a one that is none, in a source of core, search,
io or server. All are compiled in at once, each behind coapt_mutant(number) of mutant.h, so that one build has all and
COAPT_MUTANT=number chooses. FAULTS is a JSON list of {number, file, kind, line (its text), at}; or, of kind "text", {number, file,
line, instead}. If it is there, `put` puts the same faults again, wherever the line stands now, so that two trees can be compared;
those without such a line are named.
`run` notes which test comes to which fault's place (reached.cpp), and runs for each fault the tests that do until one fails; if none
does, their whole programs, because what one test has made others may look at. It writes the first that fails into FAULTS. --landing:
only programs of the rooms that a change of the file affects, as `make check` chooses them.
  cmake -S TREE -B BUILD -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DCMAKE_UNITY_BUILD=ON
        -DCOAPT_UNIT_TESTS=ON -DCOAPT_PYTHON_ENGINE=OFF
"""

import argparse
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOMS = ("core", "search", "io", "server")
NAME = r"[A-Za-z_][\w.]*(?:\[[\w.]+\])?"
# Kind, what it looks like in a line, what takes its place: {n} is the fault's number.
KINDS = (
    ("check", re.compile(r"\bif \((?!const |auto |!?std::)((?:[^();]|\((?:[^()]|\([^()]*\))*\))+)\)(?= (?:return|continue|break|problems|\{))"), r"if (!coapt_mutant({n}) && (\1))"),
    ("bound", re.compile(rf"(?<![\w.\])*/%+-] )(?<![.>+:*!&-])\b({NAME}) (<|>) ({NAME}|[\d.]+)\b(?![\w(\[.:]| [-+*/%])"), r"(coapt_mutant({n}) ? (\1 \2= \3) : (\1 \2 \3))"),
    ("sign", re.compile(rf"(?<=[\w)\]] )([-+]) (?!message|text|name|static_cast)({NAME})\b(?![\w(\[.:])"), r"\1 coapt_negated({n}, \2)"),
    ("one", re.compile(r"(?<=[\w)\]] )([-+]) 1\b(?![\w.])"), r"\1 coapt_one_less({n}, 1)"),
)  # fmt: skip


def sites(tree):
    """Every place that a fault fits, by kind."""
    found = {kind: [] for kind, _, _ in KINDS}
    for room in ROOMS:
        for path in sorted((tree / room).rglob("*.cpp")):
            if "kernels" in path.parts:
                continue
            for line in path.read_text().splitlines():
                if line.lstrip().startswith(("//", "#", "for", "static_assert", "constexpr")) or '"' in line:
                    continue
                for kind, looks, _ in KINDS:
                    found[kind] += [
                        {"file": str(path.relative_to(tree)), "kind": kind, "line": line, "at": match.start()}
                        for match in looks.finditer(line)
                    ]
    return found


def chosen(tree, count, seed):
    """As many faults of each kind, at most two in one file."""
    draw, faults, used = random.Random(seed), [], {}
    by_kind = sites(tree)
    for places in by_kind.values():
        draw.shuffle(places)
    while len(faults) < count and any(by_kind.values()):
        for places in by_kind.values():
            while places and len(faults) < count:
                fault = places.pop()
                if used.get(fault["file"], 0) < 2 and fault["line"] not in [other["line"] for other in faults]:
                    used[fault["file"]] = used.get(fault["file"], 0) + 1
                    faults.append({"number": len(faults) + 1, **fault})
                    break
    return faults


def with_fault(fault):
    """The fault's line with the fault in it."""
    if fault["kind"] == "text":
        return fault["instead"].replace("{n}", str(fault["number"]))
    looks, instead = next((looks, instead) for kind, looks, instead in KINDS if kind == fault["kind"])
    match, line = looks.search(fault["line"], fault["at"]), fault["line"]
    return line[: match.start()] + match.expand(instead.replace("{n}", str(fault["number"]))) + line[match.end() :]


def put(tree, faults):
    for fault in faults:
        path = tree / fault["file"]
        holders = [path] if path.exists() and fault["line"] in path.read_text().splitlines() else []
        if not holders:  # the function has moved
            holders = [
                p
                for room in ROOMS
                for p in sorted((tree / room).rglob("*.cpp"))
                if fault["line"] in p.read_text().splitlines()
            ]
        fault["put"] = len(holders) == 1
        if not fault["put"]:
            print(f"{fault['number']}: {fault['file']}: no such line, or more than one: {fault['line'].strip()}")
            continue
        lines = holders[0].read_text().splitlines()
        lines[lines.index(fault["line"])] = with_fault(fault)
        holders[0].write_text("\n".join(lines) + "\n")

    (tree / "tests/mutants").mkdir(exist_ok=True)
    for name in ("mutant.h", "reached.cpp"):
        if not (tree / "tests/mutants" / name).exists():
            shutil.copy(pathlib.Path(__file__).parent / name, tree / "tests/mutants")
    build = (tree / "CMakeLists.txt").read_text().replace(" -Werror", "")
    build = build.replace("set(COAPT_HEADERS ", "set(COAPT_HEADERS ${CMAKE_SOURCE_DIR}/tests/mutants/mutant.h ", 1)
    before, tests = build.split("function(coapt_test ")
    tests = tests.replace("${arg_SOURCES}", "${arg_SOURCES} ${CMAKE_SOURCE_DIR}/tests/mutants/reached.cpp", 1)
    (tree / "CMakeLists.txt").write_text(before + "function(coapt_test " + tests)


def ran(program, seconds, arguments=(), **environment):
    """The first test of a program that fails; a crash or no end is one, too."""
    try:
        run = subprocess.run(
            [program, "--gtest_brief=1", "--gtest_fail_fast", *arguments],
            env={**os.environ, "OMP_NUM_THREADS": "2", **environment},
            capture_output=True,
            text=True,
            timeout=seconds,
        )
    except subprocess.TimeoutExpired:
        return "no end"
    failed = re.findall(r"^\[  FAILED  \] (\S+) ?\(", run.stdout, re.MULTILINE)
    return None if run.returncode == 0 else (failed or [f"exit {run.returncode}"])[0]


def reached(build, programs):
    """For each program its seconds, and for each of its tests the faults whose places it comes to."""
    known = build / "reached.json"
    if known.exists():
        return json.loads(known.read_text())
    found, lines = {}, build / "reached.txt"
    for program in programs:
        lines.unlink(missing_ok=True)
        begun = time.monotonic()
        failed = ran(build / "bin" / program, 900, COAPT_REACHED=str(lines))
        seconds = time.monotonic() - begun
        tests = [line.split() for line in lines.read_text().splitlines()] if lines.exists() else []
        found[program] = {
            "seconds": seconds,
            "failed": failed,
            "tests": {name: [int(n) for n in numbers] for name, *numbers in tests},
        }
        print(f"{program}: {len(tests)} tests, {seconds:.1f} s{', fails: ' + failed if failed else ''}", flush=True)
    known.write_text(json.dumps(found))
    return found


def landing_programs(build, file):
    """Programs of tests that `make check` runs if this file alone has changed."""
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "cmake"))
    from affected import affected_rooms
    from check import units_of

    units = units_of([file], affected_rooms([file])).split()
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True)
    chosen = set()
    for test in json.loads(listed.stdout)["tests"]:
        labels = next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), [])
        if set(labels) & set(units):
            chosen.add(test["name"].split(".")[0])
    return chosen


def finds(fault, build, known, programs):
    """PROGRAM: TEST, the first that finds the fault."""
    number = fault["number"]
    words = set(re.split(r"\W|_", str(pathlib.PurePath(fault["file"]).parent)))
    there = {
        program: [name for name, numbers in known[program]["tests"].items() if number in numbers]
        for program in programs
    }
    order = sorted((p for p in there if there[p]), key=lambda p: (-len(words & set(p.split("_"))), known[p]["seconds"]))
    for whole in (False, True):
        for program in order:
            filtered = [] if whole else ["--gtest_filter=" + ":".join(there[program])]
            limit = 30 + 5 * known[program]["seconds"]
            if found := ran(build / "bin" / program, limit, filtered, COAPT_MUTANT=str(number)):
                return f"{program}: {found}"
    return None if order else "not reached"


def run(faults, build, report, landing):
    programs = sorted(path.name for path in (build / "bin").iterdir() if "test" in path.name)
    known = reached(build, programs)
    for fault in (fault for fault in faults if fault["put"] and "found" not in fault):
        of_check = landing_programs(build, fault["file"]) & set(programs) if landing else programs
        fault["found"] = finds(fault, build, known, of_check)
        print(fault["number"], fault["file"], fault["kind"], fault["found"] or "NOT FOUND", flush=True)
        report.write_text(json.dumps(faults, indent=1))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("verb", choices=("put", "run"))
    arguments.add_argument("tree", type=pathlib.Path)
    arguments.add_argument("faults", type=pathlib.Path)
    arguments.add_argument("build", type=pathlib.Path, nargs="?")
    arguments.add_argument("--landing", action="store_true")
    arguments.add_argument("--count", type=int, default=60)
    arguments.add_argument("--seed", type=int, default=1)
    arguments = arguments.parse_args()
    faults = json.loads(arguments.faults.read_text()) if arguments.faults.exists() else None
    if arguments.verb == "put":
        faults = faults or chosen(arguments.tree, arguments.count, arguments.seed)
        put(arguments.tree, faults)
        arguments.faults.write_text(json.dumps(faults, indent=1))
    else:
        run(faults, arguments.build.resolve(), arguments.faults, arguments.landing)


if __name__ == "__main__":
    sys.exit(main())
