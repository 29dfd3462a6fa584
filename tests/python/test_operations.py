"""One request, one answer: what `coapt operations` lists is answered alike by every door that it names."""

import json
import re
import unittest

from client_runs import has_engine
from coapt import engine as coapt_engine
from coapt.imports import files_to_import
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
    "observe": [
        {"observed": {"leak_mm2": {"value": 20, "sd": 5, "source": "echo"}}},
        {"effective_leak": {"value": 16, "sd": 4, "discharge": 0.8, "discharge_sd": 0.06}},
    ],
    "evaluate": [{"plans": [RING, {"schema": "coapt.plan/1", "steps": []}], "region_points": 2}],
    "report": [{"plans": [RING]}],
    "export": [{"format": "ply"}, {**CASE, "format": "mrk.json"}],
    "export_files": [{**CASE, "formats": ["vtk", "slicerheart"], "frame": "valve"}],
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


SHEET = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 9 0\nf 1 2 3\nf 2 4 3\n"
# Requests that name their valve otherwise, and what the command line prints of them.
OTHER_REQUESTS = {
    "compare": [
        {"closed": {"valve": VALVE, **CASE, "source": VALVE}, "reference": {"valve": VALVE}, "nodes": True},
        {"closed": {"valve": VALVE, "source": VALVE}, "reference": {"file": {"name": "SHEET", "text": SHEET}}},
    ]
}
OTHER_ARGUMENTS = {"compare": [None, [VALVE, "SHEET"]]}


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
        cls.local = LocalTransport(None, 1) if has_engine() else None

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
        for name, requests in REQUESTS.items():
            for index, more in enumerate(requests):
                words = ARGUMENTS.get(name, [None] * len(requests))[index]
                if words is not None:
                    words = [VALVE, *(ring if word == "RING" else word for word in words)]
                self.assert_alike(name, {"valve": VALVE, **more}, words)

    def test_requests_of_several_shapes_are_answered_alike(self):
        sheet = str(self.write("sheet.obj", SHEET))
        for name, requests in OTHER_REQUESTS.items():
            for request, words in zip(requests, OTHER_ARGUMENTS[name]):
                request = json.loads(json.dumps(request).replace("SHEET", sheet))
                self.assert_alike(name, request, words and [word.replace("SHEET", sheet) for word in words])

    def test_a_fit_as_a_job_is_the_command_s_and_the_engine_s(self):
        closed = self.folder / "closed.ply"
        valve = self.make("human-functional-mr", "--triangles", "150")
        self.run_ok("export", valve, "--frame", "valve", "-o", closed)
        words = ["fit", valve, "--closed", closed, "--side", "middle", "--rounds", 1, "--json", "-o"]
        runs = [coapt(*words, self.folder / f"{i}.json", *more) for i, more in enumerate(([], ["--server", self.url]))]
        here, there = (timeless(json.loads(run.stdout)) for run in runs)
        self.assertEqual(there, here)
        self.assertEqual(*((self.folder / f"{i}.json").read_bytes() for i in range(2)))
        if not has_engine():
            return
        told = coapt_engine().fit_job(valve, closed, side="middle", rounds=1).result()
        self.assertEqual(told.json["parameters"], here["parameters"])
        self.assertEqual(told.json["fitted"]["tissue"], json.loads((self.folder / "0.json").read_text())["tissue"])

    def test_an_import_as_a_job_is_the_command_s_and_the_engine_s(self):
        folder = SOURCE / "examples/valves/source/bodyparts3d"
        leaflets = [folder / f"{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
        annulus, chordae = folder / "annulus_centerline.csv", folder / "chordae.csv"
        request = files_to_import(leaflets, annulus, chordae, None) | {"triangles": 300}
        file = self.write("files.json", request)
        runs = [
            self.run_ok("operations", "import", "--request", file, *more).stdout
            for more in ([], ["--server", self.url])
        ]
        self.assertEqual(runs[1], runs[0])
        if has_engine():
            told = coapt_engine().import_job(leaflets, annulus, chordae, triangles=300).result()
            self.assertEqual(timeless(told.json), json.loads(runs[0]))

    def test_variants_as_a_job_are_the_command_s_and_the_engine_s(self):
        words = ["study", "model", VALVE, "--draws", 6, "--json", "-o"]
        runs = [coapt(*words, self.folder / f"{i}", *more) for i, more in enumerate(([], ["--server", self.url]))]
        self.assertEqual(runs[1].stdout, runs[0].stdout)
        for name in ("model.json", "areas.csv", "parameters.csv", "draws.csv", "index.html"):
            self.assertEqual(*((self.folder / f"{i}/{name}").read_bytes() for i in range(2)))
        if has_engine():
            self.assertEqual(coapt_engine().model_job(VALVE, draws=6).result(), json.loads(runs[0].stdout))

    def assert_alike(self, name, request, words=None):
        """What the service answers, Python's engine, and, where `words` say how, the command line."""
        operation = self.operations[name]
        with self.subTest(name, request=request):
            status, headers, text = self.ask(operation["path"], request)
            self.assertEqual(status, 200, text[:300])
            if self.local and "python" in operation["doors"]:
                answer = self.local.request("POST", operation["path"], request)
                self.assertEqual(self.comparable(headers, answer.body), self.comparable(headers, text))
            if "command_line" in operation["doors"]:
                self.assertEqual(self.comparable(headers, self.by_name(name)), self.comparable(headers, text))
            if words is not None:
                told = json.loads(coapt(*operation["command"].split(), *words, "--json").stdout)
                answered = timeless(json.loads(text))
                answered.pop("scene", None)  # the command draws none
                self.assertEqual(timeless(told), answered)

    def by_name(self, name):
        """What `coapt operations NAME` answers to the request asked last."""
        output = self.folder / "answer"
        self.run_ok("operations", name, "--request", self.folder / "request.json", "-o", output)
        return output.read_bytes()

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
