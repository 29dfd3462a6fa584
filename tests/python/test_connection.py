"""Tokens, services that are busy, connections that break."""

import socket
import threading
import unittest
import unittest.mock
from dataclasses import replace

import coapt
from client_runs import ENDLESS, SMALL, TOKEN, VALVE, ClientTest
from coapt.jobs import Job
from programs import ProgramTest
from relay import Relay


class Tokens(ClientTest):
    def setUp(self):
        token = self.write_token()
        self.flags = ("--token-file", token)
        super().setUp()

    def write_token(self):
        ProgramTest.setUp(self)
        token = self.write("token", TOKEN)
        token.chmod(0o600)
        return token

    def test_only_those_with_the_token_come_in(self):
        for token in (None, "wrong-token-wrong-token"):
            error = self.refused(coapt.AccessDenied, coapt.Client(self.url, token).presets)
            self.assertEqual(error.status, 401)
        self.assertIn(VALVE, coapt.Client(self.url, TOKEN).presets())
        self.assertEqual(
            list(coapt.Client(self.url, TOKEN).search(VALVE, **SMALL).events())[-1].state,
            "SUCCEEDED",
        )

    def test_a_token_is_not_shown(self):
        self.assertNotIn(TOKEN, repr(coapt.Client(self.url, TOKEN)._transport))


class Busy(ClientTest):
    flags = ("--queue", 1, "--running-jobs", 1)

    def fill(self):
        """A job that runs, one that waits: there is no place for another."""
        running = self.client.search(VALVE, **ENDLESS)
        next(event for event in running.events() if event.state == "RUNNING")
        self.addCleanup(running.cancel)
        return self.client.search(VALVE, **ENDLESS | {"seed": 9})

    def client_that_sleeps(self, sleep, **options):
        client = coapt.Client(self.url, **options)
        object.__setattr__(client._transport, "sleep", sleep)
        return client

    def test_a_full_queue_is_tried_again_when_the_service_says(self):
        waiting, pauses = self.fill(), []

        def sleep(seconds):
            pauses.append(seconds)
            waiting.cancel()

        job = self.client_that_sleeps(sleep).search(VALVE, **ENDLESS)
        self.assertEqual(job.cancel().state, "CANCELLED")
        said = self.retry_after()
        self.assertEqual(pauses, [said])

    def retry_after(self):
        """What the service says in Retry-After when its queue is full."""
        waiting = self.client.search(VALVE, **ENDLESS)
        self.addCleanup(waiting.cancel)
        return self.refused(coapt.Busy, coapt.Client(self.url, retries=0).search, VALVE, **ENDLESS).retry_after_s

    def test_a_queue_that_stays_full_is_an_error(self):
        self.addCleanup(self.fill().cancel)
        pauses = []
        client = self.client_that_sleeps(pauses.append, retries=2)
        error = self.refused(coapt.Busy, client.search, VALVE, **ENDLESS)
        self.assertEqual((error.status, len(pauses)), (429, 2))
        self.assertEqual(pauses, [error.retry_after_s] * 2)


class Streams(ClientTest):
    flags = ("--streams", 0)

    def test_a_job_that_cannot_be_followed_is_not_lost(self):
        job = self.client.search(VALVE, **SMALL)
        self.refused(coapt.NotEnded, job.wait, timeout_s=1)
        self.server.wait_for_end(job.id)
        self.assertEqual(job.refresh().result().plans[0].rank, 1)


class Broken(ClientTest):
    def setUp(self):
        super().setUp()
        self.relay = Relay(self.server.port)
        self.addCleanup(self.relay.close)
        self.remote = coapt.Client(f"http://127.0.0.1:{self.relay.port}")

    def test_a_lost_answer_makes_no_second_job(self):
        self.relay.drop_answers = 1
        job = self.remote.search(VALVE, **SMALL)
        self.assertEqual(self.relay.connections, 2)
        self.assertEqual([one.id for one in self.client.jobs()], [job.id])

    def test_a_key_of_ones_own_finds_the_job_again(self):
        first = self.client.search(VALVE, **SMALL, idempotency_key="mine")
        self.assertEqual(self.client.search(VALVE, **SMALL, idempotency_key="mine").id, first.id)
        self.refused(
            coapt.InvalidRequest,
            self.client.search,
            VALVE,
            **ENDLESS,
            idempotency_key="mine",
        )
        self.assertNotEqual(self.client.search(VALVE, **SMALL).id, first.id)

    def test_events_go_on_over_streams_that_break_off(self):
        self.relay.cut_after = 600
        job = self.remote.search(VALVE, **SMALL | {"evaluations": 20})
        object.__setattr__(job._transport, "sleep", lambda seconds: None)
        numbers = [event.number for event in job.events()]
        self.relay.cut_after = None
        self.assertEqual(numbers, [event.number for event in job.events()])
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        self.assertGreater(self.relay.connections, 3)

    def test_a_job_is_followed_over_the_death_of_its_service(self):
        job = self.remote.search(VALVE, **SMALL | {"evaluations": 20})
        numbers = []
        for event in job.events():
            numbers.append(event.number)
            if len(numbers) == 4:
                self.server.kill()
                self.server = self.start_server()
                self.relay.target = self.server.port
        self.assertEqual(event.state, "SUCCEEDED")
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))

    def test_a_service_that_is_not_there_is_an_error(self):
        self.server.stop()
        pauses = []
        object.__setattr__(self.client._transport, "sleep", pauses.append)
        with self.assertRaisesRegex(coapt.Unreachable, self.url):
            self.client.presets()
        self.assertEqual(pauses, [0.25, 0.5, 1.0])


