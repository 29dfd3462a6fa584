"""What release 0.1 wrote still opens: valves, plans, ranked plans, options of a search, a store, a service's database.

tests/kept/0.1 was written by 0.1.0: `coapt valve make human-functional-mr --triangles 150`, plans with each of its steps, `coapt plan
valve.json --evaluations 60 --region-points 17 --plans 2 --no-evidence --seed 1 --store plan.sqlite --json`, and a coapt-server that
was killed with one search done and one running.
"""

import gzip
import json
import unittest

from process_runs import wait_until
from programs import NO_COMPETENT_PLAN, OK, SOURCE, coapt
from server_runs import ServerTest

KEPT = SOURCE / "tests/kept/0.1"
DONE, RUNNING = "bf6d741b0c0f45b36891bea7713231b8", "a156497e1ba07cc9561862651f3cadb5"
VALVE = KEPT / "valve.json"


class Files(ServerTest):
    flags = ("--no-token",)

    def start_server(self, name="service.sqlite", *flags):
        for kept in KEPT.glob("*.gz"):
            (self.folder / kept.stem).write_bytes(gzip.decompress(kept.read_bytes()))
        return super().start_server(name, *flags)

    def answer(self, *arguments):
        run = coapt(*arguments, "--json")
        self.assertIn(run.returncode, (OK, NO_COMPETENT_PLAN), run.stderr)
        return json.loads(run.stdout)

    def test_valves_and_plans(self):
        self.assertEqual(coapt("valve", "check", VALVE).returncode, OK)
        for name in ("plan-own.json", "plan-catalogue.json"):
            self.assertEqual(self.answer("close", VALVE, "--plan", KEPT / name)["status"], "converged")

    def test_ranked_plans_are_scored_again(self):
        kept = json.loads((KEPT / "plans.json").read_text())
        answer = self.answer("evaluate", VALVE, KEPT / "plans.json", "--region-points", "2")
        self.assertCountEqual(
            [plan["plan"]["steps"] for plan in answer["plans"]], [plan["plan"]["steps"] for plan in kept["plans"]]
        )

    def test_a_search_with_kept_options_closes_anew_what_a_store_knows_of_another_version(self):
        answer = self.answer("plan", VALVE, "--search", KEPT / "search.json", "--store", self.folder / "plan.sqlite")
        self.assertEqual((answer["closures_known"], answer["reproduce"]["search"]["evaluations"]), (0, 60))
        again = self.answer("plan", VALVE, "--search", KEPT / "search.json", "--store", self.folder / "plan.sqlite")
        self.assertGreater(again["closures_known"], 60)

    def test_a_service_has_its_valves_and_jobs_and_goes_on_with_a_search(self):
        (valve,) = self.curl("/v1/valves")[2]["valves"]
        self.assertEqual((valve["name"], valve["triangles"]), ("human-functional-mr", 156))
        result = self.curl(f"/v1/jobs/{DONE}/result")[2]
        self.assertEqual((result["schema"], result["version"], len(result["plans"])), ("coapt.plans/1", "0.1.0", 1))
        for name in ("report", "plans/1/report", "plans/1/mesh", "plans/1/picture"):
            status, _, body = self.curl_with_headers(f"/v1/jobs/{DONE}/{name}", "-o", self.folder / "file")
            self.assertEqual((status, body), (200, ""), name)
        wait_until(lambda: self.curl(f"/v1/jobs/{RUNNING}")[2]["state"] == "SUCCEEDED")
        self.assertGreater(len(self.curl(f"/v1/jobs/{RUNNING}/result")[2]["plans"]), 0)


if __name__ == "__main__":
    unittest.main()
