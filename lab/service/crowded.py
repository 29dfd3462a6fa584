#!/usr/bin/env python3
"""How long a small closure waits beside clients that close valves of 4,900 vertices, one after the other, and what those get."""

import collections
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/service"))

from served import Server, parser_of, percentile, report  # noqa: E402


def beside(server, heavy, clients, seconds, small):
    """Seconds of each small closure and what the heavy ones were answered with, while so many clients send them."""
    ended = threading.Event()
    answers, lock = collections.Counter(), threading.Lock()

    def press():
        while not ended.is_set():
            begin = time.monotonic()
            status = server.ask("POST", "/v1/closures", heavy).status
            with lock:
                answers[status if time.monotonic() - begin > 1.0 or status == 200 else f"{status} at once"] += 1
            if status == 503:
                ended.wait(1.0)

    threads = [threading.Thread(target=press) for _ in range(clients)]
    for thread in threads:
        thread.start()
    time.sleep(2.0)
    waits, refused, until = [], 0, time.monotonic() + seconds
    while time.monotonic() < until:
        begin = time.monotonic()
        refused += server.ask("POST", "/v1/closures", {"valve": small}).status != 200
        waits.append(time.monotonic() - begin)
        time.sleep(0.2)
    ended.set()
    for thread in threads:
        thread.join()
    return {
        "clients": clients,
        "small": len(waits),
        "refused": refused,
        "median_s": round(percentile(waits, 50), 2),
        "worst_s": round(max(waits), 2),
        "heavy": {str(status): count for status, count in answers.items()},
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--seconds", type=float, default=30.0, help="of each load")
    parser.add_argument("--coapt", default="build/release/bin/coapt", help="makes the valve")
    parser.add_argument("--triangles", type=int, default=9000, help="of the heavy valve")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "heavy.json"
        make = (
            options.coapt,
            "valve",
            "make",
            "human-functional-mr",
            "--triangles",
            str(options.triangles),
            "-o",
            path,
        )
        subprocess.run(make, check=True)
        flags = ("--request-seconds", 10)
        server = Server(options.server, pathlib.Path(folder) / "jobs.sqlite", *map(str, flags))
        try:
            heavy = server.ask("POST", "/v1/valves", json.loads(path.read_text())).json()["id"]
            figures = [
                beside(server, {"valve": heavy}, clients, options.seconds, "human-normal") for clients in (0, 2, 8)
            ]
        finally:
            server.stop()
    met = all(one["refused"] == 0 for one in figures) and figures[1]["worst_s"] < 1 and figures[2]["worst_s"] < 3
    report(
        {"program": "crowded", "loads": figures, "met": met},
        f"beside 2 and 8 heavy clients a small closure waited {figures[1]['worst_s']} and {figures[2]['worst_s']} s at worst",
    )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
