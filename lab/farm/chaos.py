#!/usr/bin/python3
"""Studies by a farm whose workers are killed all the while: chaos.py BIN_DIRECTORY [--valves N] [--workers N] [--every SECONDS] [--against N].

Starts a private PostgreSQL, runs `coapt study approximation` of N coarse valves by its farm, four at a time (some 7,900 closures each),
and kills one worker after the other (SIGKILL), each time starting another in its place. Then asks what the database counted, and runs
the studies of the first valves (--against) without a farm: their tables must be the same to the byte. Prints JSON; a line a minute on
its standard error."""

import argparse
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
AT_ONCE = 4  # while one study waits for a lost task, the others go on
TABLES = ("approximation.csv", "anchors.csv", "anchor-scan.csv", "findings.json")


def make_valves(coapt, folder, count):
    """Files of valves that differ in annulus and papillary tips."""
    for i in range(count):
        ap, depth = 26 + 8 * i / count, 21 + 6 * (i * 0.618034 % 1)
        name = f"valve-{i:03}"
        shape = ("--ap-mm", f"{ap:.3f}", "--tip-depth-mm", f"{depth:.3f}", "--triangles", str(TRIANGLES))
        file = folder / f"{name}.json"
        subprocess.run(
            (coapt, "valve", "make", "--name", name, *shape, "-o", file), check=True, stdout=subprocess.DEVNULL
        )
        yield file


class Workers:
    """The oldest one is killed, and another one takes its place."""

    def __init__(self, command, environment, count):
        self.command, self.environment, self.kills, self.begun = command, environment, 0, 0
        self.running = [self.begin() for _ in range(count)]

    def begin(self):
        self.begun += 1
        command = [*self.command, "--name", f"worker-{self.begun}"]
        return subprocess.Popen(command, env=self.environment, stderr=subprocess.DEVNULL)

    def kill_oldest(self):
        oldest = self.running.pop(0)
        oldest.send_signal(signal.SIGKILL)
        oldest.wait()
        self.running.append(self.begin())
        self.kills += 1

    def end(self):
        for process in self.running:
            process.terminate()
            process.wait()


def counted(postgres):
    (closures, answered, lost, differing, tasks), *_ = postgres.sql(
        "farm",
        "SELECT (SELECT coalesce(sum(items), 0) FROM coapt_farm.run), (SELECT coalesce(sum(n), 0) FROM coapt_farm.result),"
        " (SELECT count(*) FROM coapt_farm.fault WHERE what = 'lost'),"
        " (SELECT count(*) FROM coapt_farm.fault WHERE what <> 'lost'),"
        " (SELECT coalesce(sum(tasks), 0) FROM coapt_farm.worker)",
    )
    return {
        "closures": int(closures),
        "answered": int(answered),
        "tasks_computed": int(tasks),
        "leases_lost": int(lost),
        "other_faults": int(differing),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--valves", type=int, default=8)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--every", type=float, default=5.0, help="seconds between kills")
    parser.add_argument("--against", type=int, default=2, help="valves that are studied without a farm, too")
    parser.add_argument("--lease", default="10")
    asked = parser.parse_args()
    postgres = PrivatePostgres()
    postgres.sql("postgres", "CREATE DATABASE farm")
    alone = {name: value for name, value in os.environ.items() if name != "COAPT_FARM"}
    environment = {**alone, "COAPT_FARM": postgres.url("farm")}
    folder = pathlib.Path(tempfile.mkdtemp(prefix="chaos"))
    subprocess.run([asked.bin / "coapt-farm", "init"], env=environment, check=True)

    def study(valve, name):
        return [asked.bin / "coapt", "study", "approximation", valve, "-o", folder / name / valve.stem]

    valves = list(make_valves(asked.bin / "coapt", folder, asked.valves))
    workers = Workers(
        [asked.bin / "coapt-farm", "work", "--threads", "1", "--lease", asked.lease], environment, asked.workers
    )
    waiting, studies, failed = list(valves), [], 0
    started = told = time.monotonic()
    try:
        while waiting or studies:
            while waiting and len(studies) < AT_ONCE:
                command = study(waiting.pop(0), "farm")
                studies.append(subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL))
            time.sleep(asked.every)
            workers.kill_oldest()
            failed += sum(run.poll() not in (None, 0) for run in studies)
            studies = [run for run in studies if run.poll() is None]
            if time.monotonic() - told > 60:
                told = time.monotonic()
                print(json.dumps({"seconds": round(told - started), **counted(postgres)}), file=sys.stderr, flush=True)
        seconds = time.monotonic() - started
        answer = counted(postgres)
    finally:
        for run in studies:
            run.terminate()
        workers.end()
        postgres.remove()
    same = True
    for valve in valves[: asked.against]:
        subprocess.run(study(valve, "alone"), env=alone, check=True, stdout=subprocess.DEVNULL)
        for table in TABLES:
            there, here = (folder / name / valve.stem / table for name in ("farm", "alone"))
            same = same and there.read_bytes() == here.read_bytes()
    answer |= {
        "kills": workers.kills,
        "studies_failed": failed,
        "seconds": round(seconds),
        "closures_per_s": round(answer["closures"] / seconds),
        "tables_as_without_a_farm": same,
        "compared_valves": asked.against,
    }
    print(json.dumps(answer, indent=2))
    sys.exit(0 if same and failed == 0 and answer["closures"] == answer["answered"] else 1)


if __name__ == "__main__":
    main()
