"""The server does what /openapi.json says: its examples are sent, the answers compared with its schemas."""

import json
import re
import subprocess
import time
import unittest

from openapi_runs import OpenApiTest
from programs import SOURCE, small_valve
from server_runs import search_of

FILE_STARTS = {
    "glb": b"glTF",
    "vtk": b"# vtk",
    "ply": b"ply",
    "obj": b"#",
    "stl": b"coapt",
    "mrk.json": b"{",
    "csv": b"Metric,",
    "feb": b"<?xml",
}
LONG_SEARCH = {"valve": "human-functional-mr", "search": search_of(seed=3, evaluations=100000)}


class OpenApi(OpenApiTest):
    def test_the_document_is_the_one_of_the_sources_and_of_this_version(self):
        target = self.folder / "openapi.json"
        subprocess.run(["cmake", "-D", f"OUTPUT={target}", "-P", SOURCE / "server/openapi.cmake"], check=True)
        self.assertEqual(self.document.json, json.loads(target.read_text()))
        self.assertEqual(self.document.json["info"]["version"], self.server.get("/version")["version"])

    def test_every_example_is_as_its_schema(self):
        for operation in self.document.operations.values():
            responses = [self.document.resolved(r) for r in operation.json["responses"].values()]
            for part in [operation.json.get("requestBody", {}), *responses]:
                for media in part.get("content", {}).values():
                    for name, value in self.document.examples({"": media}).items():
                        with self.subTest(operation.id, example=name):
                            self.assertEqual(self.document.errors_of(value, media["schema"]), [])

    def test_every_request_of_the_document_is_answered_as_it_says(self):
        self.keep_plan()
        for operation in self.document.operations.values():
            for name in self.document.requests(operation):
                with self.subTest(operation.id, example=name):
                    if operation.id == "cancelJob":
                        continue
                    reply = self.send_example(operation.id, name)
                    if "json" not in reply.headers["content-type"]:
                        continue
                    answer = reply.json()
                    if answer.get("state") in ("QUEUED", "RUNNING"):
                        self.place["job"] = answer["id"]
                        self.send_example("cancelJob", "empty")

    def test_everything_that_can_be_got_is_as_it_says(self):
        self.finish_search()
        for operation in self.document.operations.values():
            if operation.method == "GET":
                with self.subTest(operation.id):
                    # This service has no farm.
                    self.assertEqual(self.send(operation.id).status, 404 if operation.id == "getFarm" else 200)
        for format, start in FILE_STARTS.items():
            self.assertTrue(self.send("getJobPlanMesh", query=f"?format={format}").body.startswith(start), format)
            reply = self.send("exportValve", {"valve": "human-normal", "format": format})
            self.assertTrue(reply.status == 200 and reply.body.startswith(start), format)
        self.assertTrue(self.send("getJobEvaluations").body.startswith(b"number,rank,description,"))
        self.assertEqual(self.send("listJobs", query="?page_size=1&state=SUCCEEDED").status, 200)
        self.assertEqual(self.send("getJobResult").json()["schema"], "coapt.plans/2")

    def test_own_plans_with_their_evidence_are_as_it_says(self):
        sutures = [
            {"step": "papillary_approximation", "side": side, "anchor": "ipsilateral_trigone", "suture_length_mm": 26}
            for side in ("anterolateral", "posteromedial")
        ]
        plans = [{"schema": "coapt.plan/1", "steps": sutures}]
        valve = json.loads(small_valve().read_text())
        reply = self.send("evaluatePlans", {"valve": valve, "plans": plans, "evidence": True})
        self.assertIn("independent_leak_mm2", reply.json()["plans"][0])

    def test_a_study_and_its_results_are_as_it_says(self):
        self.store_valve()
        self.place["job"] = self.send_example("runStudy", "annulus").json()["id"]
        self.place["file"] = "index.html"
        for id in ["getJob", "getJobResult", "getJobReport", "listJobFiles", "getJobFile"]:
            with self.subTest(id):
                self.assertEqual(self.send(id).status, 200)
        for file in self.send("listJobFiles").json()["files"]:
            self.place["file"] = file["name"]
            reply = self.send("getJobFile")
            self.assertEqual((len(reply.body), reply.headers["content-type"]), (file["bytes"], file["type"]))

    def test_an_import_and_its_results_are_as_it_says(self):
        self.place["job"] = self.send_example("runImport", "as_a_job").json()["id"]
        self.place["file"] = "import.png"
        for id in ["getJob", "getJobResult", "listJobFiles", "getJobFile"]:
            with self.subTest(id):
                self.assertEqual(self.send(id).status, 200)

    def test_events_are_numbered_and_hold_states_and_progress(self):
        self.finish_search()
        stream = self.send("streamJobEvents").body.decode()
        events = [
            dict(line.split(": ", 1) for line in event.splitlines())
            for event in stream.split("\n\n")
            if event.startswith("id")
        ]
        self.assertEqual([int(event["id"]) for event in events], list(range(1, len(events) + 1)))
        for event in events:
            data = json.loads(event["data"])
            schema = {
                "state": {"properties": {"state": self.document.schemas["JobState"]}},
                "progress": self.document.schemas["Progress"],
            }[event["event"]]
            self.assertEqual(self.document.errors_of(data, schema), [])
        states = [json.loads(event["data"])["state"] for event in events if event["event"] == "state"]
        self.assertEqual(states, ["QUEUED", "RUNNING", "SUCCEEDED"])
        last = events[-1]["id"]
        self.assertEqual(self.send("streamJobEvents", headers={"Last-Event-ID": last}).status, 204)
        again = self.send("streamJobEvents", query=f"?last_event_id={int(last) - 1}").body.decode()
        self.assertEqual(again.count("event: "), 1)

    def test_a_running_search_tells_its_best_plan(self):
        self.place["job"] = self.send("searchPlans", LONG_SEARCH).json()["id"]
        while "best" not in (progress := self.send("getJob").json()["progress"]):
            time.sleep(0.1)
        closed = self.send("closeValve", {"valve": LONG_SEARCH["valve"], "plan": progress["best"]["plan"]}).json()
        # A running search knows an estimate.
        self.assertLess(abs(closed["leak_mm2"] - progress["best"]["leak_mm2"]), 1.0 + 0.5 * closed["leak_mm2"])

    def test_what_is_removed_is_gone(self):
        self.finish_search()
        self.assertEqual(self.send("deleteKeptPlan").status, 204)
        self.assertEqual(self.send("deleteValve").status, 204)
        self.assertEqual(self.send("getValve").status, 404)
        self.assertEqual(self.send("deleteJob").status, 204)
        for id in [
            "getKeptPlan",
            "deleteKeptPlan",
            "getJob",
            "deleteJob",
            "cancelJob",
            "streamJobEvents",
            "getJobResult",
            "getJobPlanMesh",
            "getJobFile",
        ]:
            with self.subTest(id):
                self.assertEqual(self.send(id).status, 404)

    def test_a_valve_that_is_there_is_stored_once(self):
        self.store_valve()
        valve = self.send("getValve").json()
        again = self.send("createValve", valve)
        self.assertEqual((again.status, again.json()["id"]), (200, self.place["valve"]))

    def test_the_same_key_gives_the_same_job(self):
        key = {"Idempotency-Key": "mine"}
        first = self.send("searchPlans", LONG_SEARCH, key)
        again = self.send("searchPlans", LONG_SEARCH, key)
        self.assertEqual((first.status, again.status), (202, 202))
        self.assertEqual(first.json()["id"], again.json()["id"])
        other = self.send("searchPlans", LONG_SEARCH | {"search": search_of(seed=4)}, key)
        self.assertEqual(other.status, 422)

    def test_other_methods_of_its_paths_are_refused_and_those_there_are_named(self):
        self.place |= {"valve": "0", "job": "0", "kept_plan": "0"}
        methods = {}
        for operation in self.document.operations.values():
            methods.setdefault(operation.path, []).append(operation.method)
        for path, known in methods.items():
            wrong = next(method for method in ("PUT", "DELETE", "POST") if method not in known)
            path = re.sub(r"{(\w+)}", lambda name: self.place[name[1]], path)
            with self.subTest(path):
                reply = self.server.ask(wrong, path, "{}")
                self.assertEqual(reply.status, 405)
                allowed = set(reply.headers["allow"].split(", ")) - {"HEAD", "OPTIONS"}
                self.assertEqual(allowed, set(known))


if __name__ == "__main__":
    unittest.main()
