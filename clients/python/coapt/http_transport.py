"""Requests over HTTP, each on a connection of its own, tried again where that is safe."""

from __future__ import annotations

import http.client
import itertools
import os
import socket
import ssl
import time
import urllib.parse
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, ClassVar

from .errors import Busy, CoaptError, Unreachable, refusal
from .transport import LOST, Answer, CopiedAsItself, Stream, encoded

_MOST_BYTES = 256 << 20  # of an answer
_MOST_EVENT_BYTES = 16 << 20
_FIRST_PAUSE_S = 0.25  # before the second try; doubled with each
_LONGEST_PAUSE_S = 30.0
_THIS_MACHINE = ("localhost", "127.0.0.1", "::1")


class _Lines:
    """Of a stream of events, each of which has a limit."""

    def __init__(self, url: str, response: http.client.HTTPResponse) -> None:
        self.status, self._url, self._response = response.status, url, response

    def __iter__(self) -> Iterator[bytes]:
        size = 0  # of the event so far
        while line := self._response.readline(_MOST_EVENT_BYTES + 1 - size):
            size = 0 if line in (b"\n", b"\r\n") else size + len(line)
            if size > _MOST_EVENT_BYTES:
                raise Unreachable(
                    f"{self._url} sent an event of more than {_MOST_EVENT_BYTES >> 20} MiB, the limit for one"
                )
            yield line


@dataclass(frozen=True)
class HttpTransport(CopiedAsItself):
    """Where the service is, and how patient its client.

    timeout_s: for the service to answer, from the last byte that came. retries: further tries of a request whose answer
    got lost or that the service is too busy for (429, 503), after the pause that the service asks for in Retry-After.
    plain_http: the token may go unencrypted to another machine.
    """

    url: str
    token: str | None = field(default=None, repr=False)
    timeout_s: float = 120.0
    retries: int = 3
    sleep: Callable[[float], object] = time.sleep
    plain_http: bool = False
    ends_with_us: ClassVar[bool] = False

    def __post_init__(self) -> None:
        parts = urllib.parse.urlsplit(self.url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise CoaptError(f"{self.url!r} is not a service address; must be like http://127.0.0.1:8080")
        if self.token and not self.plain_http and not self._keeps_secrets():
            raise CoaptError(
                f"{self.url} is not encrypted, so others could read the token; use https://, or plain_http=True "
                "on a trusted network"
            )

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"token": None}  # no secret in a file of results

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__dict__.update(state)
        if (token := os.environ.get("COAPT_TOKEN")) and (self.plain_http or self._keeps_secrets()):
            self.__dict__["token"] = token

    def _body(self, response: http.client.HTTPResponse) -> bytes:
        # Of a length that was said, a part alone is an error; with a limit http.client takes it for the whole.
        is_bounded = response.length is not None and response.length <= _MOST_BYTES
        body = response.read() if is_bounded else response.read(_MOST_BYTES + 1)
        if len(body) > _MOST_BYTES:
            raise Unreachable(
                f"{self.url} answered with more than {_MOST_BYTES >> 20} MiB, the limit for a service's answer"
            )
        return body

    def _keeps_secrets(self) -> bool:
        parts = urllib.parse.urlsplit(self.url)
        return parts.scheme != "http" or parts.hostname in _THIS_MACHINE

    def request(
        self,
        method: str,
        path: str,
        body: Any = None,
        headers: Mapping[str, str] | None = None,
        query: Mapping[str, Any] | None = None,
    ) -> Answer:
        """See Transport.request()."""
        content = None if body is None else encoded(body)
        # What was removed by a request whose answer got lost would not be found by the next.
        further = 0 if method == "DELETE" else self.retries
        for tried in itertools.count():
            pause_s = _FIRST_PAUSE_S * 2**tried
            try:
                with self.open(method, path, content, headers, query) as response:
                    return Answer(response.status, _headers(response), self._body(response))
            except Busy as busy:
                if tried == further:
                    raise
                pause_s = busy.retry_after_s or pause_s
            except LOST as error:
                if tried == further:
                    raise self.unreachable(error) from error
            self.sleep(min(pause_s, _LONGEST_PAUSE_S))
        raise AssertionError("the last try returns or raises")

    @contextmanager
    def follow(self, path: str, headers: Mapping[str, str], timeout_s: float) -> Iterator[Stream]:
        with self.open("GET", path, headers=headers, timeout_s=timeout_s) as response:
            yield _Lines(self.url, response)

    def pause(self, seconds: float) -> None:
        self.sleep(seconds)

    def unreachable(self, error: Exception) -> Unreachable:
        return Unreachable(self._what_happened(error))

    def _what_happened(self, error: Exception) -> str:
        """In words. Special kinds come before those that contain them."""
        host = urllib.parse.urlsplit(self.url).hostname
        match error:
            case ConnectionRefusedError():
                return f"nothing listens at {self.url}: connection refused; is coapt-server running?"
            case socket.gaierror():
                return f"{self.url} cannot be reached: there is no host named {host} ({error.strerror})"
            case ssl.SSLCertVerificationError():
                return f"{self.url} is not trusted: {error.verify_message}"
            case ssl.SSLError():
                return f"{self.url} does not support https: {error.reason or error}"
            case TimeoutError():
                return f"{self.url} did not answer in time"
            case ConnectionError() | http.client.HTTPException():
                return f"{self.url} closed the connection: {error or type(error).__name__}"
        return f"{self.url} cannot be reached: {error}"

    @contextmanager
    def open(
        self,
        method: str,
        path: str,
        content: bytes | None = None,
        headers: Mapping[str, str] | None = None,
        query: Mapping[str, Any] | None = None,
        timeout_s: float | None = None,
    ) -> Iterator[http.client.HTTPResponse]:
        """One try: the answer, still to be read. Raises Refused, OSError and http.client.HTTPException."""
        parts = urllib.parse.urlsplit(self.url)
        target = parts.path.rstrip("/") + path
        if query:
            target += "?" + urllib.parse.urlencode(query)
        connection = self._connection(parts, self.timeout_s if timeout_s is None else timeout_s)
        try:
            connection.request(method, target, content, self._sent(content, headers))
            response = connection.getresponse()
            if response.status >= 400:
                raise refusal(response.status, self._body(response), response.getheader("Retry-After"))
            yield response
        finally:
            connection.close()

    def _connection(self, parts: urllib.parse.SplitResult, timeout_s: float) -> http.client.HTTPConnection:
        assert parts.hostname
        if parts.scheme == "https":
            context = ssl.create_default_context()
            return http.client.HTTPSConnection(parts.hostname, parts.port, timeout=timeout_s, context=context)
        return http.client.HTTPConnection(parts.hostname, parts.port, timeout=timeout_s)

    def _sent(self, content: bytes | None, headers: Mapping[str, str] | None) -> dict[str, str]:
        sent = {"User-Agent": "coapt-python"} | dict(headers or {})
        if content is not None:
            sent["Content-Type"] = "application/json"
        if self.token is not None:
            sent["Authorization"] = f"Bearer {self.token}"
        return sent


def _headers(response: http.client.HTTPResponse) -> dict[str, str]:
    return {name.lower(): value for name, value in response.getheaders()}
