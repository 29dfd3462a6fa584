#!/usr/bin/env python3
"""A service on databases with bytes of them replaced, zeroed or cut off: it starts and answers, or says what is wrong and ends;
it never crashes, and what it answers is never more than what was stored."""

import pathlib
import random
import shutil
import sys
import tempfile

from served import Server, parser_of, report, search_of

PRESET = "human-functional-mr"
READS = ("/healthz/live", "/healthz/ready", "/metrics", "/v1/valves", "/v1/jobs", "/v1/kept-plans")
REFUSED = (1, 2)  # exit codes: a database that cannot be used, bad usage


def stored(binary, folder):
    """A database with a valve, a job and its closures, killed, so that its journals are there, too; the ids in it."""
    server = Server(binary, folder / "jobs.sqlite")
    valve = server.ask("POST", "/v1/valves", server.get(f"/v1/presets/{PRESET}")).json()["id"]
    job = server.submit({"valve": valve, "search": search_of(1)})["id"]
    server.wait_for_end(job)
    server.kill()
    return valve, job


def damage(path, chooser):
    """Says what was done."""
    content = bytearray(path.read_bytes())
    kind = chooser.choice(["bytes", "bytes", "page", "head", "cut"])
    if kind == "cut":
        del content[chooser.randrange(len(content)) :]
    elif kind == "page":
        at = 4096 * chooser.randrange(max(1, len(content) // 4096))
        content[at : at + 4096] = bytes(len(content[at : at + 4096]))
    else:
        within = len(content) if kind == "bytes" else min(100, len(content))
        for _ in range(chooser.choice([1, 8, 64])):
            content[chooser.randrange(within)] = chooser.randrange(256)
    path.write_bytes(content)
    return f"{path.name}: {kind}"


def asked(server, paths):
    """What a service that listens answers wrongly; empty: nothing."""
    for path in paths:
        reply = server.ask("GET", path)
        # A lost end of the journal makes the job unfinished again (409); a list that cannot be read says so (500).
        if reply.status not in (200, 404, 409, 500, 503):
            return f"GET {path} is {reply.status}"
    closure = server.ask("POST", "/v1/closures", {"valve": PRESET})
    if closure.status != 200:
        return f"a closure is {closure.status}: {closure.body[:200]!r}"
    code = server.stop()
    return f"exit code {code}" if code else ""


def examine(server, folder, ids, seed):
    """What was done, what came of it ("serves" or "refuses"), and what was wrong, empty if nothing."""
    chooser, copy = random.Random(seed), folder / f"damaged-{seed}"
    shutil.copytree(folder / "stored", copy)
    files = sorted(
        path for path in copy.glob("jobs.sqlite*") if path.stat().st_size and not path.name.endswith("-token")
    )
    done = damage(chooser.choice(files), chooser)
    server.db, server.messages = copy / "jobs.sqlite", copy / "jobs.log"
    server.launch()
    try:
        server.wait_until_listening()
    except RuntimeError as error:
        code, said = server.process.returncode, server.messages.read_text(errors="replace")
        fine = code in REFUSED and said.startswith("coapt-server: ")
        return done, "refuses", "" if fine else f"exit code {code}: {error}"
    try:
        valve, job = ids
        wrong = asked(server, (*READS, f"/v1/valves/{valve}", f"/v1/jobs/{job}", f"/v1/jobs/{job}/result"))
    except OSError as error:
        wrong = f"{type(error).__name__}: {error}"
    if server.process.poll() is None:
        server.kill()
    return done, "serves", wrong


def run(binary, folder, seeds):
    (folder / "stored").mkdir()
    ids = stored(binary, folder / "stored")
    server = Server(binary, folder / "first.sqlite")
    server.stop()
    found = [(seed, *examine(server, folder, ids, seed)) for seed in seeds]
    return {
        "program": "damaged_databases",
        "databases": len(found),
        "serves": sum(came == "serves" for _, _, came, _ in found),
        "wrong": [f"seed {seed}, {done}: {wrong}" for seed, done, _, wrong in found if wrong],
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--seeds", type=int, default=40)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        figures = run(options.server, pathlib.Path(folder), range(options.seeds))
    report(
        figures, f"{figures['databases']} damaged databases, {figures['serves']} served, {len(figures['wrong'])} wrong"
    )
    for line in figures["wrong"]:
        print(" ", line)
    return 1 if figures["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
