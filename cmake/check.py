#!/usr/bin/env python3
"""check.py [--nightly] [--since COMMIT] [--only PHASE...]: what a change must pass.

A phase is a call of make. Phases of a lane follow each other, lanes of a stage run side by side, because services and browsers
leave cores idle while they are tested. A phase is left out if nothing that it is made of differs from COMMIT, by default the
commit where the branch left origin/main; where git does not know that, none is. --nightly leaves out none and adds what takes
hours; of these `attacks` takes an hour: other clients beside each attack (4 minutes), 20,000 hostile requests (20 to 27), a
soak (8), kills at random moments (12 to 20), damaged databases (1); `chaos`, a farm whose workers are killed, 1.5 hours. What a phase prints is in build/check/PHASE.log, and is shown
if it fails. The end is a table, a line a phase:
phase, wall seconds, processor seconds, tests run.
"""

import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree
from dataclasses import dataclass

from affected import ROOT, affected_rooms, changed_files, usual_base

# What builds every program: a change of these may break all.
BUILD = ("CMakeLists.txt", "CMakePresets.json", "Makefile", "cmake/", ".ci/", "server/openapi", "io/schema/", "words/")
PRODUCT = ("core", "search", "io", "operations", "farm", "server", "clients")
LAST_LINES = 60  # of what failed
LONGEST_S = 1800  # of a phase that tests: what hangs is ended and shown, before the check as a whole is
BUILDS = {"release", "sanitizers"}  # phases that compile alone, and do not hang
NEEDED = {"packages", "release"}  # by all that comes later


@dataclass(frozen=True)
class Phase:
    """`make TARGETS`, needed where a room below `rooms` is affected or a file whose name begins with one of `paths` has changed;
    if it only compiles, a file of C++ or CMake."""

    name: str
    make: str
    rooms: tuple = ()
    paths: tuple = ()
    always: bool = False
    compiles: bool = False


def stages(units, of_service):
    """The check of a change. `units`: folders of unit tests that it may break (units_of). `of_service`: of all programs it is the
    service's alone."""
    scripts = (
        "tests/e2e",
        "tests/python",
        "tests/farm",
        "tests/kept",
        "tests/oracles",
        "tests/packages",
        "tests/slicer",
        "clients/python",
        "clients/slicer",
        "examples",
    )
    page = ("clients/web", "tests/openapi")
    node = ("clients/slicer/Coapt/CoaptLib/module.mjs", "tests/slicer/test_node.py")
    return (
        ([Phase("packages", "check-packages", always=True)],),
        (
            [Phase("layout", "format-check lint", always=True)],
            [Phase("rules", "includes-check docs-check openapi-check workflow-check commits-check", always=True)],
        ),
        # The page alone needs the programs, which its phase builds.
        ([Phase("release", "build", rooms=PRODUCT, paths=BUILD + scripts + ("tests/",))],),
        (
            [
                Phase("sources", "sources-check", PRODUCT + ("lab",), BUILD + ("tests/",), compiles=True),
                Phase(
                    "readers",
                    "readers-check",
                    rooms=("io", "clients/cli"),
                    paths=BUILD + ("tests/readers", "examples/farm"),
                ),
                Phase("page", "web-test", rooms=("server",), paths=BUILD + page),
                Phase("static", "static-test npm-test", rooms=("clients/engine",), paths=BUILD + page + node),
                Phase("live", "live-test", rooms=("clients/live",), paths=BUILD),
                Phase(
                    "scripts",
                    "scripts-test" + (" SCRIPTS=service" if of_service else ""),
                    rooms=PRODUCT,
                    paths=BUILD + scripts,
                ),
                Phase("clients", "clients-check", paths=("server/openapi", "io/schema/", "tests/clients")),
                # They hold what documents show, and nothing of the engine that no other test holds.
                Phase("examples", "examples-test", paths=("clients/python", "tests/python", "examples/python")),
                Phase("laboratory", "lab-test", rooms=("lab",), paths=BUILD + ("tests/lab", "lab/")),
            ],
            [
                Phase("model", f"model-test UNITS='{units}'", ("core", "search"), BUILD + ("tests/",), compiles=True),
                Phase(
                    "sanitizers",
                    f"asan-build ASAN=asan-outer UNITS='{units}'",
                    PRODUCT,
                    BUILD + ("tests/",),
                    compiles=True,
                ),
                Phase(
                    "units", f"asan-test ASAN=asan-outer UNITS='{units}'", PRODUCT, BUILD + ("tests/",), compiles=True
                ),
            ],
        ),
    )


