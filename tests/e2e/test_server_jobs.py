"""Searches and studies as jobs of coapt-server, asked by curl."""

import json
import subprocess
import unittest

from programs import coapt, small_valve
from server_runs import ServerTest, search_of


class Jobs(ServerTest):
    flags = ("--wait-seconds", 180)

    def valve(self, preset):
        return json.loads(self.make(preset).read_text())

    def ended(self, job_id):
        return self.server.wait_for_end(job_id)

    def test_a_search_is_the_one_of_the_command_line(self):
        search = {
            "evaluations": 6,
            "seed": 5,
            "plans": 1,
            "region_points": 2,
            "evidence": False,
            "rules": {"forbidden": ["annuloplasty:own"], "suture_lattice_mm": 2},
            "weights": {"movement": 0.5},
        }
        status, headers, body = self.curl_with_headers(
            "/v1/plans",
            "-H",
            "Prefer: wait=180",
            "--data-binary",
            "@" + str(self.write("r.json", {"valve": self.valve("human-functional-mr"), "search": search})),
        )
        job = json.loads(body)
        self.assertEqual((status, job["state"]), (200, "SUCCEEDED"))
        self.assertEqual(headers["location"], "/v1/jobs/" + job["id"])
        answer = self.curl(job["links"]["result"])[2]
        printed = json.loads(
            coapt("plan", "human-functional-mr", "--search", self.write("search.json", search), "--json").stdout
        )
        # A request has no command line.
        self.assertEqual((answer["reproduce"].pop("command"), bool(printed["reproduce"].pop("command"))), ("", True))
        self.assertEqual(answer | {"seconds": 0}, printed | {"seconds": 0})
        plans = self.curl(job["links"]["plans"])[2]["plans"]
        self.assertEqual(plans, answer["plans"])
        self.assertEqual(job["plans"][0]["plan"], plans[0]["plan"])

    def test_an_idempotency_key_makes_one_job(self):
        key = ("-H", "Idempotency-Key: once")
        request = {"valve": "human-normal", "search": search_of(1)}
        first = self.post("/v1/plans", request, *key)[2]
        self.assertEqual(self.post("/v1/plans", request, *key)[2]["id"], first["id"])
        other = {"valve": "human-normal", "search": search_of(2)}
        self.assert_problem(self.post("/v1/plans", other, *key), 422)
        self.assertEqual(len(self.curl("/v1/jobs")[2]["jobs"]), 1)

    def test_a_cancelled_search_keeps_its_best(self):
        job = self.submit(search_of(1, evaluations=50000, no_improvement=0))
        self.server.wait_until(job["id"], lambda job: job["progress"]["closures"] > 30)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}", "-X", "DELETE"), 409)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}/plans"), 409)
        self.assertEqual(self.post(f"/v1/jobs/{job['id']}:cancel", "")[0], 200)
        ended = self.ended(job["id"])
        self.assertEqual((ended["state"], ended["stop"]), ("CANCELLED", "cancelled"))
        self.assertEqual(ended["plans"][0]["rank"], 1)
        self.assertEqual(self.curl(f"/v1/jobs/{job['id']}", "-X", "DELETE")[0], 204)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}"), 404)

    def test_a_time_limit_holds(self):
        job = self.submit(search_of(1, evaluations=50000, seconds=1, region_points=1089))
        ended = self.ended(job["id"])
        self.assertEqual((ended["state"], ended["stop"]), ("SUCCEEDED", "time_limit"))

    def test_events_go_on_after_the_last_one_seen(self):
        job_id = self.submit(search_of(0))["id"]
        self.ended(job_id)
        path = f"/v1/jobs/{job_id}/events"
        _, headers, text = self.curl_with_headers(path)
        self.assertEqual(headers["content-type"], "text/event-stream")
        numbers = [int(line[4:]) for line in text.splitlines() if line.startswith("id: ")]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        self.assertIn('data: {"state": "SUCCEEDED"}', text)
        _, _, later = self.curl_with_headers(path, "-H", f"Last-Event-ID: {numbers[-2]}")
        self.assertEqual([line for line in later.splitlines() if line.startswith("id: ")], [f"id: {numbers[-1]}"])
        self.assertEqual(self.curl_with_headers(path, "-H", f"Last-Event-ID: {numbers[-1]}")[0], 204)

    def test_a_plan_can_be_had_as_mesh_picture_and_report(self):
        job = self.ended(self.submit(search_of(1))["id"])
        plan = f"/v1/jobs/{job['id']}/plans/1"
        for path, begins in [
            (plan + "/mesh", b"ply"),
            (plan + "/mesh?format=obj", b"# coapt"),
            (plan + "/picture", b"\x89PNG"),
            (plan + "/report", b"<!DOCTYPE html>"),
            (job["links"]["report"], b"<!DOCTYPE html>"),
        ]:
            with self.subTest(path):
                answer = subprocess.run(["curl", "-sS", self.url + path], capture_output=True)
                self.assertEqual(answer.stdout[: len(begins)], begins)
        self.assert_problem(self.curl(plan + "/mesh?format=exe"), 422, "?format")
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}/plans/99"), 404)

    def test_a_study_is_a_job_with_files(self):
        valve = json.loads(small_valve("porcine-3").read_text())
        status, _, job = self.post("/v1/studies", {"valve": valve, "study": {"name": "annulus"}})
        self.assertEqual(status, 202)
        ended = self.ended(job["id"])
        self.assertEqual(ended["state"], "SUCCEEDED", ended["problems"])
        names = [file["name"] for file in self.curl(ended["links"]["files"])[2]["files"]]
        self.assertIn("annulus.csv", names)
        self.assertEqual(len(self.curl(ended["links"]["result"])[2]["findings"]), ended["findings"])
        self.assert_problem(
            self.post("/v1/studies", {"valve": "porcine-3", "study": {"name": "x"}}), 422, "/study/name"
        )


if __name__ == "__main__":
    unittest.main()
