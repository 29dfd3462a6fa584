"""Each problem among the document's examples is provoked, and its answer is that very example."""

import unittest

from openapi_document import PROBLEM
from openapi_runs import OpenApiTest
from server_runs import search_of

PRESET = "human-functional-mr"
TOKEN = "open-sesame-2026"
LONG_SEARCH = {"valve": PRESET, "search": search_of(seed=3, evaluations=100000)}
SLACK_SUTURE = {
    "step": "papillary_approximation",
    "side": "posteromedial",
    "anchor": "saddle_peak",
    "suture_length_mm": 90,
}
JSON = {"Content-Type": "application/json"}


def plan(*steps):
    return {"schema": "coapt.plan/1", "steps": list(steps)}


class Problems(OpenApiTest):
    def start_strict(self):
        """A server that asks for a token, takes small bodies and few jobs, and opens no streams."""
        token = self.write("token", TOKEN)
        token.chmod(0o600)
        return self.start(
            "strict.sqlite",
            "--token-file",
            token,
            "--queue",
            1,
            "--running-jobs",
            1,
            "--body-bytes",
            2048,
            "--streams",
            0,
            "--kept-plans",
            0,
        )

    def provoked(self):
        """The answer to each request that is to fail, by the name of its example."""
        ask = self.server.ask
        strict = self.start_strict()
        bearer = {"Authorization": f"Bearer {TOKEN}"}

        def ask_strict(method, path, body=None, **headers):
            return strict.ask(method, path, body, bearer | headers)

        running = ask_strict("POST", "/v1/plans", LONG_SEARCH).json()["id"]
        strict_valve = ask_strict("GET", f"/v1/jobs/{running}").json()["valve"]
        while ask_strict("GET", f"/v1/jobs/{running}").json()["state"] == "QUEUED":
            pass
        queued = ask_strict("POST", "/v1/plans", LONG_SEARCH).json()["id"]
        return {
            "no_json": ask("POST", "/v1/closures", '{"valve": ', JSON),
            "missing_fields": ask("POST", "/v1/valves", {"schema": "coapt.valve/1", "name": "nothing else"}),
            "no_chordae": ask(
                "POST", "/v1/valves:import", self.document.json["components"]["examples"]["no_chordae"]["value"]
            ),
            "impossible_step": ask(
                "POST",
                "/v1/closures",
                {
                    "valve": PRESET,
                    "plan": plan(SLACK_SUTURE),
                },
            ),
            "too_many_closures": ask(
                "POST", "/v1/evaluations", {"valve": PRESET, "plans": [plan(), plan()], "region_points": 600}
            ),
            "bad_search": ask(
                "POST", "/v1/plans", {"valve": PRESET, "search": {"plans": 0, "weights": {"leak": -1, "love": 1}}}
            ),
            "unknown_study": ask("POST", "/v1/studies", {"valve": PRESET, "study": {"name": "everything"}}),
            "bad_query": ask("GET", "/v1/jobs?page_size=0&state=ASLEEP"),
            "bad_page": ask("GET", f"/v1/jobs/{queued}/plans?page_size=0"),
            "unknown_format": ask("GET", f"/v1/jobs/{queued}/plans/1/mesh?format=gif"),
            "no_such_job": ask("GET", f"/v1/jobs/{queued}"),
            "valve_in_use": ask_strict("DELETE", f"/v1/valves/{strict_valve}"),
            "not_ended": ask_strict("DELETE", f"/v1/jobs/{queued}"),
            "no_results_yet": ask_strict("GET", f"/v1/jobs/{queued}/result"),
            "queue_full": ask_strict("POST", "/v1/plans", LONG_SEARCH),
            "too_many_kept": ask_strict("POST", "/v1/kept-plans", {"name": "A ring", "valve": PRESET, "plan": plan()}),
            "impossible_kept": ask(
                "POST",
                "/v1/kept-plans",
                {"name": "A suture", "valve": PRESET, "plan": plan(SLACK_SUTURE)},
            ),
            "no_name": ask("PATCH", f"/v1/kept-plans/{queued}", {"name": ""}),
            "no_token": strict.ask("GET", "/v1/jobs"),
            "foreign_page": ask("GET", "/v1/jobs", headers={"Origin": "https://example.org"}),
            "foreign_host": ask("GET", "/v1/jobs", headers={"Host": "example.org"}),
            "no_farm": ask("GET", "/v1/farm"),
            "no_such_path": ask("GET", "/v1/nothing"),
            "no_such_method": ask("GET", "/v1/plans"),
            "too_large": ask_strict("POST", "/v1/closures", " " * 4000),
            "encoded": ask("POST", "/v1/closures", "{}", {"Content-Encoding": "gzip"}),
            "too_many_streams": ask_strict("GET", f"/v1/jobs/{queued}/events"),
        }

    def test_every_problem_of_the_document_is_a_real_one(self):
        replies = self.provoked()
        examples = {}
        for operation in self.document.operations.values():
            for response in operation.json["responses"].values():
                content = self.document.resolved(response).get("content", {})
                examples |= self.document.examples({PROBLEM: content.get(PROBLEM, {})})
        self.assertEqual(set(examples), set(replies))
        for name, reply in replies.items():
            with self.subTest(name):
                self.assertEqual(reply.headers["content-type"], PROBLEM)
                self.assertEqual(reply.json(), examples[name])
                self.assertEqual(reply.status, examples[name]["status"])


if __name__ == "__main__":
    unittest.main()
