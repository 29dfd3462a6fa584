"""What earlier releases wrote still opens: valves, plans, ranked plans, options of a search, a store, a service's database.

tests/kept/VERSION was written by that release: `coapt valve make human-functional-mr --triangles 150`, plans with steps of each kind,
`coapt plan valve.json --search search.json --store plan.sqlite --json` (60 evaluations, 2 plans), and a coapt-server that was killed
with one search done and one running.
"""

import gzip
import json
import unittest

from process_runs import wait_until
from programs import NO_COMPETENT_PLAN, OK, SOURCE, coapt
from server_runs import ServerTest


class Kept:
    flags = ("--no-token",)
    version, done, running = "", "", ""

    def setUp(self):
        self.kept = SOURCE / "tests/kept" / self.version.removesuffix(".0")
        self.valve = self.kept / "valve.json"
        super().setUp()

    def start_server(self, name="service.sqlite", *flags):
        for kept in self.kept.glob("*.gz"):
            (self.folder / kept.stem).write_bytes(gzip.decompress(kept.read_bytes()))
        return super().start_server(name, *flags)

    def answer(self, *arguments):
        run = coapt(*arguments, "--json")
        self.assertIn(run.returncode, (OK, NO_COMPETENT_PLAN), run.stderr)
        return json.loads(run.stdout)

    def test_valves_and_plans(self):
        self.assertEqual(coapt("valve", "check", self.valve).returncode, OK)
        for plan in self.kept.glob("plan-*.json"):
            self.assertEqual(self.answer("close", self.valve, "--plan", plan)["status"], "converged")

    def test_ranked_plans_are_scored_again(self):
        kept = json.loads((self.kept / "plans.json").read_text())
        answer = self.answer("evaluate", self.valve, self.kept / "plans.json", "--region-points", "2")
        self.assertCountEqual(
            [plan["plan"]["steps"] for plan in answer["plans"]], [plan["plan"]["steps"] for plan in kept["plans"]]
        )

    def test_a_search_with_kept_options_closes_anew_what_a_store_knows_of_another_version(self):
        answer = self.answer(
            "plan", self.valve, "--search", self.kept / "search.json", "--store", self.folder / "plan.sqlite"
        )
        self.assertEqual((answer["closures_known"], answer["reproduce"]["search"]["evaluations"]), (0, 60))
        again = self.answer(
            "plan", self.valve, "--search", self.kept / "search.json", "--store", self.folder / "plan.sqlite"
        )
        self.assertGreater(again["closures_known"], 60)

    def test_a_service_has_its_valves_and_jobs_and_goes_on_with_a_search(self):
        (valve,) = self.curl("/v1/valves")[2]["valves"]
        self.assertEqual((valve["name"], valve["triangles"]), ("human-functional-mr", 156))
        result = self.curl(f"/v1/jobs/{self.done}/result")[2]
        self.assertEqual(
            (result["schema"], result["version"], len(result["plans"])), ("coapt.plans/1", self.version, 1)
        )
        for name in ("report", "plans/1/report", "plans/1/mesh", "plans/1/picture"):
            status, _, body = self.curl_with_headers(f"/v1/jobs/{self.done}/{name}", "-o", self.folder / "file")
            self.assertEqual((status, body), (200, ""), name)
        job = self.kept_job()
        while job["state"] in ("QUEUED", "RUNNING"):  # for as long as it goes on
            before = (job["state"], job["progress"])
            wait_until(lambda: (self.kept_job()["state"], self.kept_job()["progress"]) != before)
            job = self.kept_job()
        self.assertEqual(job["state"], "SUCCEEDED")
        self.assertGreater(len(self.curl(f"/v1/jobs/{self.running}/result")[2]["plans"]), 0)

    def kept_job(self):
        return self.curl(f"/v1/jobs/{self.running}")[2]


class FilesOf01(Kept, ServerTest):
    version = "0.1.0"
    done, running = "bf6d741b0c0f45b36891bea7713231b8", "a156497e1ba07cc9561862651f3cadb5"


class FilesOf02(Kept, ServerTest):
    version = "0.2.0"
    done, running = "1a5ba957ef80165ebfcdd11936153c4d", "3797a02f248a463609e81eb8f5f92968"


if __name__ == "__main__":
    unittest.main()
