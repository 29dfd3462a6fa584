"""Requests as bytes: what no well-behaved client sends."""

import json
import re
import select
import socket
import time

from served import Reply


class Wrong(Exception):
    """The service did what it must not."""


def read_reply(received):
    """The one answer in `received`; none if the connection was closed without one."""
    if not received:
        return None
    head, blank, body = received.partition(b"\r\n\r\n")
    first, *lines = head.decode("latin-1").split("\r\n")
    status = re.fullmatch(r"HTTP/1\.[01] (\d{3})(?: .*)?", first)
    if not blank or not status:
        raise Wrong(f"not HTTP: {received[:80]!r}")
    headers = {name.lower(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
    length = headers.get("content-length")
    if length is not None and int(length) < len(body):
        raise Wrong(f"something follows the answer: {body[int(length):][:80]!r}")
    return Reply(int(status.group(1)), headers, body)


def send(port, pieces, pause=0.0, half_close=False, seconds=60):
    """Sends `pieces` with pauses between them until all are sent or the service answers or closes; its
    answer, none if it closed without one. Raises Wrong if it does neither in time."""
    deadline = time.monotonic() + seconds
    received = b""
    with socket.create_connection(("127.0.0.1", port), timeout=seconds) as connection:
        try:
            for piece in pieces:
                connection.sendall(piece)
                if select.select([connection], [], [], pause)[0]:
                    break
            else:
                if half_close:
                    connection.shutdown(socket.SHUT_WR)
        except (BrokenPipeError, ConnectionResetError):
            pass
        try:
            while True:
                connection.settimeout(max(0.01, deadline - time.monotonic()))
                part = connection.recv(1 << 16)
                if not part:
                    break
                received += part
        except ConnectionResetError:
            pass
        except TimeoutError:
            raise Wrong(f"no end of the answer in {seconds} s; so far {received[:80]!r}") from None
    return read_reply(received)


def abandon(port, pieces, linger=0.0):
    """Sends `pieces` and leaves without waiting for an answer."""
    with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
        try:
            for piece in pieces:
                connection.sendall(piece)
        except (BrokenPipeError, ConnectionResetError):
            pass
        time.sleep(linger)


def head(method, path, **headers):
    """Request line and headers; underscores of names stand for hyphens."""
    lines = [f"{method} {path} HTTP/1.1"]
    for name, value in ({"Host": "localhost"} | headers).items():
        lines.append(f"{name.replace('_', '-')}: {value}")
    return ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1")


def post(path, body, **headers):
    """A request with its length told truly, unless `headers` say otherwise."""
    return head("POST", path, **({"Content_Type": "application/json", "Content_Length": len(body)} | headers)) + body


def expect(reply, *statuses, or_closed=False):
    """What came, as a word; Wrong unless it is one of `statuses` and answers as the contract has it."""
    if reply is None:
        if or_closed:
            return "closed"
        raise Wrong(f"closed without an answer instead of {statuses}")
    if reply.status not in statuses:
        raise Wrong(f"{reply.status} instead of {statuses}: {reply.body[:200]!r}")
    if "coapt-notice" not in reply.headers:
        raise Wrong(f"{reply.status} without the notice")
    if reply.status >= 400:
        check_problem(reply)
    return str(reply.status)


def check_problem(reply):
    """RFC 9457, and the headers that go with some statuses."""
    if reply.headers.get("content-type") != "application/problem+json":
        raise Wrong(f"{reply.status} of type {reply.headers.get('content-type')}")
    try:
        body = json.loads(reply.body)
    except ValueError:
        raise Wrong(f"{reply.status} whose body is no JSON: {reply.body[:200]!r}") from None
    if body["status"] != reply.status or not body["problems"]:
        raise Wrong(f"{reply.status} that says {reply.body[:200]!r}")
    needed = {401: "www-authenticate", 405: "allow", 429: "retry-after", 503: "retry-after"}.get(reply.status)
    if needed and needed not in reply.headers:
        raise Wrong(f"{reply.status} without {needed}")
