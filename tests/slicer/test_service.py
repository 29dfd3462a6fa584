"""A service is found or started, and asked without waiting; what is wrong with it is said."""

import contextlib
import os
import pathlib
import socket
import threading
import time
import unittest
import unittest.mock

from programs import SERVER
from slicer_runs import Asked, SlicerTest, service


class Finding(Asked):
    def finder(self, settings=None, **environment):
        found = service.Finder(settings, environment)
        self.addCleanup(found.stop)
        return found

    def test_a_server_is_started_with_a_token_of_its_own_and_ends_with_the_module(self):
        finder = self.finder({"server": SERVER})
        found = service.waited(finder.found())
        self.assertIs(service.waited(finder.found()), found)
        self.assertEqual(found.kind, "service")
        stranger = service.Service(found.url)
        said = self.trouble(self.steps(stranger.ask("GET", "/v1/presets")))
        self.assertIn("asks for a token", said)
        folder, process = finder.started.folder, finder.started.process
        self.assertEqual(folder.stat().st_mode & 0o077, 0)
        finder.stop()
        self.assertEqual((process.poll(), folder.exists()), (0, False))

    def test_a_server_that_died_is_started_again(self):
        finder = self.finder({"server": SERVER})
        before = service.waited(finder.found())
        finder.started.process.kill()
        finder.started.process.wait()
        self.assertIsNot(service.waited(finder.found()), before)

    def test_what_is_not_there_is_said(self):
        self.assertIn("There is no coapt here", self.trouble(self.finder(PATH="").found()))
        self.assertIn("cannot be started", self.trouble(self.finder({"server": "/nowhere/coapt-server"}).found()))
        self.assertIn("does not start", self.trouble(self.finder({"server": "/bin/false"}).found()))
        path = os.path.dirname(service.shutil.which("node") or "")
        if path:
            self.assertIn("npm package", self.trouble(self.finder({"module": "/nowhere"}, PATH=path).found()))

    def test_an_address_that_does_not_answer_is_said_at_once(self):
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        begun = time.monotonic()
        said = self.trouble(self.finder({"url": f"http://127.0.0.1:{port}"}).found())
        self.assertRegex(said, f"No service answers at http://127.0.0.1:{port} .*refused")
        self.assertLess(time.monotonic() - begun, service.SILENCE_S)

    def test_addresses_are_checked(self):
        self.assertIn("no address", self.trouble(self.finder({"url": "127.0.0.1:8080"}).found()))
        self.assertIn("not encrypted", self.trouble(self.finder({"url": "http://a.example", "token": "t"}).found()))

    def test_what_is_no_coapt_is_said(self):
        with socket.create_server(("127.0.0.1", 0)) as other:
            threading.Thread(target=self.answer_nonsense, args=(other,), daemon=True).start()
            said = self.trouble(self.finder({"url": f"http://127.0.0.1:{other.getsockname()[1]}"}).found())
        self.assertIn("does not answer as a coapt service does", said)

    def test_an_answer_without_end_is_given_up(self):
        with socket.create_server(("127.0.0.1", 0)) as other, unittest.mock.patch.object(
            service, "MOST_BYTES", 1 << 20
        ):
            threading.Thread(target=self.answer_without_end, args=(other,), daemon=True).start()
            asked = service.Service(f"http://127.0.0.1:{other.getsockname()[1]}").ask("GET", "/v1/presets")
            self.assertIn("answered with more than 1 MiB", self.trouble(self.steps(asked)))

    @staticmethod
    def answer_without_end(listening):
        with listening.accept()[0] as connection, contextlib.suppress(OSError):
            connection.sendall(b"HTTP/1.1 422 No\r\nConnection: close\r\n\r\n")
            while True:
                connection.sendall(b" " * 65536)

    @staticmethod
    def answer_nonsense(listening):
        with listening.accept()[0] as connection:
            connection.recv(4096)
            connection.sendall(b"220 mail.example ESMTP\r\n")

    @staticmethod
    def steps(exchange):
        return (yield exchange)


class Asking(SlicerTest):
    def test_no_poll_waits(self):
        """Neither for an answer that takes a second, nor to send more than a socket takes at once."""
        slow = self.service.ask("POST", "/v1/evaluations", {"valve": "human-functional-mr", "plans": [{"steps": []}]})
        large = self.service.ask("POST", "/v1/closures", {"valve": "x" * (6 << 20)})
        polls = 0
        while not all([slow.poll(), large.poll()]):
            polls += 1
            time.sleep(0.005)
        self.assertGreater(polls, 3)
        with self.assertRaisesRegex(service.Refused, "/plans/0"):
            slow.outcome()
        with self.assertRaises(service.Refused):
            large.outcome()

    def test_every_problem_of_a_request_is_said(self):
        exchange = self.service.ask("POST", "/v1/plans", {"valve": "human-normal", "search": {"plans": 0, "seed": -1}})
        said = self.trouble(iter_of(exchange))
        self.assertIn("/search/plans is 0, must be from 1 to 50", said)
        self.assertIn("/search/seed", said)

    def test_a_request_that_is_dropped_is_no_longer_computed(self):
        task = service.Task(iter_of(self.service.ask("POST", "/v1/closures", {"valve": "human-normal"})))
        task.poll()
        task.cancel()
        self.assertTrue(task.ended)
        self.assertEqual(str(task.error), "Cancelled.")

    def test_a_service_that_stops_between_two_requests_is_said(self):
        self.assertEqual(service.waited(iter_of(self.service.ask("GET", "/v1/presets"))).status, 200)
        self.server.stop()
        self.assertIn("No service answers", self.trouble(iter_of(self.service.ask("GET", "/v1/presets"))))


class Token(SlicerTest):
    def start_server(self, name="jobs.sqlite", *flags):
        self.token = pathlib.Path(self.folder) / "token"
        self.token.write_text("open-sesame-2026\n")
        self.token.chmod(0o600)
        return super().start_server(name, "--token-file", self.token, *flags)

    def test_a_token_opens(self):
        environment = {"COAPT_SERVER": self.url, "COAPT_TOKEN": "open-sesame-2026"}
        self.assertEqual(service.waited(service.Finder({}, environment).found()).url, self.url)
        for wrong in ({}, {"token": "another"}):
            self.assertIn("asks for a token", self.trouble(service.Finder({"url": self.url, **wrong}, {}).found()))


def iter_of(exchange):
    return (yield exchange)


if __name__ == "__main__":
    unittest.main()
