#!/usr/bin/env python3
"""What heavy and hostile clients leave to others: how long a small closure of another address waits beside them, and how much
memory the service and its processes take; beside the same of release 0.2, into attacks.csv."""

import collections
import csv
import json
import pathlib
import socket
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/service"))

from grown_files import checkerboard, equal_faces, fans, label_maps, named, repeated_arrays  # noqa: E402
from served import SOURCE, Server, parser_of, report  # noqa: E402
from wire import post  # noqa: E402

SMALL = {"valve": "human-normal"}
OTHER = "127.0.0.2"  # the address of who is watched
REAL = SOURCE / "examples/valves/source/bodyparts3d"


def import_of(triangles):
    """Of a real valve whose chordae are to be drawn: they are closed with it."""
    leaflets = [
        named(f"{side}.obj", (REAL / f"{side}_leaflet_sheet.obj").read_bytes()) for side in ("anterior", "posterior")
    ]
    annulus = named("annulus.csv", (REAL / "annulus_centerline.csv").read_bytes())
    return {"leaflets": leaflets, "annulus": annulus, "chordae_seed": 1, "triangles": triangles}


class Attack:
    """Requests that come again and again, each from a thread of its own, until it ends; what they are answered with."""

    def __init__(self, server, path, body, clients, stays=300.0):
        self.server, self.answers, self.ended = server, collections.Counter(), threading.Event()
        text = body if isinstance(body, str) else json.dumps(body)
        self.threads = [threading.Thread(target=self.press, args=(path, text, stays)) for _ in range(clients)]

    def press(self, path, text, stays):
        while not self.ended.is_set():
            begin = time.monotonic()
            try:
                status = self.server.ask("POST", path, text, seconds=stays).status
            except TimeoutError:
                status = "left"
            late = time.monotonic() - begin > 1.0
            self.answers[f"{status} at once" if status == 503 and not late else str(status)] += 1
            if status == 503:
                self.ended.wait(1.0)

    def __enter__(self):
        for thread in self.threads:
            thread.start()
        return self

    def __exit__(self, *_):
        self.ended.set()
        for thread in self.threads:
            thread.join()


class SlowBodies(Attack):
    """Bodies that come a byte at a time, one for each thread that could read it."""

    def __init__(self, server, clients):
        super().__init__(server, "/v1/closures", "", clients)

    def press(self, path, text, stays):
        while not self.ended.is_set():
            with socket.create_connection(("127.0.0.1", self.server.port)) as connection:
                connection.sendall(post(path, b"{", Content_Length=1_000_000))
                try:
                    while not self.ended.wait(0.25):
                        connection.sendall(b" " * 8192)
                except OSError:
                    self.answers["closed"] += 1


def memory_mib(pid):
    """Of a process and all that it has started, shared pages once."""
    children = collections.defaultdict(list)
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            children[int(stat.read_text().rsplit(")", 1)[1].split()[1])].append(int(stat.parent.name))
        except OSError:  # it has ended meanwhile
            continue
    kib, waiting = 0, [pid]
    while waiting:
        process = waiting.pop()
        waiting += children[process]
        try:
            rollup = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text()
            kib += int(rollup.split("\nPss:")[1].split()[0])
        except (OSError, IndexError):
            continue
    return kib / 1024


