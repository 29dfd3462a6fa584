"""A client that is not ours, curl: examples/requests/search.sh."""

import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import unittest

from process_runs import HANGS_S
from programs import FAILURE, NO_COMPETENT_PLAN, OK, SERVER, SOURCE, ProgramTest, coapt
from server_runs import Server, search_of

CLIENT = SOURCE / "examples/requests/search.sh"
TOKEN = "open-sesame-2026"
SHORT = "--evaluations 12 --plans 1 --region-points 2 --fine-levels 0 --model-draws 0 --no-evidence"


class CurlClient(ProgramTest):
    def setUp(self):
        super().setUp()
        token = self.write("token", TOKEN)
        token.chmod(0o600)
        self.server = Server(SERVER, self.folder / "jobs.sqlite", "--token-file", token)
        self.addCleanup(self.server.kill)
        self.valve = self.make("human-functional-mr")

    def start(self, *arguments, token=TOKEN):
        """In a group of its own, as a shell starts it."""
        surroundings = os.environ | {"COAPT_SERVER": f"http://127.0.0.1:{self.server.port}", "COAPT_TOKEN": token}
        return subprocess.Popen(
            [CLIENT, *map(str, arguments)],
            env=surroundings,
            text=True,
            process_group=0,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    def run_client(self, *arguments, token=TOKEN):
        """Exit code, standard output, standard error."""
        client = self.start(*arguments, token=token)
        out, err = client.communicate(timeout=HANGS_S)
        return client.returncode, out, err

    def get(self, path):
        return self.server.ask("GET", path, headers={"Authorization": f"Bearer {TOKEN}"}).json()

    def test_a_valve_goes_in_and_the_plans_of_the_command_line_come_out(self):
        search = self.write("search.json", search_of(seed=5, evaluations=20, plans=2))
        status, out, err = self.run_client(self.valve, search)
        self.assertEqual(status, OK, err)
        printed = json.loads(coapt("plan", self.valve, "--search", search, "--json").stdout)
        self.assertEqual(len(printed["plans"]), 2)
        for plan in printed["plans"]:
            self.assertIn(f"{plan['rank']:2}. leak {plan['leak_mm2']['nominal']:.1f} mm2", out)
            for line in plan["description"]:
                self.assertIn(line, out)
        self.assertIn("research software", err)

    def test_ctrl_c_ends_the_search_and_prints_the_best_so_far(self):
        search = self.write("search.json", search_of(seed=5, evaluations=100000))
        client = self.start(self.valve, search)
        while not (jobs := self.get("/v1/jobs")["jobs"]):
            self.assertIsNone(client.poll())
        os.killpg(client.pid, signal.SIGINT)
        out, err = client.communicate(timeout=HANGS_S)
        self.assertEqual(client.returncode, OK, err)
        self.assertEqual(self.get(f"/v1/jobs/{jobs[0]['id']}")["state"], "CANCELLED")

    def test_what_the_service_refuses_is_told(self):
        for arguments, token, said in [
            ((self.write("no-valve.json", {"schema": "coapt.valve/1"}),), TOKEN, "vertices_mm"),
            ((self.valve, self.write("search.json", {"plans": 0})), TOKEN, "/search/plans"),
            ((self.valve,), "wrong-token-wrong-token", "401"),
        ]:
            with self.subTest(said):
                status, out, err = self.run_client(*arguments, token=token)
                self.assertEqual((status, out), (FAILURE, ""), err)
                self.assertIn(said, err)


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listening:
        return listening.getsockname()[1]


class DocumentedLines(ProgramTest):
    """Lines of the documents that start a service and ask it, as they stand: but for its port, and for fewer evaluations."""

    def run_lines(self, lines):
        port, programs = free_port(), pathlib.Path(SERVER).parent
        lines = lines.replace("make programs\n", "").replace("build/release/bin/", "").replace(":8080", f":{port}")
        lines = lines.replace("coapt.sqlite &", f"coapt.sqlite --port {port} &")
        lines = lines.replace(
            '200, "plans": 3, "region_points": 65',
            '12, "plans": 3, "region_points": 2, "fine_levels": 0, "model_draws": 0',
        )
        lines = lines.replace("plan human-functional-mr", f"plan human-functional-mr {SHORT}")
        surroundings = {name: value for name, value in os.environ.items() if not name.startswith("COAPT_")}
        run = subprocess.run(
            ["bash", "-c", f"set -eu -o pipefail\ntrap 'kill $(jobs -p)' EXIT\n{lines}"],
            cwd=self.folder,
            env=surroundings | {"PATH": f"{programs}:{os.environ['PATH']}"},
            capture_output=True,
            text=True,
            timeout=HANGS_S,
        )
        self.assertIn(run.returncode, (OK, NO_COMPETENT_PLAN), f"{lines}\n{run.stdout}\n{run.stderr}")
        return run.stdout

    def test_of_the_service(self):
        text = (SOURCE / "docs/engineer/service.md").read_text()
        start, plans = re.findall(r"^```\n(.*?)^```", text, re.MULTILINE | re.DOTALL)[:2]
        self.run_lines(start + plans)
        self.assertEqual(json.loads((self.folder / "job.json").read_text())["state"], "SUCCEEDED")
        self.assertEqual(json.loads((self.folder / "plans.json").read_text())["schema"], "coapt.plans/2")
        self.assertIn("<html", (self.folder / "report.html").read_text())
        self.assertTrue((self.folder / "before-after.png").read_bytes().startswith(b"\x89PNG"))
        self.assertGreater((self.folder / "closed.stl").stat().st_size, 10_000)

    def test_of_the_site_and_of_the_manual_page(self):
        site = (SOURCE / "docs/site/index.md").read_text().split("## Over HTTP\n```\n")[1].split("```")[0]
        manual = (SOURCE / "docs/man/coapt-server.1.scd").read_text().split("# EXAMPLES\n\n\t")[1].split("\n\n")[0]
        for lines in (site, manual.replace("++\n", "\n")):
            self.assertIn('"coapt.closure/2"', self.run_lines(lines))


if __name__ == "__main__":
    unittest.main()
