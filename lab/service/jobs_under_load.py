#!/usr/bin/env python3
"""Whether jobs can be watched while a search takes all cores: wrk on GET /v1/jobs/{id}, and what that
load costs the search in closures per second."""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/service"))

from served import Server, parser_of, report  # noqa: E402

MILLISECONDS = {"us": 1e-3, "ms": 1.0, "s": 1e3, "m": 6e4}


def closures(server, job_id):
    """Closures of the search until now, and when that was."""
    job = server.get(f"/v1/jobs/{job_id}")
    if job["state"] != "RUNNING":
        raise RuntimeError(f"the search is {job['state']}: {job['progress']}")
    return job["progress"]["closures"], time.monotonic()


def rate(before, after):
    """Closures per second."""
    return (after[0] - before[0]) / (after[1] - before[1])


def read_wrk(text):
    """Figures of `wrk --latency`."""

    def latency(percent):
        value, unit = re.search(rf"^\s+{percent}%\s+([\d.]+)(us|ms|s|m)\s*$", text, re.M).groups()
        return round(float(value) * MILLISECONDS[unit], 2)

    sockets = re.search(r"Socket errors: connect (\d+), read (\d+), write (\d+), timeout (\d+)", text)
    refused = re.search(r"Non-2xx or 3xx responses: (\d+)", text)
    return {
        "requests": int(re.search(r"(\d+) requests in", text).group(1)),
        "socket_errors": sum(map(int, sockets.groups())) if sockets else 0,
        "refused": int(refused.group(1)) if refused else 0,
        "p50_ms": latency(50),
        "p99_ms": latency(99),
    }


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--seconds", type=int, default=20, help="of load, and of quiet before it")
    parser.add_argument("--connections", type=int, default=64)
    parser.add_argument("--threads", type=int, default=2, help="of wrk")
    parser.add_argument("--target-ms", type=float, default=50.0, help="largest p99")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        server = Server(options.server, pathlib.Path(folder) / "jobs.sqlite")
        try:
            job_id = server.submit({"valve": "human-functional-mr", "search": {"evaluations": 100000}})["id"]
            server.wait_until(job_id, lambda job: job["progress"]["closures"] > 0)
            start = closures(server, job_id)
            time.sleep(options.seconds)
            middle = closures(server, job_id)
            wrk = subprocess.run(
                [
                    "wrk",
                    "--latency",
                    "-t",
                    str(options.threads),
                    "-c",
                    str(options.connections),
                    "-d",
                    f"{options.seconds}s",
                    f"http://127.0.0.1:{server.port}/v1/jobs/{job_id}",
                ],
                capture_output=True,
                text=True,
                check=True,
                timeout=options.seconds + 60,
            )
            end = closures(server, job_id)
            server.ask("POST", f"/v1/jobs/{job_id}:cancel")
        finally:
            server.stop()
    figures = {"program": "jobs_under_load", "seconds": options.seconds, "connections": options.connections}
    figures |= read_wrk(wrk.stdout)
    figures |= {
        "closures_per_second": round(rate(start, middle), 1),
        "closures_per_second_under_load": round(rate(middle, end), 1),
    }
    errors = figures["socket_errors"] + figures["refused"]
    figures["met"] = figures["p99_ms"] < options.target_ms and errors == 0
    report(
        figures,
        f"{figures['requests']} requests, {errors} errors, p50 {figures['p50_ms']} ms, p99 "
        f"{figures['p99_ms']} ms (target {options.target_ms} ms: {'met' if figures['met'] else 'missed'}); search "
        f"{figures['closures_per_second']} closures/s alone, {figures['closures_per_second_under_load']} under load",
    )
    return 0 if figures["met"] else 1


if __name__ == "__main__":
    sys.exit(main())
