"""A coapt-server for each test, and a Client of it."""

import coapt
from server_runs import ServerTest

TOKEN = "open-sesame-2026"
VALVE = "human-functional-mr"
SMALL = {"evaluations": 6, "seed": 5, "plans": 1, "region_points": 2, "evidence": False}
ENDLESS = SMALL | {"evaluations": 50000}


class ClientTest(ServerTest):
    def setUp(self):
        super().setUp()
        self.client = coapt.Client(self.url)

    def refused(self, kind, call, *arguments, **named):
        """The error of a call that is refused."""
        with self.assertRaises(kind) as raised:
            call(*arguments, **named)
        return raised.exception

    def problems(self, kind, call, *arguments, **named):
        """Where and with which code."""
        return [(problem.path, problem.code) for problem in self.refused(kind, call, *arguments, **named).problems]
