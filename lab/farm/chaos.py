#!/usr/bin/python3
"""A study by a farm whose workers are killed all the while: chaos.py BIN_DIRECTORY [--valves N] [--workers N] [--every SECONDS] [--against N].

Starts a private PostgreSQL, runs `coapt study generality` of the presets and of N coarse valves by its farm, and kills one worker after
the other (SIGKILL), each time starting another in its place. Then asks what the database counted, and runs the same study of the first
valves (--against) in one process: its findings must be the same, line by line. Prints JSON; a line a minute on its standard error."""

import argparse
import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/farm"))

from private_postgres import PrivatePostgres  # noqa: E402


# A farm does not ask what its closures cost: coarse meshes close five times as many.
TRIANGLES = 120


def make_valves(coapt, folder, count):
    """Files of valves that differ in annulus and papillary tips."""
    for i in range(count):
        ap, depth = 26 + 8 * i / count, 21 + 6 * (i * 0.618034 % 1)
        name = f"valve-{i:03}"
        file = folder / f"{name}.json"
        shape = (
            "--name",
            name,
            "--ap-mm",
            f"{ap:.3f}",
            "--tip-depth-mm",
            f"{depth:.3f}",
            "--triangles",
            str(TRIANGLES),
        )
        subprocess.run((coapt, "valve", "make", *shape, "-o", file), check=True, stdout=subprocess.DEVNULL)
        yield file


def findings(directory, valves):
    """Rows of findings.csv but those of given valves from number `valves` on."""
    with (directory / "findings.csv").open() as file:
        rows = list(csv.reader(file))
    kept = {f"valve-{i:03}" for i in range(valves)}
    return [row for row in rows if "given" not in row or row[1] in kept]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--valves", type=int, default=50)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--every", type=float, default=5.0, help="seconds between kills; 0: none")
    parser.add_argument("--against", type=int, default=2, help="valves of the run in one process")
    parser.add_argument("--lease", default="10")
    asked = parser.parse_args()
    postgres = PrivatePostgres()
    postgres.sql("postgres", "CREATE DATABASE farm")
    environment = {**os.environ, "COAPT_FARM": postgres.url("farm")}
    folder = pathlib.Path(tempfile.mkdtemp(prefix="chaos"))
    subprocess.run([asked.bin / "coapt-farm", "init"], env=environment, check=True)
    count = 0

    def worker():
        nonlocal count
        count += 1
        return subprocess.Popen(
            [asked.bin / "coapt-farm", "work", "--threads", "1", "--lease", asked.lease, "--name", f"worker-{count}"],
            env=environment, stderr=subprocess.DEVNULL,
        )  # fmt: skip

    def study(name, count):
        return [asked.bin / "coapt", "study", "generality", *valves[:count], "--anatomies", "0", "-o", folder / name]

    def counted():
        (items, results, lost, differing), *_ = postgres.sql(
            "farm",
            "SELECT (SELECT coalesce(sum(items), 0) FROM coapt_farm.run), (SELECT coalesce(sum(n), 0) FROM coapt_farm.result),"
            " (SELECT count(*) FROM coapt_farm.fault WHERE what = 'lost'),"
            " (SELECT count(*) FROM coapt_farm.fault WHERE what = 'differs')",
        )
        return {
            "closures": int(items),
            "answered": int(results),
            "kills": kills,
            "leases_lost": int(lost),
            "answers_that_differ": int(differing),
            "seconds": round(time.monotonic() - started),
        }

    valves = list(make_valves(asked.bin / "coapt", folder, asked.valves))
    workers = [worker() for _ in range(asked.workers)]
    started, kills, next_line = time.monotonic(), 0, 60.0
    run = subprocess.Popen(study("farm", asked.valves), env=environment, stdout=subprocess.DEVNULL)
    try:
        while run.poll() is None:
            time.sleep(asked.every or 1.0)
            if asked.every > 0:
                oldest = workers.pop(0)
                oldest.send_signal(signal.SIGKILL)
                oldest.wait()
                workers.append(worker())
                kills += 1
            if time.monotonic() - started > next_line:
                print(json.dumps(counted()), file=sys.stderr, flush=True)
                next_line += 60.0
        answer = counted()
        tasks, *_ = postgres.sql("farm", "SELECT sum(tasks) FROM coapt_farm.worker")
    finally:
        for process in workers:
            process.terminate()
            process.wait()
        postgres.remove()
    alone = {name: value for name, value in os.environ.items() if name != "COAPT_FARM"}
    subprocess.run(study("alone", asked.against), env=alone, check=True, stdout=subprocess.DEVNULL)
    same = findings(folder / "farm", asked.against) == findings(folder / "alone", asked.against)
    answer |= {
        "tasks_computed": int(tasks[0]),
        "closures_per_s": round(answer["closures"] / answer["seconds"]),
        "findings_as_in_one_process": same,
        "compared_valves": asked.against,
    }
    print(json.dumps(answer, indent=2))
    sys.exit(0 if run.returncode == 0 and same and answer["closures"] == answer["answered"] else 1)


if __name__ == "__main__":
    main()
