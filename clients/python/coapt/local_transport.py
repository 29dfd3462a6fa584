"""Requests to the service's own endpoints in this process: no network, no JSON but the endpoints' own."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import tempfile
import threading
import time
import urllib.parse
import weakref
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from .errors import BadDocument, InvalidRequest, MissingPackage, Problem, Unreachable, refusal
from .transport import Answer, CopiedAsItself, Stream, encoded

if TYPE_CHECKING:
    from . import _engine

Result = TypeVar("Result")


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


_threads_are_the_parents = False  # this process was forked
_transports: weakref.WeakSet[LocalTransport] = weakref.WeakSet()


def _forked() -> None:
    global _threads_are_the_parents
    _threads_are_the_parents = True
    for transport in list(_transports):
        # The service is opened again when it is asked for.
        transport._opening, transport._service = threading.Lock(), None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def with_threads_of_ones_own(call: Callable[..., Result], *arguments: Any) -> Result:
    """call(*arguments). In a child that was forked, on a thread that was not: OpenMP keeps the threads of a parallel loop for the
    next one of the same thread, and those of the parent are gone."""
    if not _threads_are_the_parents:
        return call(*arguments)
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(call, *arguments).result()


class ElsewhereTransport:
    """Of an engine in another process, which cannot be asked from here."""

    ends_with_us: ClassVar[bool] = True

    def request(self, method: str, path: str, *rest: Any, **more: Any) -> Answer:
        raise self.unreachable(OSError())

    def follow(self, path: str, headers: Mapping[str, str], timeout_s: float) -> AbstractContextManager[Stream]:
        raise self.unreachable(OSError())

    def unreachable(self, error: Exception) -> Unreachable:
        return Unreachable("this came from an engine in another process: jobs, pictures and files of plans stay there")

    def pause(self, seconds: float) -> None:
        time.sleep(seconds)


class LocalTransport(CopiedAsItself):
    """
    Pickled, it is an ElsewhereTransport. In a forked child it is a new one, unless it has a database: that stays the parent's.

    :param database: file of valves, jobs and closures, made if it is not there; None: one that goes with this process
    :param threads: 0: all cores
    """

    ends_with_us: ClassVar[bool] = True

    def __init__(self, database: str | os.PathLike[str] | None, threads: int) -> None:
        self.database, self._threads, self._opening = database, threads, threading.Lock()
        self._open()
        _transports.add(self)

    def _open(self) -> None:
        folder = tempfile.mkdtemp(prefix="coapt-") if self.database is None else None
        file = pathlib.Path(folder) / "coapt.sqlite" if folder else pathlib.Path(str(self.database))
        with reading(f"{file} cannot be used"):
            service = engine_module().Service(str(file), self._threads)
        self._service: _engine.Service | None = service
        self.end = weakref.finalize(self, _end, service, folder, os.getpid())

    @property
    def service(self) -> _engine.Service:
        with self._opening:
            if self._service is None and self.database is not None:
                raise Unreachable(
                    f"the engine of {self.database} belongs to the process that this one was forked from: make an Engine here, "
                    "with another database"
                )
            if self._service is None:
                self._open()
            assert self._service is not None
            return self._service

    def __reduce__(self) -> tuple[Any, ...]:
        return ElsewhereTransport, ()

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
        status, answered, content = with_threads_of_ones_own(
            self.service.request,
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
