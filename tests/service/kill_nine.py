#!/usr/bin/env python3
"""Searches whose service is killed with SIGKILL at random moments and started again on the same file:
each must come to what the same search comes to undisturbed, but for times, ids and closures_known."""

import collections
import dataclasses
import http.client
import pathlib
import random
import sys
import tempfile
import threading
import time

from served import ENDED, Server, parser_of, report, search_of

# What may differ between two runs of one search.
OF_THE_RUN = {"id", "created", "started", "finished", "seconds", "closures_known", "links"}
FINALE = {"fine_levels": 1, "model_draws": 8}  # what is closed once more at the end
PRESETS = ("human-functional-mr", "human-p2-prolapse")
MOMENTS = ("running", "running twice", "starting", "near the end", "submitting")


@dataclasses.dataclass
class Search:
    request: dict
    seconds: float = 0.0  # undisturbed, from submission to end
    outcome: dict = None  # undisturbed


def without(value, names=frozenset(OF_THE_RUN)):
    """JSON without the fields of these names, wherever they are."""
    if isinstance(value, dict):
        return {name: without(inside, names) for name, inside in value.items() if name not in names}
    if isinstance(value, list):
        return [without(inside, names) for inside in value]
    return value


def difference(expected, got, path=""):
    """Where two JSON values first differ; empty if they do not."""
    if isinstance(expected, dict) and isinstance(got, dict) and expected.keys() == got.keys():
        return next(filter(None, (difference(expected[key], got[key], f"{path}/{key}") for key in expected)), "")
    if isinstance(expected, list) and isinstance(got, list) and len(expected) == len(got):
        return next(filter(None, (difference(a, b, f"{path}/{i}") for i, (a, b) in enumerate(zip(expected, got)))), "")
    return "" if expected == got else f"{path or '/'}: {str(expected)[:80]} undisturbed, {str(got)[:80]} here"


def outcome_of(server, job):
    """What a job has come to, and how many closures were known to it."""
    result = server.get(f"/v1/jobs/{job['id']}/result")
    return without(
        {
            "state": job["state"],
            "problems": job["problems"],
            "plans": job["plans"],
            "result": result,
            "closures": job["progress"]["closures"],
        }
    ), result.get("closures_known", 0)


def run_undisturbed(binary, folder, search):
    server = Server(binary, folder / "undisturbed.sqlite")
    try:
        start = time.monotonic()
        job = server.wait_for_end(server.submit(search.request)["id"])
        search.seconds = time.monotonic() - start
        search.outcome = outcome_of(server, job)[0]
    finally:
        server.stop()


def kill_after(server, seconds):
    time.sleep(seconds)
    server.kill()


def kill_and_restart(binary, folder, search, moment, chooser):
    """A difference from the undisturbed run (empty: none), the number of kills, closures known at the last start."""
    server = Server(binary, folder / "killed.sqlite")
    key = {"Idempotency-Key": "the-one"}
    job_id, kills = None, 1
    try:
        if moment == "submitting":
            killer = threading.Thread(target=kill_after, args=(server, chooser.uniform(0.0, 0.03)))
            killer.start()
            try:
                job_id = server.submit(search.request, headers=key)["id"]
            except (OSError, http.client.HTTPException):
                pass  # killed before it could answer: the job may be there or not
            killer.join()
        else:
            job_id = server.submit(search.request, headers=key)["id"]
            late = moment == "near the end"
            kill_after(server, search.seconds * (chooser.uniform(0.9, 1.02) if late else chooser.random()))
        if moment == "running twice":
            server.launch()
            server.wait_until_listening()
            kill_after(server, search.seconds * 0.3 * chooser.random())
            kills += 1
        if moment == "starting":
            for _ in range(2):
                server.launch()
                kill_after(server, chooser.uniform(0.0, 0.15))
                kills += 1
        server.launch()
        server.wait_until_listening()
        again = server.submit(search.request, headers=key)
        if job_id not in (None, again["id"]):
            return "the job that was accepted is not there", kills, 0
        job = again if again["state"] in ENDED else server.wait_for_end(again["id"])
        outcome, known = outcome_of(server, job)
        return difference(search.outcome, outcome), kills, known
    finally:
        if server.process.poll() is None:
            server.stop()


def run(binary, folder, searches, seed=1, evaluations=150, valves=PRESETS):
    """Figures of so many disturbed searches of these valves in turn, among them all that was wrong."""
    chooser = random.Random(seed)
    kinds = [
        Search({"valve": valve, "search": search_of(seed, evaluations, plans=2, region_points=17, **FINALE)})
        for seed, valve in enumerate(valves)
    ]
    for number, search in enumerate(kinds):
        (folder / f"undisturbed-{number}").mkdir()
        run_undisturbed(binary, folder / f"undisturbed-{number}", search)
    wrong, kills, known, moments = [], 0, [], collections.Counter()
    for number in range(searches):
        search, moment = kinds[number % len(kinds)], MOMENTS[number % len(MOMENTS)]
        (folder / f"killed-{number}").mkdir()
        found, its_kills, its_known = kill_and_restart(binary, folder / f"killed-{number}", search, moment, chooser)
        kills += its_kills
        known.append(its_known)
        moments[moment] += 1
        if found:
            wrong.append(f"search {number}, killed {moment}: {found}")
    return {
        "program": "kill_nine",
        "seed": seed,
        "searches": searches,
        "kills": kills,
        "moments": dict(moments),
        "undisturbed_seconds": [round(search.seconds, 1) for search in kinds],
        "closures_known": known,
        "wrong": wrong,
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--searches", type=int, default=20, help="that are killed, once to three times each")
    parser.add_argument("--seed", type=int, default=1, help="of the moments")
    parser.add_argument("--evaluations", type=int, default=150, help="of each search")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        figures = run(options.server, pathlib.Path(folder), options.searches, options.seed, options.evaluations)
    report(
        figures,
        f"{options.searches} searches, {figures['kills']} kills, {len(figures['wrong'])} with other plans; "
        f"{sum(known > 0 for known in figures['closures_known'])} went on with closures kept before",
    )
    for line in figures["wrong"]:
        print(" ", line)
    return 1 if figures["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
