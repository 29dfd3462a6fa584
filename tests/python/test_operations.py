"""One request, one answer: what `coapt operations` lists is answered alike by every door that it names."""

import json
import re
import unittest

from client_runs import has_engine
from coapt.local_transport import LocalTransport
from programs import SOURCE, coapt
from server_runs import ServerTest

VALVE = "porcine-1"
RING = json.loads((SOURCE / "examples/plans/ring.json").read_text())
CASE = {"plan": RING}

# A request of each operation that is answered at once, besides the valve; {} is the valve alone.
REQUESTS = {
    "close": [
        {},
        CASE,
        {"open": True},
        {"accuracy_mm2": 20},
        {"converge": {"most_vertices": 900}},
        {"membrane": "springs"},
        {**CASE, "draws": 6},
        {"certainty": "sure"},
    ],
    "scene": [{"frames": 2}],
    "open": [{}, {**CASE, "flow_ml_s": 60, "exercise": 2}],
    "diagnose": [{}, CASE],
    "physiology": [{"kind": "healthy"}],
    "information": [{**CASE, "draws": 6}],
    "observe": [{"observed": {"leak_mm2": {"value": 20, "sd": 5, "source": "echo"}}}],
    "evaluate": [{"plans": [RING, {"schema": "coapt.plan/1", "steps": []}], "region_points": 2}],
    "report": [{"plans": [RING]}],
    "export": [{"format": "ply"}, {**CASE, "format": "mrk.json"}],
    "picture": [CASE],
}
# What the command line prints of a request: the arguments after its command and the valve.
ARGUMENTS = {
    "close": [
        [],
        ["--plan", "RING"],
        ["--open"],
        ["--accuracy", 20],
        ["--converge", "--most-vertices", 900],
        ["--membrane", "springs"],
        ["--plan", "RING", "--draws", 6],
        ["--certainty", "sure"],
    ],
    "open": [[], ["--plan", "RING", "--flow", 60, "--exercise", 2]],
    "diagnose": [[], ["--plan", "RING"]],
    "physiology": [["--kind", "healthy"]],
    "information": [["--plan", "RING", "--draws", 6]],
}


def listed():
    result = coapt("operations", "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)["operations"]


def timeless(answer):
    """Without what the clock says."""
    if isinstance(answer, dict):
        return {name: timeless(value) for name, value in answer.items() if name != "seconds"}
    return [timeless(value) for value in answer] if isinstance(answer, list) else answer


class Operations(ServerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.operations = {operation["name"]: operation for operation in listed()}

    def test_every_operation_is_where_it_says(self):
        contract = json.loads((SOURCE / "server/openapi.json").read_text())["paths"]
        for name, operation in self.operations.items():
            with self.subTest(name):
                if "command_line" in operation["doors"]:
                    self.assertEqual(coapt(*operation["command"].split(), "--help").returncode, 0)
                self.assertEqual("service" in operation["doors"], operation["path"] in contract)
                self.assertTrue(operation["what"].endswith("."))

    def test_the_service_answers_what_python_and_the_command_line_do(self):
        ring = self.write("ring.json", RING)
        local = LocalTransport(None, 1) if has_engine() else None
        for name, requests in REQUESTS.items():
            operation = self.operations[name]
            for index, more in enumerate(requests):
                with self.subTest(name, request=more):
                    request = {"valve": VALVE, **more}
                    status, headers, text = self.ask(operation["path"], request)
                    self.assertEqual(status, 200, text[:300])
                    if local and "python" in operation["doors"]:
                        answer = local.request("POST", operation["path"], request)
                        self.assertEqual(self.comparable(headers, answer.body), self.comparable(headers, text))
                    if name in ARGUMENTS:
                        words = [ring if word == "RING" else word for word in ARGUMENTS[name][index]]
                        told = json.loads(coapt(*operation["command"].split(), VALVE, *words, "--json").stdout)
                        answered = timeless(json.loads(text))
                        answered.pop("scene", None)  # the command draws none
                        self.assertEqual(timeless(told), answered)

    def ask(self, path, request):
        file = self.write("request.json", json.dumps(request))
        body = self.folder / "body"
        arguments = ["-H", "Content-Type: application/json", "--data-binary", f"@{file}", "--output", body]
        status, headers, _ = self.curl_with_headers(path, *arguments)
        return status, headers, body.read_bytes()

    def comparable(self, headers, body):
        if not headers["content-type"].startswith("application/json"):
            return re.sub(rb"\d+\.\d s\b", b"S s", body)
        return timeless(json.loads(body))


if __name__ == "__main__":
    unittest.main()