def watch(server, attack, seconds):
    """Small closures of another address beside an attack."""
    waits, refused, most = [], 0, memory_mib(server.process.pid)
    ended = threading.Event()

    def weigh():
        nonlocal most
        while not ended.wait(0.1):
            most = max(most, memory_mib(server.process.pid))

    weighing = threading.Thread(target=weigh)
    with attack:
        weighing.start()
        time.sleep(1.0)
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            begin = time.monotonic()
            refused += server.ask("POST", "/v1/closures", SMALL, client=OTHER).status != 200
            waits.append(time.monotonic() - begin)
            time.sleep(0.2)
        ended.set()
        weighing.join()
    waits.sort()
    return {
        "small": len(waits),
        "refused": refused,
        "median_s": round(waits[len(waits) // 2], 2),
        "worst_s": round(waits[-1], 2),
        "memory_mib": round(most),
        "others": dict(attack.answers),
    }


# Median wait and memory in release 0.2, tested from outside: the longest watched where nothing was answered.
BEFORE = {
    "no attack": (0.2, 15),
    "2 closures of 4,900 vertices": (9.8, None),
    "8 closures of 4,900 vertices": (20.0, None),
    "2 imports of 20,000 triangles": (180.0, 758),
    "2 label maps of 160³ voxels, clients gone": (48.0, 2355),
    "1 label map of 128³ voxels": (None, 767),
    "1 label map of 230³ voxels": (None, 4416),
    "1 label map of 256³ voxels": (None, 5120),  # where its address space ended
    "1 preview of 7,973 files": (None, 336),
    "1 VTP file of 200 arrays": (None, 6042),
}


def attacks(server, heavy):
    """Each with who presses."""
    one_map, previews = checkerboard(160), {"files": [named("p.vtp", b"x" * 500)] * 7973}
    yield "no attack", Attack(server, "", "", 0)
    for clients in (2, 8):
        yield f"{clients} closures of 4,900 vertices", Attack(server, "/v1/closures", {"valve": heavy}, clients)
    yield "2 imports of 20,000 triangles", Attack(server, "/v1/valves:import", import_of(20_000), 2, 0.3)
    yield "2 imports of 9,000 triangles", Attack(server, "/v1/valves:import", import_of(9_000), 2)
    yield "2 label maps of 160³ voxels, clients gone", Attack(server, "/v1/valves:import", one_map, 2, 0.3)
    for side in (128, 230, 256):
        yield f"1 label map of {side}³ voxels", Attack(server, "/v1/valves:import", checkerboard(side), 1)
    yield "1 preview of 7,973 files", Attack(server, "/v1/imports:preview", previews, 1)
    yield "1 VTP file of 200 arrays", Attack(server, "/v1/valves:import", repeated_arrays(200, 30), 1)
    yield "8 comparisons of 3,800 polygons of 997 triangles", Attack(server, "/v1/comparisons", fans(3800), 8)
    yield "8 comparisons of 435,000 equal faces", Attack(server, "/v1/comparisons", equal_faces(435_000), 8)
    yield "8 comparisons of 100,000 equal faces", Attack(server, "/v1/comparisons", equal_faces(100_000), 8)
    valve = server.get("/v1/presets/human-normal")
    for formats in (["nii"], ["nrrd", "nii", "nii.gz"]):
        maps = label_maps(valve, 320, formats)
        name = f"8 exports of 320³ voxels in {len(formats)} format{'s' * (len(formats) > 1)}"
        yield name, Attack(server, "/v1/exports:files", maps, 8)
    yield "100 small closures at once", Attack(server, "/v1/closures", SMALL, 100)
    yield "100 slow bodies", SlowBodies(server, 100)


def write(figures, path):
    with path.open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["attack", "release", "wait_s", "worst_s", "refused", "memory_mib"])
        for name, now in figures.items():
            if name in BEFORE:
                wait, memory = BEFORE[name]
                table.writerow([name, "0.2", wait, "", "", memory])
            table.writerow([name, "now"] + [now[key] for key in ("median_s", "worst_s", "refused", "memory_mib")])


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--seconds", type=float, default=20.0, help="of each attack")
    parser.add_argument("--coapt", default=SOURCE / "build/release/bin/coapt", help="makes the large valve")
    parser.add_argument("--output", type=pathlib.Path, help="table: docs/figures/attacks.csv")
    options = parser.parse_args()
    figures = {}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "heavy.json"
        make = (options.coapt, "valve", "make", "human-functional-mr", "--triangles", "9000", "-o", path)
        subprocess.run(make, check=True)
        server = Server(options.server, pathlib.Path(folder) / "jobs.sqlite", "--request-seconds", 10)
        try:
            heavy = server.ask("POST", "/v1/valves", json.loads(path.read_text())).json()["id"]
            for name, attack in attacks(server, heavy):
                figures[name] = watch(server, attack, options.seconds)
                print(name, figures[name], file=sys.stderr, flush=True)
        finally:
            server.stop()
    if options.output:
        write(figures, options.output)
    beside = [figures[f"{clients} closures of 4,900 vertices"]["worst_s"] for clients in (2, 8)]
    worst = max(one["worst_s"] for one in figures.values())
    met = all(one["refused"] == 0 for one in figures.values()) and beside[0] < 1 and worst < 3
    report(
        {"program": "crowded", "attacks": figures, "met": met},
        f"beside 2 and 8 heavy clients a small closure waited {beside[0]} and {beside[1]} s at worst; "
        f"beside all attacks {worst} s",
    )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
