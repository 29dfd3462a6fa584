"""A Client of a coapt-server, or an Engine in this process, for each test."""

import importlib.util
import sys
import unittest

import coapt
from plan_runs import BARE
from programs import ProgramTest
from server_runs import ServerTest

TOKEN = "open-sesame-2026"
VALVE = "human-functional-mr"
SMALL = {"evaluations": 6, "seed": 5, "plans": 1, "region_points": 2, "evidence": False} | BARE
ENDLESS = SMALL | {"evaluations": 50000}


class Asked:
    """What tests ask of a client or an engine."""

    def refused(self, kind, call, *arguments, **named):
        """The error of a call that is refused."""
        with self.assertRaises(kind) as raised:
            call(*arguments, **named)
        return raised.exception

    def problems(self, kind, call, *arguments, **named):
        """Where and with which code."""
        return [(problem.path, problem.code) for problem in self.refused(kind, call, *arguments, **named).problems]


class ClientTest(Asked, ServerTest):
    def setUp(self):
        super().setUp()
        self.client = coapt.Client(self.url)


class EngineTest(Asked, ProgramTest):
    def setUp(self):
        super().setUp()
        self.client = coapt.Engine()
        self.addCleanup(self.client.end)


def has_engine():
    try:
        return importlib.util.find_spec("coapt._engine") is not None
    except ValueError:  # it is there already
        return True


def both(tests):
    """A class of ClientTest's runs against an engine, too: what a service answers, an engine answers."""
    functions = {name: value for name, value in vars(tests).items() if not name.startswith("__")}
    engines = type(f"{tests.__name__}InProcess", (EngineTest,), functions)
    setattr(sys.modules[tests.__module__], engines.__name__, unittest.skipUnless(has_engine(), "no engine")(engines))
    return tests
