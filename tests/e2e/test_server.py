"""What coapt-server answers, asked by curl."""

import gzip
import json
import subprocess
import unittest

from programs import BAD_INPUT, FAILURE, SERVER, coapt
from server_runs import ServerTest, search_of

MEBIBYTE = 1 << 20


class Answers(ServerTest):
    def valve(self, preset):
        return json.loads(self.make(preset).read_text())

    def ended(self, job_id):
        return self.server.wait_for_end(job_id)

    def test_it_is_alive_and_says_that_it_is_for_research(self):
        status, _, answer = self.curl("/healthz/live")
        self.assertEqual((status, answer["status"]), (200, "live"))
        self.assertIn("not a medical device", answer["notice"])

    def test_a_closure_is_the_one_of_the_command_line(self):
        status, _, answer = self.post("/v1/closures", {"valve": self.valve("human-normal")})
        printed = json.loads(coapt("close", "human-normal", "--json").stdout)
        self.assertEqual(status, 200)
        self.assertEqual(answer | {"seconds": 0}, printed | {"seconds": 0})

    def test_a_stored_valve_an_inline_one_and_a_preset_are_the_same(self):
        valve = self.valve("human-normal")
        status, headers, body = self.curl_with_headers(
            "/v1/valves", "--data-binary", f"@{self.write('valve.json', valve)}")
        stored = json.loads(body)
        self.assertEqual((status, headers["location"]), (201, "/v1/valves/" + stored["id"]))
        self.assertEqual(self.post("/v1/valves", valve)[0], 200)
        self.assertEqual(self.curl(headers["location"])[2], valve)
        answers = [self.post("/v1/closures", {"valve": named})[2] | {"seconds": 0}
                   for named in (valve, stored["id"], "human-normal")]
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(answers[0], answers[2])
        self.assertEqual(self.curl(headers["location"], "-X", "DELETE")[0], 204)
        self.assert_problem(self.post("/v1/closures", {"valve": stored["id"]}), 422, "/valve")

    def test_plans_are_scored_in_the_order_asked_as_on_the_command_line(self):
        ring = {"step": "annuloplasty", "shape": "generic-classic", "size_mm": 30}
        plans = [{"schema": "coapt.plan/1", "steps": steps} for steps in ([], [ring], [])]
        status, _, answer = self.post(
            "/v1/evaluations",
            {"valve": "human-functional-mr", "plans": plans, "region_points": 5})
        self.assertEqual(status, 200)
        self.assertEqual([plan["index"] for plan in answer["plans"]], [0, 1, 2])
        self.assertEqual([plan["rank"] for plan in answer["plans"]], [2, 1, 2])
        files = [self.write(f"{i}.json", plans[i]) for i in range(2)]
        printed = json.loads(coapt("evaluate", "human-functional-mr", *files, "--no-evidence",
                                   "--region-points", 5, "--json").stdout)
        for plan in answer["plans"]:
            same = printed["plans"][plan["rank"] - 1]
            self.assertEqual(plan["leak_mm2"], same["leak_mm2"])
            self.assertEqual(plan["cost"], same["cost"])
        many = {"valve": "human-functional-mr", "plans": plans, "region_points": 1089}
        self.assert_problem(self.post("/v1/evaluations", many), 422, "/plans")

    def test_a_search_is_the_one_of_the_command_line(self):
        search = {"evaluations": 6, "seed": 5, "plans": 1, "region_points": 2, "evidence": False,
                  "rules": {"forbidden": ["annuloplasty:own"], "suture_lattice_mm": 2},
                  "weights": {"movement": 0.5}}
        status, headers, body = self.curl_with_headers(
            "/v1/plans", "-H", "Prefer: wait=60", "--data-binary",
            "@" + str(self.write("r.json", {"valve": self.valve("human-functional-mr"),
                                            "search": search})))
        job = json.loads(body)
        self.assertEqual((status, job["state"]), (200, "SUCCEEDED"))
        self.assertEqual(headers["location"], "/v1/jobs/" + job["id"])
        answer = self.curl(job["links"]["result"])[2]
        printed = json.loads(coapt("plan", "human-functional-mr", "--search",
                                   self.write("search.json", search), "--json").stdout)
        # A request has no command line.
        self.assertEqual((answer["reproduce"].pop("command"), bool(printed["reproduce"].pop("command"))),
                         ("", True))
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
        self.server.wait_until(job["id"], lambda job: job["progress"]["evaluations"] > 30)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}", "-X", "DELETE"), 409)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}/plans"), 409)
        self.assertEqual(self.post(f"/v1/jobs/{job['id']}:cancel", "")[0], 200)
        ended = self.ended(job["id"])
        self.assertEqual((ended["state"], ended["stop"]), ("CANCELLED", "cancelled"))
        self.assertEqual(ended["plans"][0]["rank"], 1)
        self.assertEqual(self.curl(f"/v1/jobs/{job['id']}", "-X", "DELETE")[0], 204)
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}"), 404)

    def test_a_time_limit_holds(self):
        job = self.submit(search_of(1, evaluations=50000, seconds=2, region_points=1089))
        ended = self.ended(job["id"])
        self.assertEqual((ended["state"], ended["stop"]), ("SUCCEEDED", "time_limit"))

    def test_jobs_are_paged_and_events_go_on_after_the_last_one_seen(self):
        ids = [self.submit(search_of(seed))["id"] for seed in range(3)]
        for job_id in ids:
            self.ended(job_id)
        page = self.curl("/v1/jobs?page_size=2")[2]
        rest = self.curl(f"/v1/jobs?page_size=2&page_token={page['next_page_token']}")[2]
        self.assertEqual([job["id"] for job in page["jobs"] + rest["jobs"]], ids[::-1])
        self.assertIsNone(rest["next_page_token"])
        self.assertEqual(len(self.curl("/v1/jobs?state=SUCCEEDED")[2]["jobs"]), 3)
        self.assert_problem(self.curl("/v1/jobs?page_size=0&state=X"), 422, "?state")

        path = f"/v1/jobs/{ids[0]}/events"
        _, headers, text = self.curl_with_headers(path)
        self.assertEqual(headers["content-type"], "text/event-stream")
        numbers = [int(line[4:]) for line in text.splitlines() if line.startswith("id: ")]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        self.assertIn('data: {"state": "SUCCEEDED"}', text)
        _, _, later = self.curl_with_headers(path, "-H", f"Last-Event-ID: {numbers[-2]}")
        self.assertEqual([line for line in later.splitlines() if line.startswith("id: ")],
                         [f"id: {numbers[-1]}"])
        self.assertEqual(self.curl_with_headers(path, "-H", f"Last-Event-ID: {numbers[-1]}")[0], 204)

    def test_a_plan_can_be_had_as_mesh_picture_and_report(self):
        job = self.ended(self.submit(search_of(1))["id"])
        plan = f"/v1/jobs/{job['id']}/plans/1"
        for path, begins in [(plan + "/mesh", b"ply"), (plan + "/mesh?format=obj", b"# coapt"),
                             (plan + "/picture", b"\x89PNG"), (plan + "/report", b"<!DOCTYPE html>"),
                             (job["links"]["report"], b"<!DOCTYPE html>")]:
            with self.subTest(path):
                answer = subprocess.run(["curl", "-sS", self.url + path], capture_output=True)
                self.assertEqual(answer.stdout[:len(begins)], begins)
        self.assert_problem(self.curl(plan + "/mesh?format=exe"), 422, "?format")
        self.assert_problem(self.curl(f"/v1/jobs/{job['id']}/plans/99"), 404)

    def test_a_study_is_a_job_with_files(self):
        status, _, job = self.post("/v1/studies", {"valve": "porcine-3",
                                                   "study": {"name": "annulus"}})
        self.assertEqual(status, 202)
        ended = self.ended(job["id"])
        self.assertEqual(ended["state"], "SUCCEEDED", ended["problems"])
        names = [file["name"] for file in self.curl(ended["links"]["files"])[2]["files"]]
        self.assertIn("annulus.csv", names)
        self.assertEqual(len(self.curl(ended["links"]["result"])[2]["findings"]), ended["findings"])
        self.assert_problem(self.post("/v1/studies", {"valve": "porcine-3", "study": {"name": "x"}}),
                            422, "/study/name")

    def test_problems_of_rules_and_weights_point_into_the_search(self):
        for search, paths in [
                ({"rules": {"forbidden": ["annuloplasty", 1], "most_neochordae": 5, "x": 1},
                  "weights": {"leak": -1, "love": 1, "gap": "x"}},
                 ["/search/rules/forbidden/1", "/search/rules/most_neochordae", "/search/rules/x",
                  "/search/weights/leak", "/search/weights/love", "/search/weights/gap"]),
                ({"rules": {"fixed": {"steps": [{"step": "fly"}]}}}, ["/search/rules/fixed/steps/0/step"]),
                # What only the valve can tell.
                ({"rules": {"forbidden": ["annuloplasty", "rings"], "fixed": {"steps": [
                    {"step": "annuloplasty", "shape": "own", "sizes_below": 2},
                    {"step": "chordal_excision", "chorda": "none"}]}}},
                 ["/search/rules/forbidden/1", "/search/rules/fixed/steps/0", "/search/rules/fixed/steps/1/chorda"]),
                ({"rules": {"forbidden": ["annuloplasty", "papillary_approximation", "neochorda"]}},
                 ["/search/rules"]),
                ({"evaluations": 200000}, ["/search/evaluations"]),
                ({"rules": [], "weights": None}, ["/search/rules", "/search/weights"])]:
            with self.subTest(paths):
                answer = self.post("/v1/plans", {"valve": "human-normal", "search": search})
                self.assert_problem(answer, 422, paths[0])
                self.assertEqual({problem["path"] for problem in answer[2]["problems"]}, set(paths))
        self.assertEqual(self.curl("/v1/jobs")[2]["jobs"], [])

    def test_problems_point_into_the_request(self):
        valve = self.valve("human-normal")
        wrong = valve | {"pressure_kpa": -1}
        self.assert_problem(self.post("/v1/closures", {"valve": wrong}), 422, "/valve/pressure_kpa")
        plan = {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": "none"}]}
        answer = self.post("/v1/closures", {"valve": valve, "plan": plan})
        self.assert_problem(answer, 422, "/plan/steps/0/chorda")
        answer = self.post("/v1/plans", {"valve": valve, "search": {"evaluations": 0}})
        self.assert_problem(answer, 422, "/search/evaluations")
        self.assert_problem(self.post("/v1/plans", {"search": {}}), 422, "/valve")
        self.assert_problem(self.post("/v1/plans", {"valve": valve, "x": 1}), 422, "/x")
        status, _, answer = self.post("/v1/valves:validate", wrong)
        self.assertEqual((status, answer["valid"]), (200, False))
        self.assertEqual(answer["problems"][0]["path"], "/pressure_kpa")

    def test_what_is_not_json_is_400(self):
        for text in ["{", "", "[" * 100000, '{"valve": NaN}']:
            with self.subTest(text[:10]):
                status, _, body = self.post("/v1/plans", text)
                self.assertEqual(status, 400)
                self.assertGreater(len(body["problems"]), 0)

    def test_unknown_paths_and_methods_are_told_apart(self):
        self.assert_problem(self.curl("/v1/nothing"), 404)
        self.assert_problem(self.post("/v1/nothing", {}), 404)
        self.assert_problem(self.curl("/v1/plans"), 405)
        self.assert_problem(self.curl("/v1/plans", "-X", "DELETE"), 405)
        self.assert_problem(self.post("/healthz/live", {}), 405)

    def test_a_body_over_64_MiB_is_413_whether_its_length_is_told_or_not(self):
        large = "[" + " " * (65 * MEBIBYTE) + "]"
        self.assert_problem(self.post("/v1/plans", large), 413)
        self.assert_problem(self.post("/v1/plans", large, "-H", "Transfer-Encoding: chunked"), 413)
        self.assertEqual(self.curl("/healthz/live")[0], 200)

    def test_a_body_without_length_or_in_parts_is_refused(self):
        self.assert_problem(self.curl("/v1/plans", "-X", "POST"), 411)
        self.assert_problem(self.curl("/v1/plans", "-F", "valve=1"), 415)

    def test_an_encoded_body_is_415_whether_it_is_or_not(self):
        for body in [gzip.compress(b'{"valve": {}}'), b"{}"]:
            file = self.folder / "body.gz"
            file.write_bytes(body)
            answer = self.curl("/v1/closures", "-H", "Content-Encoding: gzip", "--data-binary", f"@{file}")
            self.assert_problem(answer, 415)

    def test_what_the_library_refuses_is_answered_in_json(self):
        self.assert_problem(self.curl("/v1/plans", "-X", "BREW"), 400)
        self.assert_problem(self.curl("/" + "v" * 9000), 414)

    def test_a_second_server_on_the_same_port_fails(self):
        second = subprocess.run([SERVER, "--port", str(self.server.port), "--db", self.folder / "b.db"],
                                capture_output=True, text=True, timeout=60)
        self.assertEqual(second.returncode, FAILURE)
        self.assertIn(str(self.server.port), second.stderr)

    def test_other_machines_are_not_let_in_without_a_token(self):
        second = subprocess.run([SERVER, "--host", "0.0.0.0", "--port", "0"], capture_output=True,
                                text=True, timeout=60)
        self.assertEqual(second.returncode, BAD_INPUT)
        self.assertIn("--token-file", second.stderr)


class Limits(ServerTest):
    flags = ("--vertices", "300", "--queue", "1", "--running-jobs", "1")

    def test_a_valve_that_is_too_large_is_refused_everywhere(self):
        valve = json.loads(self.make("human-normal").read_text())
        self.assert_problem(self.post("/v1/closures", {"valve": valve}), 422, "/valve/vertices_mm")
        self.assert_problem(self.post("/v1/valves", valve), 422, "/vertices_mm")

    def test_a_full_queue_is_429_and_says_when_to_try_again(self):
        self.make("human-normal", "--triangles", "150")
        file = self.write("request.json", {
            "valve": json.loads((self.folder / "human-normal.json").read_text()),
            "search": search_of(1, evaluations=50000, region_points=1089)})
        answers = [self.curl_with_headers("/v1/plans", "--data-binary", f"@{file}") for _ in range(3)]
        self.assertEqual(answers[-1][0], 429)
        self.assertGreater(int(answers[-1][1]["retry-after"]), 0)


if __name__ == "__main__":
    unittest.main()
