"""coapt-server, asked by curl."""

import gzip
import json
import re
import signal
import subprocess
import unittest

from programs import FAILURE, OK, SERVER, ProgramTest, coapt

MEBIBYTE = 1 << 20


class Server(ProgramTest):
    def setUp(self):
        super().setUp()
        self.server = subprocess.Popen([SERVER, "--port", "0"], stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        self.url = re.search(r"http://127\.0\.0\.1:\d+", self.server.stderr.readline()).group()

    def stop(self):
        self.server.send_signal(signal.SIGTERM)
        self.assertEqual(self.server.wait(timeout=60), OK)
        self.server.stderr.close()

    def curl(self, path, *arguments):
        """Status, content type and JSON of the answer."""
        result = subprocess.run(
            ["curl", "--silent", "--show-error", "--max-time", "200",
             "--write-out", "\n%{http_code} %{content_type}", *map(str, arguments), self.url + path],
            capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        body, _, meta = result.stdout.rpartition("\n")
        status, content_type = meta.split(" ", 1)
        return int(status), content_type, json.loads(body)

    def post(self, path, request, *arguments):
        content = request if isinstance(request, str) else json.dumps(request)
        file = self.write("request.json", content)
        return self.curl(path, *arguments, "-H", "Content-Type: application/json",
                         "--data-binary", f"@{file}")

    def assert_problem(self, answer, status, path=""):
        got_status, content_type, body = answer
        self.assertEqual((got_status, content_type), (status, "application/problem+json"), body)
        self.assertEqual(body["status"], status)
        self.assertIn(path, [problem["path"] for problem in body["problems"]])

    def test_it_is_alive(self):
        self.assertEqual(self.curl("/healthz/live"), (200, "application/json", {"status": "live"}))

    def test_a_closure_is_the_one_of_the_command_line(self):
        valve = json.loads(self.make("human-normal").read_text())
        status, _, answer = self.post("/v1/closures", {"valve": valve})
        printed = json.loads(coapt("close", "human-normal", "--json").stdout)
        self.assertEqual(status, 200)
        self.assertEqual(answer | {"seconds": 0}, printed | {"seconds": 0})

    def test_a_search_is_the_one_of_the_command_line(self):
        valve = json.loads(self.make("human-functional-mr").read_text())
        search = {"evaluations": 6, "seed": 5, "plans": 1, "region_points": 2, "evidence": False,
                  "rules": {"forbidden": ["annuloplasty:own"], "suture_lattice_mm": 2},
                  "weights": {"movement": 0.5}}
        status, _, answer = self.post("/v1/plans", {"valve": valve, "search": search})
        self.assertEqual(status, 200)
        self.assertEqual(answer["evaluations"], 6)
        self.assertEqual(len(answer["plans"]), 1)
        printed = json.loads(coapt("plan", "human-functional-mr", "--search",
                                   self.write("search.json", search), "--json").stdout)
        # A request has no command line.
        self.assertEqual((answer["reproduce"].pop("command"), bool(printed["reproduce"].pop("command"))),
                         ("", True))
        self.assertEqual(answer | {"seconds": 0}, printed | {"seconds": 0})

    def test_problems_of_rules_and_weights_point_into_the_search(self):
        valve = json.loads(self.make("human-normal").read_text())
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
                ({"rules": [], "weights": None}, ["/search/rules", "/search/weights"])]:
            with self.subTest(paths):
                answer = self.post("/v1/plans", {"valve": valve, "search": search})
                self.assert_problem(answer, 422, paths[0])
                self.assertEqual({problem["path"] for problem in answer[2]["problems"]}, set(paths))

    def test_problems_point_into_the_request(self):
        valve = json.loads(self.make("human-normal").read_text())
        wrong = valve | {"pressure_kpa": -1}
        self.assert_problem(self.post("/v1/closures", {"valve": wrong}), 422, "/valve/pressure_kpa")
        plan = {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": "none"}]}
        answer = self.post("/v1/closures", {"valve": valve, "plan": plan})
        self.assert_problem(answer, 422, "/plan/steps/0/chorda")
        answer = self.post("/v1/plans", {"valve": valve, "search": {"evaluations": 0}})
        self.assert_problem(answer, 422, "/search/evaluations")
        self.assert_problem(self.post("/v1/plans", {"search": {}}), 422, "/valve")
        self.assert_problem(self.post("/v1/plans", {"valve": valve, "x": 1}), 422, "/x")

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
        port = self.url.rpartition(":")[2]
        second = subprocess.run([SERVER, "--port", port], capture_output=True, text=True, timeout=60)
        self.assertEqual(second.returncode, FAILURE)
        self.assertIn(port, second.stderr)


if __name__ == "__main__":
    unittest.main()
