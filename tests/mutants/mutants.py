#!/usr/bin/env python3
"""mutants.py put TREE FAULTS [--count N] [--seed N]: puts small faults into a copy of the repository at TREE.
mutants.py run TREE FAULTS BUILD PROGRAM...: which of them programs of tests in BUILD find.

A fault is a check left out, a bound that takes one more, a sign turned round, or a one that is none, in a source of core, search,
io or server. All are compiled in at once, each behind coapt_mutant(number) of mutant.h, so that one build has all and
COAPT_MUTANT=number chooses. FAULTS is a JSON list of {number, file, kind, line (its text), at}. If it is there, `put` puts the same faults
again, wherever the line stands now, so that two trees can be compared; those without such a line are named.
`run` runs the programs for each fault until one fails (first those of the fault's own room) and writes which into FAULTS.
The copy is built with -include of mutant.h and without -Werror:
  cmake -S TREE -B BUILD -DCMAKE_CXX_FLAGS="-include TREE/tests/mutants/mutant.h -Wno-error" -DCOAPT_UNIT_TESTS=ON ...
"""

import argparse
import json
import os
import pathlib
import random
import re
import subprocess
import sys

ROOMS = ("core", "search", "io", "server")
NAME = r"[A-Za-z_][\w.]*(?:\[[\w.]+\])?"
# Kind, what it looks like in a line, what takes its place: {n} is the fault's number.
KINDS = (
    ("check", re.compile(r"\bif \((?!const |auto |!?std::)((?:[^()]|\((?:[^()]|\([^()]*\))*\))+)\)(?= (?:return|continue|break|problems|\{))"), r"if (!coapt_mutant({n}) && (\1))"),
    ("bound", re.compile(rf"(?<![\w.\])*/%+-] )(?<![.>+:*!&-])\b({NAME}) (<|>) ({NAME}|[\d.]+)\b(?![\w(\[.:]| [-+*/%])"), r"(coapt_mutant({n}) ? (\1 \2= \3) : (\1 \2 \3))"),
    ("sign", re.compile(rf"(?<=[\w)\]] )([-+]) ({NAME})\b(?![\w(\[.:])"), r"\1 coapt_negated({n}, \2)"),
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


def put(tree, faults):
    for fault in faults:
        looks, instead = next((looks, instead) for kind, looks, instead in KINDS if kind == fault["kind"])
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
        at = lines.index(fault["line"])
        match = looks.search(fault["line"], fault["at"])
        lines[at] = (
            fault["line"][: match.start()]
            + match.expand(instead.replace("{n}", str(fault["number"])))
            + fault["line"][match.end() :]
        )
        holders[0].write_text("\n".join(lines) + "\n")


def fails(program, number, seconds):
    """The tests of a program that fail with the fault; a crash or no end is one, too."""
    environment = {**os.environ, "COAPT_MUTANT": str(number), "OMP_NUM_THREADS": "2"}
    try:
        run = subprocess.run(
            [program, "--gtest_brief=1", "--gtest_fail_fast"],
            env=environment,
            capture_output=True,
            text=True,
            timeout=seconds,
        )
    except subprocess.TimeoutExpired:
        return "no end"
    failed = re.findall(r"^\[  FAILED  \] (\S+) ?\(", run.stdout, re.MULTILINE)
    return None if run.returncode == 0 else (failed or [f"exit {run.returncode}"])[0]


def run(faults, build, programs, report):
    order = [build / "bin" / program for program in programs]
    for fault in (fault for fault in faults if fault["put"] and "found" not in fault):
        words = set(re.split(r"\W|_", str(pathlib.PurePath(fault["file"]).parent)))
        order.sort(key=lambda program: -len(words & set(program.name.split("_"))))
        fault["found"] = None
        for program in order:
            if found := fails(program, fault["number"], 600):
                fault["found"] = f"{program.name}: {found}"
                break
        print(fault["number"], fault["file"], fault["kind"], fault["found"] or "NOT FOUND", flush=True)
        report.write_text(json.dumps(faults, indent=1))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("verb", choices=("put", "run"))
    arguments.add_argument("tree", type=pathlib.Path)
    arguments.add_argument("faults", type=pathlib.Path)
    arguments.add_argument("build", type=pathlib.Path, nargs="?")
    arguments.add_argument("programs", nargs="*")
    arguments.add_argument("--count", type=int, default=60)
    arguments.add_argument("--seed", type=int, default=1)
    arguments = arguments.parse_args()
    faults = json.loads(arguments.faults.read_text()) if arguments.faults.exists() else None
    if arguments.verb == "put":
        faults = faults or chosen(arguments.tree, arguments.count, arguments.seed)
        put(arguments.tree, faults)
        arguments.faults.write_text(json.dumps(faults, indent=1))
    else:
        run(faults, arguments.build, arguments.programs, arguments.faults)


if __name__ == "__main__":
    sys.exit(main())
