"""A coapt-server for each test: on a free port, with a file of jobs of its own, asked by curl."""

import json
import subprocess

from programs import OK, SERVER, ProgramTest
from served import Server, search_of  # noqa: F401 (found through programs; search_of for the tests)


class ServerTest(ProgramTest):
    """`flags` of the class are given to the server that each test starts with."""

    flags = ()

    def setUp(self):
        super().setUp()
        self.server = self.start_server()

    def start_server(self, name="jobs.sqlite", *flags):
        """A server with the flags of the class and these; stopped at the end if it still runs."""
        server = Server(SERVER, self.folder / name, *self.flags, *flags)
        self.addCleanup(self.end, server)
        return server

    def end(self, server):
        if server.process.poll() is None:
            self.assertEqual(server.stop(), OK, server.messages.read_text())

    @property
    def url(self):
        return f"http://127.0.0.1:{self.server.port}"

    def curl(self, path, *arguments):
        """Status, content type and JSON of the answer."""
        status, headers, body = self.curl_with_headers(path, *arguments)
        return status, headers.get("content-type", ""), json.loads(body) if body else None

    def curl_with_headers(self, path, *arguments):
        """Status, headers by their names in lower case, and the text of the answer."""
        head = self.folder / "head.txt"
        result = subprocess.run(
            [
                "curl",
                "--silent",
                "--show-error",
                "--max-time",
                "200",
                "--dump-header",
                head,
                *map(str, arguments),
                path if "://" in path else self.url + path,
            ],
            capture_output=True,
            text=True,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        # The last of them: 100 Continue may stand before it.
        first, *lines = head.read_text().strip().split("\n\n")[-1].splitlines()
        headers = dict(line.split(":", 1) for line in lines if ":" in line)
        headers = {name.lower(): value.strip() for name, value in headers.items()}
        return int(first.split()[1]), headers, result.stdout

    def post(self, path, request, *arguments):
        content = request if isinstance(request, str) else json.dumps(request)
        file = self.write("request.json", content)
        return self.curl(path, *arguments, "-H", "Content-Type: application/json", "--data-binary", f"@{file}")

    def submit(self, search, valve="human-functional-mr"):
        """The new job of a search."""
        status, _, job = self.post("/v1/plans", {"valve": valve, "search": search})
        self.assertEqual(status, 202, job)
        return job

    def assert_problem(self, answer, status, path=""):
        got_status, content_type, body = answer
        self.assertEqual((got_status, content_type), (status, "application/problem+json"), body)
        self.assertEqual(body["status"], status)
        self.assertIn(path, [problem["path"] for problem in body["problems"]])
