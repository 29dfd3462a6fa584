"""A farm with a toy kind of work (toy_farm.cpp), and what its answers must be."""

import json
import os
import pathlib
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "e2e"))

from private_postgres import PrivatePostgres  # noqa: E402
from process_runs import HANGS_S, is_stopped, wait_until  # noqa: E402

FARM = os.environ["COAPT_TOY_FARM"]
OK, FAILURE, BAD_INPUT, HOLES, INTERRUPTED = 0, 1, 2, 4, 130
MASK = (1 << 64) - 1


def mixed(x):
    """splitmix64."""
    x = (x + 0x9E3779B97F4A7C15) & MASK
    x = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    x = ((x ^ (x >> 27)) * 0x94D049BB133111EB) & MASK
    return x ^ (x >> 31)


class Request:
    def __init__(self, items, task_items=10, ms=1, parts=("part",), **told):
        document = json.dumps({"items": items, "task_items": task_items, "ms": ms, **told})
        self.items = items
        self.parts = [document.encode(), *(part.encode() for part in parts)]

    def bytes(self):
        sized = b"".join(b"%d\n%s" % (len(part), part) for part in self.parts)
        return b"coapt.work/1 toy %d\n" % len(self.parts) + sized

    def answers(self):
        seed = 0
        for letter in b"".join(self.parts):
            seed = mixed(seed ^ letter)
        return b"".join(struct.pack("<Q", mixed(seed ^ item)) for item in range(self.items))


class FarmTest(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        cls.postgres = PrivatePostgres(cls.settings if hasattr(cls, "settings") else "")
        cls.addClassCleanup(cls.postgres.remove)

    def setUp(self):
        FarmTest.count += 1
        self.name = f"farm{FarmTest.count}"
        self.postgres.sql("postgres", f"CREATE DATABASE {self.name}")
        self.url = self.postgres.url(self.name)
        self.farm("init")

    def start(self, *arguments, url=None, stdin=subprocess.DEVNULL, **environment):
        process = subprocess.Popen(
            [FARM, *map(str, arguments)],
            env={**os.environ, "COAPT_FARM": url or self.url, **environment},
            stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        )  # fmt: skip
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        process.kill()
        process.communicate()

    def run_farm(self, *arguments, stdin=b"", timeout=HANGS_S, **options):
        process = self.start(*arguments, stdin=subprocess.PIPE, **options)
        out, err = process.communicate(stdin, timeout=timeout)
        return subprocess.CompletedProcess(arguments, process.returncode, out, err.decode())

    def farm(self, *arguments, code=OK, **options):
        run = self.run_farm(*arguments, **options)
        self.assertEqual(run.returncode, code, run.stderr)
        return run

    def worker(self, *arguments, lease=1, **environment):
        return self.start("work", "--lease", lease, *arguments, **environment)

    def stopped_worker(self, *arguments, items=25, **options):
        """Has computed so many items, and holds a task that it has begun."""
        worker = self.worker(*arguments, TOY_STOPS_AFTER=str(items), **options)
        wait_until(lambda: is_stopped(worker))
        return worker

    def coordinator(self, request, *arguments, **environment):
        """Waits for the answers; to be asked for them by collect()."""
        process = self.start("add", "-", "--wait", *arguments, stdin=subprocess.PIPE, **environment)
        process.stdin.write(request.bytes())
        process.stdin.close()
        process.stdin = None
        return process

    def collect(self, coordinator, request, timeout=HANGS_S):
        out, err = coordinator.communicate(timeout=timeout)
        self.assertEqual(coordinator.returncode, OK, err.decode())
        self.assertEqual(out, request.answers())
        return err.decode()

    def sql(self, text, **login):
        return self.postgres.sql(self.name, text, **login)

    def new_login(self, name, *roles):
        """Its address of the farm."""
        self.sql(
            f"DROP ROLE IF EXISTS {name}; CREATE ROLE {name} LOGIN PASSWORD 'pw-{name}' IN ROLE {', '.join(roles)}"
        )
        return self.postgres.url(self.name, name, f"pw-{name}")

    def number(self, text):
        return int(self.sql(text)[0][0])

    def status(self):
        return json.loads(self.farm("status", "--json").stdout)

    def done(self):
        return self.number("SELECT count(*) FROM coapt_farm.result")

    def assert_each_item_once(self, request):
        self.assertEqual(self.number("SELECT sum(n) FROM coapt_farm.result"), request.items)
        self.assertEqual([run["done"] for run in self.status()["runs"]], [request.items])
