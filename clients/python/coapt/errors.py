"""What can go wrong between a client and the service; every error is a CoaptError."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .tables import printable


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a request, or with a job.

    >>> try:
    ...     coapt.preset("human-normal").close(Plan(Ring("generic-classic", size_mm=31)))
    ... except coapt.InvalidRequest as error:
    ...     print([(problem.code, problem.path) for problem in error.problems])
    [('out_of_range', '/plan/steps/0/size_mm')]
    """

    code: str
    """Its kind, for programs: "out_of_range", "missing_field", ..."""
    path: str
    """A JSON pointer into the request's body ("/plan/steps/0/size_mm"), "?NAME" for a parameter of the query, empty for the
    whole."""
    message: str
    """What is wrong and what is accepted."""

    @classmethod
    def from_json(cls, json: Mapping[str, Any]) -> Problem:
        return cls(json.get("code", ""), printable(json.get("path", "")), printable(json.get("message", "")))

    def __str__(self) -> str:
        return f"{self.path}: {self.message}" if self.path else self.message


class CoaptError(Exception):
    """All that this package raises on purpose. problems: tuple of Problem, may be empty.

    >>> try:
    ...     coapt.preset("no-such-valve")
    ... except coapt.CoaptError as error:
    ...     print(len(error.problems))
    1
    """

    def __init__(self, message: str, problems: Sequence[Problem] = ()) -> None:
        self.problems: tuple[Problem, ...] = tuple(problems)
        super().__init__("\n  ".join(map(printable, [message, *self.problems])))

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.__reduce__() == other.__reduce__()

    def __hash__(self) -> int:
        return hash((type(self), str(self)))

    def __reduce__(self) -> tuple[Any, ...]:
        # An exception is made again from what it was called with, which args does not hold.
        return _remade, (type(self), self.args), self.__dict__


def _remade(kind: type[CoaptError], arguments: tuple[Any, ...]) -> CoaptError:
    error = kind.__new__(kind)
    error.args = arguments
    return error


class NoSuchFile(CoaptError, FileNotFoundError):
    """A valve or a plan was to be read from a file that is not there.

    >>> try:
    ...     coapt.read_valve("nowhere.json")
    ... except coapt.NoSuchFile as error:
    ...     print(isinstance(error, FileNotFoundError))
    True
    """

    __str__ = Exception.__str__  # that of FileNotFoundError wants a number


class BadDocument(CoaptError, ValueError):
    """What was to be a valve or a plan is none.

    >>> try:
    ...     Plan.from_json({"schema": "coapt.plan/1", "steps": [{"step": "anuloplasty"}]})
    ... except coapt.BadDocument as error:
    ...     print("did you mean" in str(error))
    True
    """


class MissingPackage(CoaptError, ImportError):
    """A package that this function needs is not installed: pandas, matplotlib, meshio, pyvista, or coapt's own engine.

    >>> isinstance(coapt.MissingPackage("a table needs pandas"), ImportError)
    True
    """


class Unreachable(CoaptError):
    """No answer: nothing listens there, the connection broke, or time ran out, after all tries.

    >>> try:
    ...     coapt.Client("http://127.0.0.1:1", retries=0).presets()
    ... except coapt.Unreachable as error:
    ...     print("nothing listens" in str(error))
    True
    """


class Refused(CoaptError):
    """An answer with an error: status is HTTP's, problems are all that the service says is wrong.

    retry_after_s: seconds after which the service asks to be tried again; None: it does not say.

    >>> try:
    ...     client.job("none")
    ... except coapt.Refused as error:
    ...     print(error.status)
    404
    """

    def __init__(
        self, status: int, title: str, problems: Sequence[Problem] = (), retry_after_s: float | None = None
    ) -> None:
        self.status = status
        self.title = title
        self.retry_after_s = retry_after_s
        super().__init__(f"{status} {title}", problems)


class InvalidRequest(Refused):
    """400, 413, 422 and others: what was sent is wrong; problems say where.

    >>> try:
    ...     client.close("human-normal", Plan(Ring("generic-classic", size_mm=31)))
    ... except coapt.InvalidRequest as error:
    ...     print(error.status, error.problems[0].path)
    422 /plan/steps/0/size_mm
    """


class AccessDenied(Refused):
    """401, 403, 421: no token or a wrong one, or a name by which the service does not want to be called.

    >>> coapt.AccessDenied(401, "a token is needed").status
    401
    """


class NotFound(Refused):
    """404: no such valve, job, plan or file.

    >>> try:
    ...     client.get_valve("human-nromal")
    ... except coapt.NotFound as error:
    ...     print('did you mean "human-normal"' in str(error))
    True
    """


class Conflict(Refused):
    """409: not in this state; the job has not ended, or jobs refer to the valve.

    >>> isinstance(coapt.Conflict(409, "jobs refer to the valve"), coapt.Refused)
    True
    """


class Busy(Refused):
    """429, 503: not now, after all tries; see retry_after_s.

    >>> coapt.Busy(503, "too many jobs", retry_after_s=2.0).retry_after_s
    2.0
    """


class ServiceFailed(Refused):
    """500, 507: a fault of the service, or its disk is full.

    >>> str(coapt.ServiceFailed(507, "the disk is full"))
    '507 the disk is full'
    """


class JobFailed(CoaptError):
    """The job ended as FAILED; problems say why.

    >>> coapt.JobFailed("0123", [coapt.Problem("internal", "", "out of memory")]).job_id
    '0123'
    """

    def __init__(self, job_id: str, problems: Sequence[Problem]) -> None:
        self.job_id = job_id
        super().__init__(f"job {job_id} failed", problems)


class NotEnded(CoaptError):
    """The job has not ended within the time that was given; it goes on.

    >>> job = client.search("human-functional-mr", evaluations=50_000)
    >>> try:
    ...     job.wait(timeout_s=0.1)
    ... except coapt.NotEnded:
    ...     print(job.cancel().refresh().state in ("RUNNING", "CANCELLED"))
    True
    """


_KINDS: dict[int, type[Refused]] = {
    401: AccessDenied,
    403: AccessDenied,
    421: AccessDenied,
    404: NotFound,
    409: Conflict,
    429: Busy,
    503: Busy,
}


def refusal(status: int, body: bytes, retry_after: str | None) -> Refused:
    """The error of an answer. The body is a problem+json, or what a proxy made of it."""
    try:
        said = json.loads(body)
    except ValueError:
        said = None
    if not isinstance(said, dict):
        said = {}
    kind = _KINDS.get(status) or (ServiceFailed if status >= 500 else InvalidRequest)
    problems = [Problem.from_json(one) for one in said.get("problems", [])]
    seconds = float(retry_after) if retry_after is not None and retry_after.isdigit() else None
    return kind(status, printable(said.get("title") or "the service refuses"), problems, seconds)
