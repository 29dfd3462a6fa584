#!/usr/bin/env python3
"""What the service adds to a closure: the time of POST /v1/closures by curl, from connect to the last
byte, against the seconds that the closure itself took (what is left is HTTP, reading the valve and measuring what
leaks), against the target by the valve's id; GET /version, which is HTTP alone; and POST /v1/imports:preview of two triangles, which a
process of its own reads. The machine must be quiet otherwise."""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/service"))

from served import Server, parser_of, percentile, report  # noqa: E402


def timed(url, *arguments):
    """Milliseconds of an exchange, and its answer."""
    run = subprocess.run(
        [
            "curl",
            "--silent",
            "--show-error",
            "--fail",
            "--max-time",
            "60",
            *arguments,
            "--write-out",
            "\n%{time_total}",
            url,
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    body, _, total = run.stdout.rpartition("\n")
    return 1e3 * float(total), json.loads(body)


SMALL = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"


def timed_post(url, request):
    """Milliseconds of the exchange and of the closure within it."""
    total, answer = timed(url, "-H", "Content-Type: application/json", "--data-binary", f"@{request}")
    return total, 1e3 * answer["seconds"]


def measure(url, request, count):
    times = [timed_post(url, request) for _ in range(count + 3)][3:]  # the first ones warm caches
    totals = [total for total, _ in times]
    overheads = [total - closure for total, closure in times]
    return {
        "requests": count,
        "p50_ms": round(percentile(totals, 50), 2),
        "p95_ms": round(percentile(totals, 95), 2),
        "closure_p50_ms": round(percentile([closure for _, closure in times], 50), 2),
        "overhead_p50_ms": round(percentile(overheads, 50), 2),
        "overhead_p95_ms": round(percentile(overheads, 95), 2),
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--requests", type=int, default=100, help="of each kind")
    parser.add_argument("--valve", default="human-normal", help="a preset; this one has 648 triangles")
    parser.add_argument("--target-ms", type=float, default=2.0, help="largest overhead at p50")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        server = Server(options.server, pathlib.Path(folder) / "jobs.sqlite")
        try:
            valve = server.get(f"/v1/presets/{options.valve}")
            stored = server.ask("POST", "/v1/valves", valve).json()
            version = [timed(f"http://127.0.0.1:{server.port}/version")[0] for _ in range(options.requests)]
            figures = {
                "program": "closures",
                "triangles": stored["triangles"],
                "version_p50_ms": round(percentile(version, 50), 2),
            }
            preview = pathlib.Path(folder) / "preview.json"
            preview.write_text(json.dumps({"files": [{"name": "small.obj", "text": SMALL}]}))
            sent = ("-H", "Content-Type: application/json", "--data-binary", f"@{preview}")
            reading = [
                timed(f"http://127.0.0.1:{server.port}/v1/imports:preview", *sent)[0] for _ in range(options.requests)
            ]
            figures["preview_p50_ms"], figures["preview_p95_ms"] = (
                round(percentile(reading, share), 2) for share in (50, 95)
            )
            kinds = {"inline": {"valve": valve}, "by_id": {"valve": stored["id"]}}
            for kind, body in kinds.items():
                request = pathlib.Path(folder) / f"{kind}.json"
                request.write_text(json.dumps(body))
                figures[kind] = measure(f"http://127.0.0.1:{server.port}/v1/closures", request, options.requests)
        finally:
            server.stop()
    figures["met"] = figures["by_id"]["overhead_p50_ms"] <= options.target_ms
    report(
        figures,
        "; ".join(
            f"{kind}: p50 {figures[kind]['p50_ms']} ms, p95 {figures[kind]['p95_ms']} ms, over the closure "
            f"{figures[kind]['overhead_p50_ms']} ms"
            for kind in kinds
        )
        + f"; a preview in a process of its own {figures['preview_p50_ms']} ms; GET /version {figures['version_p50_ms']} ms (target {options.target_ms} ms: {'met' if figures['met'] else 'missed'})",
    )
    return 0 if figures["met"] else 1


if __name__ == "__main__":
    sys.exit(main())
