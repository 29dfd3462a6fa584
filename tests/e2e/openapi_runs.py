"""A server whose answers are compared with its own document."""

import re

from openapi_document import Document
from process_runs import HANGS_S
from programs import SERVER, ProgramTest
from server_runs import Server

WAIT = {"Prefer": f"wait={HANGS_S}"}


class OpenApiTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.server = self.start("jobs.sqlite", "--wait-seconds", HANGS_S)
        self.document = Document(self.server.ask("GET", "/openapi.json").body)
        # What stands for the parameters of paths.
        self.place = {"preset": "human-functional-mr", "rank": "1", "file": "report.html"}

    def start(self, name, *flags):
        server = Server(SERVER, self.folder / name, *flags)
        self.addCleanup(server.kill)
        return server

    def send(self, id, body=None, headers=None, query=""):
        """The answer to an operation, which must be as the document says."""
        operation = self.document.operations[id]
        path = re.sub(r"{(\w+)}", lambda name: self.place[name[1]], operation.path)
        reply = self.server.ask(operation.method, path + query, body, headers, 2 * HANGS_S)
        self.assertEqual(self.document.problems_of_answer(operation, reply), [], f"{id}: {reply.body[:500]}")
        return reply

    def send_example(self, id, name):
        """The answer to an example, with the status of the answer's example."""
        operation = self.document.operations[id]
        status = self.document.status_of_example(operation, name)
        wait = (
            WAIT
            if (operation.path, status) in [(f"/v1/{kind}", 200) for kind in ("plans", "studies", "imports")]
            else None
        )
        reply = self.send(id, self.document.requests(operation)[name], wait)
        self.assertEqual(reply.status, status, reply.body[:500])
        return reply

    def store_valve(self):
        self.place["valve"] = self.send_example("createValve", "small_valve").json()["id"]

    def keep_plan(self):
        self.place["kept_plan"] = self.send_example("keepPlan", "small_ring").json()["kept_plan"]

    def finish_search(self):
        self.store_valve()
        self.keep_plan()
        self.place["job"] = self.send_example("searchPlans", "small_search").json()["id"]
