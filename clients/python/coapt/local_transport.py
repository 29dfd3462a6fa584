"""Requests to the service's own endpoints in this process: no network, no JSON but the endpoints' own."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import tempfile
import time
import urllib.parse
import weakref
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, ClassVar

from .errors import BadDocument, InvalidRequest, MissingPackage, Problem, Unreachable, refusal
from .transport import Answer, Stream, encoded

if TYPE_CHECKING:
    from . import _engine


def engine_module() -> Any:
    """:raises MissingPackage: it was not built"""
    try:
        from . import _engine
    except ImportError as error:
        raise MissingPackage(
            "there is no engine in this installation, a Client of coapt-server alone: build it "
            "(cmake --build build/release --target coapt_python) and add build/release/python to PYTHONPATH; "
            f"numpy is needed, too ({error})"
        ) from error
    return _engine


def problems_of(error: Exception) -> list[Problem]:
    """Of an _engine.Problems."""
    return [Problem.from_json(one) for one in json.loads(str(error))]


@contextmanager
def refusing() -> Iterator[None]:
    """What the engine says is wrong, as a service says it."""
    try:
        yield
    except engine_module().Problems as error:
        raise InvalidRequest(422, "Unprocessable content", problems_of(error)) from None


@contextmanager
def reading(what: str) -> Iterator[None]:
    """What the engine says is wrong with a document or arrays."""
    try:
        yield
    except engine_module().Problems as error:
        raise BadDocument(what, problems_of(error)) from None


class _Lines:
    """Of a stream; an empty one each second in which nothing came."""

    def __init__(self, status: int, parts: _engine.Stream | None) -> None:
        self.status, self._parts = status, parts

    def __iter__(self) -> Iterator[bytes]:
        while self._parts is not None and (part := self._parts.next()) is not None:
            yield from part.splitlines(keepends=True) or [b""]


class LocalTransport:
    """
    :param database: file of valves, jobs and closures, made if it is not there; None: one that goes with this process
    :param threads: 0: all cores
    """

    ends_with_us: ClassVar[bool] = True

    def __init__(self, database: str | os.PathLike[str] | None, threads: int) -> None:
        folder = tempfile.mkdtemp(prefix="coapt-") if database is None else None
        file = pathlib.Path(folder) / "coapt.sqlite" if folder else pathlib.Path(str(database))
        with reading(f"{file} cannot be used"):
            self.service: _engine.Service = engine_module().Service(str(file), threads)
        self.end = weakref.finalize(self, _end, self.service, folder, os.getpid())

    def request(
        self,
        method: str,
        path: str,
        body: Any = None,
        headers: Mapping[str, str] | None = None,
        query: Mapping[str, Any] | None = None,
    ) -> Answer:
        """See Transport.request()."""
        status, answered, content = self._asked(
            method, path, b"" if body is None else encoded(body), headers or {}, query or {}
        )
        assert isinstance(content, bytes)
        return Answer(status, answered, content)

    @contextmanager
    def follow(self, path: str, headers: Mapping[str, str], timeout_s: float) -> Iterator[Stream]:
        status, _, content = self._asked("GET", path, b"", headers, {})
        yield _Lines(status, None if isinstance(content, bytes) else content)

    def unreachable(self, error: Exception) -> Unreachable:
        return Unreachable(str(error))

    def pause(self, seconds: float) -> None:
        time.sleep(seconds)

    def _asked(
        self, method: str, path: str, body: bytes, headers: Mapping[str, str], query: Mapping[str, Any]
    ) -> tuple[int, dict[str, str], bytes | _engine.Stream]:
        status, answered, content = self.service.request(
            method,
            urllib.parse.unquote(path),
            {name: str(value) for name, value in query.items()},
            {name.lower(): value for name, value in headers.items()},
            body,
        )
        named = {name.lower(): value for name, value in answered}
        if status >= 400:
            assert isinstance(content, bytes)
            raise refusal(status, content, named.get("retry-after"))
        return status, named, content


def _end(service: _engine.Service, folder: str | None, process: int) -> None:
    """Jobs end, and what was kept for this process alone is removed; not by a process that was forked from it."""
    if os.getpid() != process:
        return
    service.close()
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)
