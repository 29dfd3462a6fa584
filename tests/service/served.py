"""A coapt-server of one's own on this machine: started, asked, stopped, killed."""

import argparse
import dataclasses
import http.client
import json
import pathlib
import re
import signal
import subprocess
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
ENDED = ("SUCCEEDED", "FAILED", "CANCELLED")


@dataclasses.dataclass
class Reply:
    status: int
    headers: dict  # names in lower case
    body: bytes

    def json(self):
        return json.loads(self.body)


HANGS_S = 1200  # against hanging, not a measure: machines are shared and slow


def ask(port, method, path, body=None, headers=None, seconds=HANGS_S, client="127.0.0.1"):
    """One request over a connection of its own, from this address; a body that is no bytes or text is sent as JSON."""
    headers = dict(headers or {})
    if body is not None and not isinstance(body, (bytes, str)):
        body = json.dumps(body)
        headers.setdefault("Content-Type", "application/json")
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=seconds, source_address=(client, 0))
    try:
        connection.request(method, path, body, headers)
        answer = connection.getresponse()
        return Reply(answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read())
    finally:
        connection.close()


# Machines are slow under sanitizers; others may log in.
USUAL = (("--request-seconds", str(HANGS_S)), ("--no-token",))


class Server:
    """Listens on a free port with `db`; its messages go into a file beside it."""

    def __init__(self, binary, db, *flags):
        self.binary, self.db = binary, pathlib.Path(db)
        self.flags = flags + tuple(word for usual in USUAL if usual[0] not in flags for word in usual)
        self.messages = self.db.with_suffix(".log")
        self.launch()
        self.wait_until_listening()

    def launch(self):
        """Without waiting until it listens."""
        with self.messages.open("w") as log:
            self.process = subprocess.Popen(
                [self.binary, "--port", "0", "--db", self.db, *map(str, self.flags)],
                stdout=log,
                stderr=subprocess.STDOUT,
            )
        self.port = None

    def wait_until_listening(self, seconds=HANGS_S):
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            said = re.search(r"listening on http://\S+:(\d+)\n", self.messages.read_text(errors="replace"))
            if said:
                self.port = int(said.group(1))
                return
            if self.process.poll() is not None:
                break
            time.sleep(0.01)
        self.kill()
        raise RuntimeError(f"coapt-server does not listen: {self.messages.read_text(errors='replace')}")

    def ask(self, method, path, body=None, headers=None, seconds=HANGS_S, client="127.0.0.1"):
        return ask(self.port, method, path, body, headers, seconds, client)

    def get(self, path):
        """JSON of what must be there."""
        reply = self.ask("GET", path)
        if reply.status != 200:
            raise RuntimeError(f"GET {path}: {reply.status} {reply.body[:300]}")
        return reply.json()

    def submit(self, request, path="/v1/plans", headers=None):
        """The new job."""
        reply = self.ask("POST", path, request, headers)
        if reply.status not in (200, 202):
            raise RuntimeError(f"POST {path}: {reply.status} {reply.body[:300]}")
        return reply.json()

    def wait_for_end(self, job_id, seconds=HANGS_S):
        """The job when it has ended."""
        return self.wait_until(job_id, lambda job: job["state"] in ENDED, seconds)

    def wait_until(self, job_id, condition, seconds=HANGS_S):
        """The job as soon as `condition(job)`."""
        deadline = time.monotonic() + seconds
        while True:
            job = self.get(f"/v1/jobs/{job_id}")
            if condition(job):
                return job
            if time.monotonic() > deadline:
                raise RuntimeError(f"job still {job['state']} after {seconds} s: {job['progress']}")
            time.sleep(0.05)

    def resident_mib(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+) kB", status).group(1)) / 1024

    def open_files(self):
        return len(list(pathlib.Path(f"/proc/{self.process.pid}/fd").iterdir()))

    def stop(self, seconds=HANGS_S):
        """Ends it as a service manager does; its exit code."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=seconds)

    def kill(self):
        """SIGKILL: nothing is saved on the way out."""
        self.process.kill()
        self.process.wait()


def parser_of(description):
    """Options that all programs here have."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument(
        "--server", type=pathlib.Path, default=SOURCE / "build/release/bin/coapt-server", help="the program under test"
    )
    return parser


def report(figures, sentence):
    """One line for programs, one for people."""
    print(json.dumps(figures))
    print(sentence, flush=True)


def percentile(values, percent):
    """The value that `percent` of `values` do not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * percent / 100))]


def search_of(seed, evaluations=6, **fields):
    """A search request's "search": small, and nothing closed once more at its end unless told."""
    small = {"evaluations": evaluations, "seed": seed, "plans": 1, "region_points": 2}
    return small | {"evidence": False, "fine_levels": 0, "model_draws": 0} | fields
