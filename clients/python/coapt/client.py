"""A coapt-server over HTTP."""

from __future__ import annotations

import os

from .http_transport import HttpTransport
from .service import Service

LOCAL = "http://127.0.0.1:8080"


class Client(Service):
    """A coapt-server. Threads may share a client; pickled, it has the token of COAPT_TOKEN where it is read again, not its own.

    >>> client = coapt.Client("http://127.0.0.1:8080", token="a-token")
    >>> client
    Client('http://127.0.0.1:8080')

    :param url: COAPT_SERVER or http://127.0.0.1:8080 by default
    :param token: access token of the service; COAPT_TOKEN by default
    :param timeout_s: timeout for an answer
    :param retries: number of retries of requests whose answer was lost or that found the service busy (respecting Retry-After).
        Jobs carry an idempotency key, so a repeated request makes no second job
    :param patience_s: how long the service may be unreachable while following a job
    :param plain_http: allow sending the token over http:// to another machine
    """

    def __init__(
        self,
        url: str | None = None,
        token: str | None = None,
        *,
        timeout_s: float = 120.0,
        retries: int = 3,
        patience_s: float = 60.0,
        plain_http: bool = False,
    ) -> None:
        transport = HttpTransport(
            (url or os.environ.get("COAPT_SERVER") or LOCAL).rstrip("/"),
            token or os.environ.get("COAPT_TOKEN") or None,
            timeout_s,
            retries,
            plain_http=plain_http,
        )
        super().__init__(transport, patience_s)
        self.url = transport.url

    def __repr__(self) -> str:
        return f"Client({self.url!r})"
