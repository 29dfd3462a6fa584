"""Searches and studies."""

import json
import unittest

import coapt
from client_runs import ENDLESS, SMALL, VALVE, ClientTest, both
from coapt import OwnRing, Plan
from programs import coapt as coapt_command, small_valve


@both
class Searches(ClientTest):
    def test_a_search_finds_the_plans_of_the_command_line(self):
        seen, search = [], SMALL | {"fine_levels": 1, "model_draws": 8}
        job = self.client.search(VALVE, **search, forbidden=["annuloplasty:own"], weights={"movement": 0.5})
        result = job.wait(progress=seen.append).result()
        search |= {"rules": {"forbidden": ["annuloplasty:own"]}, "weights": {"movement": 0.5}}
        printed = json.loads(
            coapt_command("plan", VALVE, "--search", self.write("search.json", search), "--json").stdout
        )
        self.assertEqual([plan.json for plan in result.plans], printed["plans"])
        self.assertEqual((result.stop, result.closures), (printed["stop"], printed["closures"]))
        best = result.plans[0]
        self.assertEqual(best.plan.to_json(), printed["plans"][0]["plan"])
        self.assertEqual(best.leak_mm2.mean, printed["plans"][0]["leak_mm2"]["mean"])
        self.assertEqual((job.state, job.kind), ("SUCCEEDED", "plans"))
        self.assertEqual(len(seen), len([event for event in job.events() if event.progress]))
        leading = job.progress.best
        self.assertEqual(
            (leading.plan, leading.description, leading.leak_mm2), (best.plan, best.description, best.leak_mm2.nominal)
        )

    def test_events_tell_all_from_the_beginning_and_go_on_after_one_that_is_known(self):
        job = self.client.search(VALVE, **SMALL)
        events = list(job.events())
        self.assertEqual([event.number for event in events], list(range(1, len(events) + 1)))
        self.assertEqual([event.state for event in events if event.state], ["QUEUED", "RUNNING", "SUCCEEDED"])
        self.assertEqual(list(job.events(after=2)), events[2:])
        self.assertEqual(list(job.events(after=len(events))), [])

    def test_fixed_steps_are_in_every_plan(self):
        result = self.client.search(VALVE, **SMALL, fixed=Plan(OwnRing(2)), rules={"most_movement_mm": 5}).result()
        self.assertEqual({OwnRing(2)} & set(result.plans[0].plan.steps), {OwnRing(2)})
        self.assertEqual(result.json["reproduce"]["search"]["rules"]["most_movement_mm"], 5)

    def test_a_plan_is_had_as_picture_mesh_and_report(self):
        job = self.client.search(small_valve(), **SMALL)
        best = job.result().plans[0]
        best.picture().write(self.folder / "picture.png")
        self.assertEqual((self.folder / "picture.png").read_bytes()[:4], b"\x89PNG")
        self.assertTrue(best.mesh("obj").startswith(b"# coapt"))
        self.assertTrue(best.report().startswith("<!DOCTYPE html>"))
        self.assertTrue(job.report().startswith("<!DOCTYPE html>"))
        self.assertEqual(job.files()["report.html"], len(job.file("report.html")))
        valve, leaflets = json.loads(small_valve().read_text()), best.leaflets()
        self.assertEqual(
            (len(leaflets.vertices_mm), len(leaflets.faces)), (len(valve["vertices_mm"]), len(valve["faces"]))
        )
        self.assertEqual(max(max(face) for face in leaflets.faces), len(valve["vertices_mm"]) - 1)
        self.assertEqual([("?format", "unsupported")], self.problems(coapt.InvalidRequest, best.mesh, "exe"))

    def test_a_cancelled_search_has_its_best_so_far(self):
        job = self.client.search(VALVE, **ENDLESS)
        for event in job.events():
            if event.progress and event.progress.closures > 20:
                job.cancel()
                break
        self.assertEqual(job.wait().state, "CANCELLED")
        self.assertEqual((job.result().stop, job.result().plans[0].rank), ("cancelled", 1))
        self.assertEqual([one.id for one in self.client.jobs(state="CANCELLED")], [job.id])
        job.delete()
        self.assertEqual(self.refused(coapt.NotFound, job.refresh).status, 404)

    def test_waiting_ends_in_time_and_the_job_goes_on(self):
        job = self.client.search(VALVE, **ENDLESS)
        self.refused(coapt.NotEnded, job.wait, timeout_s=1.5)
        self.assertFalse(self.client.job(job.id).ended)
        self.assertEqual(self.refused(coapt.Conflict, job.delete).status, 409)
        job.cancel()

    def test_jobs_are_listed_newest_first_and_found_again(self):
        ids = [self.client.search(VALVE, **SMALL | {"seed": seed}).id for seed in range(3)]
        self.assertEqual([job.id for job in self.client.jobs()], ids[::-1])
        self.assertEqual(self.client.job(ids[0]).result().plans[0].rank, 1)

    def test_a_bad_search_is_refused_with_the_place_of_each_problem(self):
        self.assertEqual(
            sorted(
                self.problems(coapt.InvalidRequest, self.client.search, VALVE, plans=0, forbidden=["x"], target_mm2=-2)
            ),
            [("/search/plans", "out_of_range"), ("/search/target_mm2", "out_of_range")],
        )
        self.refused(coapt.InvalidRequest, self.client.search, "no-such-valve")


class Limited(ClientTest):
    flags = ("--seconds", 1)

    def test_a_study_that_takes_too_long_fails_and_says_why(self):
        job = self.client.study("porcine-thesis", "thesis")
        error = self.refused(coapt.JobFailed, job.wait)
        self.assertEqual([(problem.path, problem.code) for problem in error.problems], [("/study", "out_of_range")])
        self.assertEqual(self.refused(coapt.Conflict, job.report).status, 409)


@both
class Studies(ClientTest):
    def test_a_study_has_findings_and_files(self):
        job = self.client.study(small_valve("porcine-3"), "annulus")
        result = job.result()
        self.assertEqual((result.study, result.valve), ("annulus", "porcine-3"))
        self.assertEqual(sum(finding.agrees for finding in result.findings), result.json["agree"])
        self.assertIn("annulus.csv", job.files())
        self.assertTrue(job.report().startswith("<!DOCTYPE html>"))
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.client.study, "porcine-3", "annulus", scan_sites=3),
            [("/study/scan_sites", "unknown_field")],
        )


if __name__ == "__main__":
    unittest.main()
