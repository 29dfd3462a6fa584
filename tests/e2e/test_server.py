"""What coapt-server answers, asked by curl."""

import gzip
import json
import subprocess
import unittest

from process_runs import HANGS_S
from programs import BAD_INPUT, FAILURE, SERVER, coapt
from server_runs import ServerTest, search_of

MEBIBYTE = 1 << 20


class Answers(ServerTest):
    def valve(self, preset):
        return json.loads(self.make(preset).read_text())

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
            "/v1/valves", "--data-binary", f"@{self.write('valve.json', valve)}"
        )
        stored = json.loads(body)
        self.assertEqual((status, headers["location"]), (201, "/v1/valves/" + stored["id"]))
        self.assertEqual(self.post("/v1/valves", valve)[0], 200)
        self.assertEqual(self.curl(headers["location"])[2], valve)
        answers = [
            self.post("/v1/closures", {"valve": named})[2] | {"seconds": 0}
            for named in (valve, stored["id"], "human-normal")
        ]
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(answers[0], answers[2])
        self.assertEqual(self.curl(headers["location"], "-X", "DELETE")[0], 204)
        self.assert_problem(self.post("/v1/closures", {"valve": stored["id"]}), 422, "/valve")

    def test_plans_are_scored_in_the_order_asked_as_on_the_command_line(self):
        ring = {"step": "annuloplasty", "shape": "generic-classic", "size_mm": 36}
        plans = [{"schema": "coapt.plan/1", "steps": steps} for steps in ([], [ring], [])]
        status, _, answer = self.post(
            "/v1/evaluations", {"valve": "human-functional-mr", "plans": plans, "region_points": 5}
        )
        self.assertEqual(status, 200)
        self.assertEqual([plan["index"] for plan in answer["plans"]], [0, 1, 2])
        self.assertEqual([plan["rank"] for plan in answer["plans"]], [2, 1, 2])
        files = [self.write(f"{i}.json", plans[i]) for i in range(2)]
        printed = json.loads(
            coapt("evaluate", "human-functional-mr", *files, "--no-evidence", "--region-points", 5, "--json").stdout
        )
        for plan in answer["plans"]:
            same = printed["plans"][plan["rank"] - 1]
            self.assertEqual(plan["leak_mm2"], same["leak_mm2"])
            self.assertEqual(plan["cost"], same["cost"])
        many = {"valve": "human-functional-mr", "plans": plans, "region_points": 1089}
        self.assert_problem(self.post("/v1/evaluations", many), 422, "/plans")
        sutures = [
            {"step": "papillary_approximation", "side": side, "anchor": "saddle_peak", "suture_length_mm": 26}
            for side in ("anterolateral", "posteromedial")
        ]
        many = {"valve": "human-functional-mr", "plans": 4 * [plans[0] | {"steps": sutures}], "evidence": True}
        self.assert_problem(self.post("/v1/evaluations", many), 422, "/plans")

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
        second = subprocess.run(
            [SERVER, "--port", str(self.server.port), "--db", self.folder / "b.db"],
            capture_output=True,
            text=True,
            timeout=HANGS_S,
        )
        self.assertEqual(second.returncode, FAILURE)
        self.assertIn(str(self.server.port), second.stderr)

    def test_other_machines_are_not_let_in_without_a_token(self):
        second = subprocess.run(
            [SERVER, "--host", "0.0.0.0", "--port", "0"], capture_output=True, text=True, timeout=HANGS_S
        )
        self.assertEqual(second.returncode, BAD_INPUT)
        self.assertIn("--token-file", second.stderr)

    def test_the_token_that_it_needs_can_be_asked_for(self):
        def printed(*flags):
            command = [SERVER, "--db", self.folder / "t.db", "--print-token", *flags]
            return subprocess.run(command, capture_output=True, text=True, timeout=HANGS_S, check=True).stdout

        self.assertEqual(printed("--no-token"), "\n")
        given = self.write("given", "a token of one's own".replace(" ", "-"))
        given.chmod(0o600)
        self.assertEqual(printed("--token-file", given), "a-token-of-one's-own\n")
        made = printed()
        self.assertEqual(printed(), made)
        kept = self.folder / "t.db-token"  # where others may log in
        self.assertEqual(made, kept.read_text() if kept.exists() else "\n")


class Limits(ServerTest):
    flags = ("--vertices", "300", "--queue", "1", "--running-jobs", "1")

    def test_a_valve_that_is_too_large_is_refused_everywhere(self):
        valve = json.loads(self.make("human-normal").read_text())
        self.assert_problem(self.post("/v1/closures", {"valve": valve}), 422, "/valve/vertices_mm")
        self.assert_problem(self.post("/v1/valves", valve), 422, "/vertices_mm")

    def test_a_full_queue_is_429_and_says_when_to_try_again(self):
        self.make("human-normal", "--triangles", "150")
        file = self.write(
            "request.json",
            {
                "valve": json.loads((self.folder / "human-normal.json").read_text()),
                "search": search_of(1, evaluations=50000, region_points=1089),
            },
        )
        status, _, job = self.curl("/v1/plans", "--data-binary", f"@{file}")
        self.assertEqual(status, 202)
        # Until it runs it waits in the queue itself.
        self.server.wait_until(job["id"], lambda one: one["state"] == "RUNNING")
        self.assertEqual(self.curl("/v1/plans", "--data-binary", f"@{file}")[0], 202)
        status, headers, _ = self.curl_with_headers("/v1/plans", "--data-binary", f"@{file}")
        self.assertEqual(status, 429)
        self.assertGreater(int(headers["retry-after"]), 0)


if __name__ == "__main__":
    unittest.main()