NIGHTLY = (
    Phase("asan", "asan"),
    Phase("optimised", "optimised-test"),
    Phase("sources-all", "sources-check SINCE=all"),
    Phase("golden", "golden"),
    Phase("clang", "clang"),
    Phase("fuzz", "fuzz FUZZ_LIMIT=-max_total_time=600"),
    Phase("attacks", "attacks"),
    Phase("chaos", "farm-chaos"),
    Phase("arm64", "arm64"),
    Phase("gallery", "gallery"),
    Phase("documents", "docs"),
    Phase("figures", "figures-check"),
    Phase("tutorials", "tutorials-check"),
    Phase("wheel", "wheel"),
    Phase("tarball", "tarball"),
    Phase("archives", "archives-test"),
    Phase("debs", "deb deb-test"),
)


def needed(phase, files, rooms):
    """Whether a change of `files` (None: any) in `rooms` may break what the phase looks at."""
    if phase.always or files is None:
        return True
    within = any(room == place or room.startswith(place + "/") for room in rooms for place in phase.rooms)
    ends = (".cpp", ".h", ".inl", ".cmake", "CMakeLists.txt", "CMakePresets.json", "Makefile") if phase.compiles else ""
    return within or any(
        name.startswith(phase.paths) and name.endswith(ends) and not name.endswith(".md") for name in files
    )


def units_of(files, rooms):
    """Folders below tests/ of the unit tests of `rooms` and of those that changed themselves; "all", or "none" of them."""
    if files is None or any(name.startswith((*BUILD, "tests/scenes")) for name in files):
        return "all"
    folders = {str(at.parent.relative_to("tests")) for at in pathlib.Path("tests").rglob("CMakeLists.txt")}
    folders -= {".", "lab", "fuzz", "scenes", "e2e", "oracles", "python", "slicer", "packages"}
    changed = {folder for folder in folders for name in files if name.startswith(f"tests/{folder}/")}
    of_rooms = {folder for folder in folders if any(f"{room}/".startswith(f"{folder}/") for room in rooms)}
    return " ".join(sorted(changed | of_rooms)) or "none"


def of_service(files, rooms):
    """Whether no program but the service is made of `files` in `rooms`: those of the server, Python's client, which runs it, and the
    page's source and its tests."""
    served = {room for room in rooms if f"{room}/".startswith("server/")}
    return (
        bool(served)
        and rooms <= served | {"clients/python"}
        and all(
            name.startswith(("server/", "tests/server/", "clients/web/", "docs/"))
            and not name.startswith(BUILD)
            or name.endswith(".md")
            for name in files
        )
    )


# Lines by which programs of tests tell how many they ran.
COUNTS = (
    r"tests failed out of (\d+)",
    r"^ℹ tests (\d+)",
    r"^ +Tests +(?:\d+ failed \| )?(\d+) passed",
    r"^Ran (\d+) tests? in",
)


def tests_run(log, begun):
    """Tests that a log counts; ctest counts each program of unit tests once, whose report then counts what is in it."""
    found = sum(int(number) for pattern in COUNTS for number in re.findall(pattern, log, re.MULTILINE))
    for report in pathlib.Path("build").glob("*/reports/*.xml"):
        if report.stat().st_mtime >= begun:
            suite = xml.etree.ElementTree.parse(report).getroot()
            found += int(suite.get("tests")) - int(suite.get("disabled", 0)) - 1
    return found


