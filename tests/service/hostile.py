#!/usr/bin/env python3
"""Good, bad and hostile requests in a fixed random order against a service of one's own: each must get
the answer that its kind allows, no job may be lost, and memory and open files must stay flat: spread over minutes, a soak."""

import collections
import pathlib
import queue
import random
import statistics
import sys
import tempfile
import threading
import time

import bad_requests as bad
import good_requests as good
from served import Server, parser_of, report, search_of
from wire import Wrong

# How often each kind comes, in a thousand or so.
KINDS = {
    good.closure: 100,
    good.evaluation: 15,
    good.search: 15,
    good.search_twice: 5,
    good.study_cancelled: 3,
    good.poll: 120,
    good.list_jobs: 40,
    good.result: 60,
    good.cancel: 15,
    good.delete: 15,
    good.follow: 40,
    good.valves: 20,
    good.kept_plans: 20,
    good.valve_import: 10,
    good.other_answers: 20,
    good.small_reads: 60,
    bad.no_json: 60,
    bad.wrong_shape: 60,
    bad.damaged_valve: 40,
    bad.large_body: 10,
    bad.wrong_length: 20,
    bad.no_length: 10,
    bad.bad_chunks: 25,
    bad.odd_chunks: 5,
    bad.truncated_body: 20,
    bad.two_lengths: 20,
    bad.pipelined: 20,
    bad.header_bomb: 15,
    bad.odd_path: 50,
    bad.wrong_method: 30,
    bad.wrong_type: 20,
    bad.foreign: 30,
    bad.no_http: 20,
    bad.slow_headers: 3,
    bad.slow_body: 3,
    bad.half_closed: 10,
    bad.abandoned: 40,
    bad.expects_continue: 5,
}


def schedule(count, seed):
    """(kind, seed) of each request: every kind once, if there is room, then by their weights."""
    chooser = random.Random(seed)
    kinds = list(KINDS)
    chooser.shuffle(kinds)
    kinds = (kinds + chooser.choices(list(KINDS), KINDS.values(), k=count))[:count]
    return [(kind, chooser.getrandbits(64)) for kind in kinds]


class Memory:
    """Resident memory of the server and how many files it has open, twice a second."""

    def __init__(self, server):
        self.server, self.samples, self.ended = server, [], threading.Event()
        self.start = time.monotonic()
        self.thread = threading.Thread(target=self.watch)
        self.thread.start()

    def watch(self):
        while not self.ended.wait(0.5):
            try:
                now = time.monotonic() - self.start
                self.samples.append((now, self.server.resident_mib(), self.server.open_files()))
            except (OSError, AttributeError):  # it has gone: the requests will tell
                return

    def thirds(self):
        """Medians of the first and of the last third of the time: MiB, then open files."""
        self.ended.set()
        self.thread.join()
        third = max(1, len(self.samples) // 3)
        parts = self.samples[:third], self.samples[-third:]
        return [[statistics.median(sample[column] for sample in part) for part in parts] for column in (1, 2)]

    def write(self, path):
        """As CSV."""
        lines = ["seconds,resident_mib"] + [f"{seconds:.1f},{mib:.1f}" for seconds, mib, _ in self.samples]
        path.write_text("\n".join(lines) + "\n")


def metric(server, name):
    """A metric without labels; none if there is none of this name."""
    for line in server.ask("GET", "/metrics").body.decode().splitlines():
        if line.startswith(name + " "):
            return float(line.split()[1])
    return None


def run(server, requests, seconds, seed, at_once=8):
    """Sends all, spread over `seconds`. How often each kind got what, and what was wrong."""
    world = good.World(server.port)
    world.keep(server.submit({"valve": good.PRESET, "search": search_of(seed)}))
    waiting, outcomes, wrong = queue.Queue(), collections.defaultdict(collections.Counter), []
    for index, (kind, its_seed) in enumerate(schedule(requests, seed)):
        waiting.put((index, kind, its_seed))
    start, lock = time.monotonic(), threading.Lock()

    def work():
        while True:
            try:
                index, kind, its_seed = waiting.get_nowait()
            except queue.Empty:
                return
            time.sleep(max(0.0, start + seconds * index / requests - time.monotonic()))
            try:
                outcome = kind(world, random.Random(its_seed))
            except Exception as error:  # whatever it is, it is a finding and not the end of the run
                outcome = "wrong"
                with lock:
                    wrong.append(f"request {index}, {kind.__name__}: {type(error).__name__}: {error}")
            with lock:
                outcomes[kind.__name__][outcome] += 1

    workers = [threading.Thread(target=work) for _ in range(at_once)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return world, outcomes, wrong


def examine(server, requests, seconds, seed, curve=None):
    """Figures of a run, among them all that was wrong; memory over time goes into the file `curve`."""
    memory = Memory(server)
    start = time.monotonic()
    try:
        world, outcomes, wrong = run(server, requests, seconds, seed)
        took = time.monotonic() - start
    finally:
        (first_mib, last_mib), open_files = memory.thirds()
        if curve:
            memory.write(curve)
    jobs = []
    try:
        jobs = good.ended_jobs(world, seconds=120)
    except Wrong as error:
        wrong.append(f"at the end: {error}")
    ready = server.ask("GET", "/healthz/ready").status
    if ready != 200:
        wrong.append(f"at the end: /healthz/ready is {ready}")
    own = metric(server, "process_resident_memory_bytes")
    return {
        "program": "hostile",
        "seed": seed,
        "requests": requests,
        "seconds": round(took, 1),
        "outcomes": {kind: dict(sorted(counts.items())) for kind, counts in sorted(outcomes.items())},
        "jobs_at_end": len(jobs),
        "jobs_deleted": len(world.deleted),
        "first_third_mib": round(first_mib, 1),
        "last_third_mib": round(last_mib, 1),
        "open_files": open_files,
        "metrics_mib": own and round(own / (1 << 20), 1),
        "wrong": wrong,
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--requests", type=int, default=10_000)
    parser.add_argument("--seconds", type=float, default=1800.0, help="that the requests are spread over")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--growth-mib",
        type=float,
        default=16.0,
        help="by how much memory may grow from the first third of the time to the last",
    )
    parser.add_argument("--growth-files", type=float, default=16.0, help="likewise, of the files that it has open")
    parser.add_argument("--curve", type=pathlib.Path, help="CSV of memory over time")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        server = Server(options.server, pathlib.Path(folder) / "jobs.sqlite")
        try:
            figures = examine(server, options.requests, options.seconds, options.seed, options.curve)
            code = server.stop()
            if code != 0:
                figures["wrong"].append(f"exit code {code}")
        finally:
            server.kill()
    growth = figures["last_third_mib"] - figures["first_third_mib"]
    more_files = figures["open_files"][1] - figures["open_files"][0]
    figures["met"] = not figures["wrong"] and growth <= options.growth_mib and more_files <= options.growth_files
    report(
        figures,
        f"{options.requests} requests in {figures['seconds']} s, {len(figures['wrong'])} wrong; "
        f"{figures['jobs_at_end']} jobs kept, {figures['jobs_deleted']} deleted; memory "
        f"{figures['first_third_mib']} -> {figures['last_third_mib']} MiB (target: +{options.growth_mib} at most), "
        f"open files {figures['open_files'][0]:.0f} -> {figures['open_files'][1]:.0f}",
    )
    for line in figures["wrong"][:20]:
        print(" ", line)
    return 0 if figures["met"] else 1


if __name__ == "__main__":
    sys.exit(main())
