#!/usr/bin/env python3
"""check_sources.py BUILD [SINCE]: compiles sources each by itself, without code generation.

The build puts sixteen sources into one and reads headers beforehand, so it sees no forgotten include. BUILD is a configured
build without either. Checked are the sources that differ from the commit SINCE and those that include a header that does;
all, if git does not know SINCE. By default SINCE is where the branch left origin/main, or the last commit on it, and of
those that only include what differs no more than MOST are checked: one takes 4 to 9 seconds of a core.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

from affected import ROOT, git, usual_base

MOST = 24


def includers(changed):
    """`changed` and every file that includes one of them, directly or not."""
    includes = {}
    for name in git("ls-files", "*.h", "*.cpp", "*.inl"):
        for header in re.findall(r'^\s*#\s*include\s+"([^"]+)"', (ROOT / name).read_text(), re.MULTILINE):
            beside = str(pathlib.Path(name).parent / header)
            includes.setdefault(beside if (ROOT / beside).exists() else header, []).append(name)
    reached, waiting = set(), list(changed)
    while waiting:
        name = waiting.pop()
        if name not in reached:
            reached.add(name)
            waiting += includes.get(name, [])
    return reached


def compile_alone(entry):
    command = re.sub(r" -o \S+ -c ", " -fsyntax-only ", entry["command"])
    return subprocess.run(command, shell=True, cwd=entry["directory"], capture_output=True, text=True)


def main():
    build = pathlib.Path(sys.argv[1])
    entries = {
        str(pathlib.Path(entry["file"]).relative_to(ROOT)): entry
        for entry in json.loads((build / "compile_commands.json").read_text())
        if pathlib.Path(entry["file"]).is_relative_to(ROOT) and "/build/" not in entry["file"]
    }
    asked = len(sys.argv) > 2
    since = sys.argv[2] if asked else usual_base() or "HEAD~1"
    if git("cat-file", "-t", since) == ["commit"]:
        changed = git("diff", "--name-only", "--diff-filter=d", since)
        reached = includers(changed)
        including = [name for name in entries if name in reached and name not in changed]
        checked = {*changed, *(including if asked else including[:MOST])}
        entries = {name: entry for name, entry in entries.items() if name in checked}
        if len(including) > MOST and not asked:
            print(
                f"{len(including) - MOST} sources that include what has changed are left out; SINCE={since} checks all"
            )
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, run in zip(entries, pool.map(compile_alone, entries.values())):
            if run.returncode != 0:
                failed += 1
                print(f"{name} does not compile by itself:\n{run.stderr}", file=sys.stderr)
    print(f"{len(entries)} sources compiled by themselves, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
