"""A client that is not ours, curl: examples/requests/search.sh."""

import json
import os
import signal
import subprocess
import unittest

from programs import FAILURE, OK, SERVER, SOURCE, ProgramTest, coapt
from server_runs import Server, search_of

CLIENT = SOURCE / "examples/requests/search.sh"
TOKEN = "open-sesame-2026"


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
        out, err = client.communicate(timeout=300)
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
        out, err = client.communicate(timeout=300)
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


if __name__ == "__main__":
    unittest.main()