class Run:
    """Phases as they end. One that fails ends what cannot go without it, and no more: a check tells all that is wrong."""

    def __init__(self, longest_s):
        self.longest_s, self.running, self.stopped = longest_s, set(), False
        self.rows, self.endings, self.failed, self.printing = [], [], [], threading.Lock()

    def say(self, text):
        with self.printing:
            print(text, flush=True)

    def phase(self, phase):
        log = pathlib.Path("build/check") / f"{phase.name}.log"
        self.say(f"{phase.name}: make {phase.make}")
        begun, started = time.time(), time.monotonic()
        with log.open("w") as output:
            make = subprocess.Popen(
                # Jobs of a service are niced: beside a compiler of full weight a script waits ten times as long for them.
                f"{'nice -n 19 ' if phase.compiles else ''}make {phase.make}",
                shell=True,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
            self.running.add(make.pid)
            longest_s = threading.TIMEOUT_MAX if phase.name in BUILDS else self.longest_s
            limit = threading.Timer(longest_s, os.killpg, (make.pid, signal.SIGKILL))
            limit.start()
            _, status, used = os.wait4(make.pid, 0)
            limit.cancel()
            self.running.discard(make.pid)
            make.returncode = os.waitstatus_to_exitcode(status)
        text = log.read_text(errors="replace")
        if make.returncode == -signal.SIGKILL:
            text += (
                f"\nended after {time.monotonic() - started:.0f} s, of {self.longest_s:.0f} s that a phase may take\n"
            )
        row = (phase.name, time.monotonic() - started, used.ru_utime + used.ru_stime, tests_run(text, begun))
        self.rows.append(row)
        if make.returncode == 0:
            self.say("{}: passed, {:.0f} s".format(*row))
        else:
            self.failed.append(phase.name)
            self.endings.append(
                "\n".join([f"{phase.name}, the last lines of {log}:", *text.splitlines()[-LAST_LINES:]])
            )
            self.say(f"{text}\n{phase.name}: FAILED ({log})")

    def stop(self):
        self.stopped = True
        for group in list(self.running):
            os.killpg(group, signal.SIGTERM)

    def lane(self, phases):
        for phase in phases:
            if not self.stopped:
                self.phase(phase)

    def stage(self, lanes):
        threads = [threading.Thread(target=self.lane, args=(phases,), daemon=True) for phases in lanes]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def table(self):
        print(f"\n{'phase':<12} {'wall_s':>7} {'cpu_s':>7} {'tests':>6}")
        for row in self.rows:
            print("{:<12} {:>7.0f} {:>7.0f} {:>6}".format(*row))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--nightly", action="store_true")
    arguments.add_argument("--since", metavar="COMMIT")
    arguments.add_argument("--only", nargs="+", default=[], metavar="PHASE")
    arguments = arguments.parse_args()
    os.chdir(ROOT)
    pathlib.Path("build/check").mkdir(parents=True, exist_ok=True)

    files = None if arguments.nightly else changed_files(arguments.since or usual_base())
    rooms = affected_rooms(files or [])
    plan = [[list(lane) for lane in stage] for stage in stages(units_of(files, rooms), of_service(files, rooms))]
    if arguments.nightly:
        plan.append([list(NIGHTLY)])

    def chosen(phase):
        return phase.name in arguments.only if arguments.only else needed(phase, files, rooms)

    if left_out := [p.name for stage in plan for lane in stage for p in lane if not chosen(p)]:
        print(f"left out, because nothing that they are made of has changed: {' '.join(left_out)}")

    run, started = Run(threading.TIMEOUT_MAX if arguments.nightly else LONGEST_S), time.monotonic()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        for stage in plan:
            run.stage([[phase for phase in lane if chosen(phase)] for lane in stage])
            if NEEDED & set(run.failed):
                break
    except KeyboardInterrupt:
        run.stop()
        return 130
    # Again, because a long output may be cut in front.
    for ending in run.endings:
        print(f"\n{ending}")
    run.table()
    tests = sum(row[3] for row in run.rows)
    print(
        "{:<12} {:>7.0f} {:>7.0f} {:>6}".format(
            "all", time.monotonic() - started, sum(row[2] for row in run.rows), tests
        )
    )
    # Counts for whoever reads the last line alone.
    print(f"\nFAILED: {' '.join(run.failed)}" if run.failed else f"\n{tests} passed, 0 failed")
    return int(bool(run.failed))


if __name__ == "__main__":
    sys.exit(main())
