"""What the service keeps no longer, and what it makes of what it keeps."""

import contextlib
import sqlite3
import unittest

from server_runs import ServerTest, search_of


class Retention(ServerTest):
    flags = ("--kept-closures", 1)

    def kept_closures(self):
        with contextlib.closing(sqlite3.connect(self.folder / "jobs.sqlite-plans")) as plans:
            return plans.execute("SELECT count(*) FROM closures").fetchone()[0]

    def searched(self, seed):
        job = self.server.wait_for_end(self.submit(search_of(seed))["id"])
        self.assertEqual(job["state"], "SUCCEEDED")
        return job["id"]

    def reports(self, job_id):
        files = self.curl(f"/v1/jobs/{job_id}/files")[2]["files"]
        pages = {}
        for file in files:
            status, _, pages[file["name"]] = self.curl_with_headers(file["path"])
            self.assertEqual((status, len(pages[file["name"]].encode())), (200, file["bytes"]))
        return pages

    def test_reports_outlive_their_closures_and_the_server_to_the_same_bytes(self):
        job_id = self.searched(1)
        before = self.reports(job_id)
        self.assertIn("report.html", before)
        self.assertIn("plan-1.html", before)
        self.assertIn("data:image/png;base64,iVBOR", before["report.html"])
        self.server.wait_until(job_id, lambda _: self.kept_closures() == 0)
        self.end(self.server)
        self.server = self.start_server()
        self.assertEqual(self.reports(job_id), before)
        self.assertEqual(self.kept_closures(), 0)

    def test_a_search_asked_for_again_comes_to_the_same_plans_without_its_closures(self):
        results = [self.curl(f"/v1/jobs/{self.searched(2)}/plans")[2]["plans"] for _ in range(2)]
        self.assertEqual(results[0], results[1])


if __name__ == "__main__":
    unittest.main()