class Words(unittest.TestCase):
    """What is said of a service that does not answer."""

    def said(self, url, **options):
        with self.assertRaises(coapt.Unreachable) as raised:
            coapt.Client(url, retries=0, **options).presets()
        return str(raised.exception)

    def answering(self, answer):
        """The address of a service that answers each request with these bytes, or with none if they are None."""
        listener = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listener.close)
        held = []

        def serve():
            connection, _ = listener.accept()
            connection.recv(4096)
            held.append(connection)
            if answer is not None:
                connection.sendall(answer)
                connection.close()

        thread = threading.Thread(target=serve)
        thread.start()
        self.addCleanup(lambda: [connection.close() for connection in held])
        self.addCleanup(thread.join)
        return f"127.0.0.1:{listener.getsockname()[1]}"

    def test_nothing_listens(self):
        with socket.create_server(("127.0.0.1", 0)) as listener:
            url = f"http://127.0.0.1:{listener.getsockname()[1]}"
        self.assertEqual(
            self.said(url),
            f"nothing listens at {url}: connection refused; is coapt-server running?",
        )

    def test_there_is_no_such_machine(self):
        self.assertIn(
            "there is no host named nowhere.invalid",
            self.said("http://nowhere.invalid"),
        )

    def test_no_answer_in_time(self):
        url = f"http://{self.answering(None)}"
        self.assertEqual(self.said(url, timeout_s=0.1), f"{url} did not answer in time")

    def test_the_connection_breaks_off(self):
        for answer in (b"", b"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\n{"):
            self.assertIn(
                " closed the connection: ",
                self.said(f"http://{self.answering(answer)}"),
            )

    def test_no_https_is_spoken(self):
        self.assertIn(
            " does not support https: ",
            self.said(f"https://{self.answering(b'HTTP/1.1 400 Bad request')}"),
        )


class Addresses(unittest.TestCase):
    def test_a_token_does_not_go_unencrypted_to_another_machine(self):
        for url in ("http://plans.invalid", "http://localhost.plans.invalid:8080"):
            with self.assertRaisesRegex(coapt.CoaptError, "not encrypted"):
                coapt.Client(url, TOKEN)
            coapt.Client(url, TOKEN, plain_http=True)
            coapt.Client(url)
        for url in (
            "https://plans.invalid",
            "http://localhost:8080",
            "http://127.0.0.1",
            "http://[::1]:8080",
        ):
            coapt.Client(url, TOKEN)

    def test_an_address_that_is_none_is_refused_at_once(self):
        for url in ("localhost:8080", "ftp://localhost", "http://"):
            with self.assertRaisesRegex(coapt.CoaptError, "http://127"):
                coapt.Client(url)


MOVES = "[\\x00-\\x09\\x0b-\\x1f\\x7f-\\x9f\u202e]"


class Hostile(unittest.TestCase):
    """A service that is not one's own."""

    def served(self, answer):
        listening = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listening.close)

        def serve():
            connection, _ = listening.accept()
            with connection:
                connection.recv(65536)
                connection.sendall(answer)

        threading.Thread(target=serve, daemon=True).start()
        return coapt.Client(f"http://127.0.0.1:{listening.getsockname()[1]}", retries=0)

    def test_an_answer_has_a_limit_and_so_has_a_refusal(self):
        for status in ("200 OK", "422 No"):
            for length in ("Content-Length: 2000", "Connection: close"):
                with self.subTest(status=status, length=length):
                    client = self.served(f"HTTP/1.1 {status}\r\n{length}\r\n\r\n".encode() + b" " * 2000)
                    with unittest.mock.patch("coapt.http_transport._MOST_BYTES", 1000), self.assertRaises(
                        coapt.Unreachable
                    ) as raised:
                        client.presets()
                    self.assertIn("answered with more than", str(raised.exception))

    def test_its_words_do_not_move_the_terminal(self):
        body = b'{"title": "\\u001b[2J", "problems": [{"message": "\\u001b]0;pwned\\u0007\\u009b31m\\u202e"}]}'
        client = self.served(b"HTTP/1.1 422 No\r\nContent-Length: %d\r\n\r\n" % len(body) + body)
        with self.assertRaises(coapt.InvalidRequest) as raised:
            client.presets()
        self.assertIn("pwned", str(raised.exception))
        self.assertNotRegex(str(raised.exception), MOVES)

    def test_nor_does_what_is_not_http(self):
        client = self.served(b"\x1b[2J\x07\x9b31m\r\n\r\n")
        with self.assertRaises(coapt.Unreachable) as raised:
            client.presets()
        self.assertNotRegex(str(raised.exception), MOVES)

    def job(self, client):
        return Job(client._transport, {"id": "0123", "kind": "\x1b[2J", "state": "RUNNING"}, lambda *_: None)

    def test_nor_do_jobs_and_their_progress(self):
        progress = coapt.Progress("\x1b[2J", 1, 2, None, None, 3.0)
        for shown in (self.job(coapt.Client("http://127.0.0.1:1")), progress, replace(progress, rms_mm=1.0)):
            self.assertNotRegex(f"{shown} {shown!r}", MOVES)

    def test_an_event_has_a_limit_be_it_one_line_or_many(self):
        head = b"HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\n\r\n"
        event = b'id: 1\nevent: state\ndata: {"state": "RUNNING"}\n\n'
        for endless in (b"data: " + b"x" * 2000, b"data: x\n" * 300):
            with self.subTest(endless=endless[:10]):
                events = self.job(self.served(head + 30 * event + endless)).events()
                with unittest.mock.patch("coapt.http_transport._MOST_EVENT_BYTES", 1000):
                    self.assertEqual([next(events).state for _ in range(30)], 30 * ["RUNNING"])
                    with self.assertRaisesRegex(coapt.Unreachable, "sent an event of more than"):
                        next(events)


if __name__ == "__main__":
    unittest.main()
