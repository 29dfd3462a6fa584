"""Long work: a job, followed from here."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Generic, TypeVar

from . import tables
from .errors import Busy, JobFailed, NotEnded, Problem
from .events import ENDED, Event, JobState, Progress, read_events
from .evidence import Table
from .transport import LOST, Transport

Result = TypeVar("Result")

_HEARTBEAT_S = 15.0  # of the service's event streams
_PAUSE_S = 2.0  # before a stream is opened again, as the service asks


def show_progress(progress: Progress) -> None:
    """One line on standard error, written over and over: job.wait(progress=show_progress).

    >>> show_progress(coapt.Progress("searching", 40, 600, best_leak_mm2=1.2, best_cost=None, seconds=3.0))
    """
    print(f"\r\033[K{progress}", end="", file=sys.stderr, flush=True)


class Job(Generic[Result]):
    """A search, a study or an import. That of a service goes on without its client: Client.job(id) finds it again.

    json is the job as it was when it was last asked for; see refresh().

    >>> job = coapt.preset("human-functional-mr").search(evaluations=20, plans=1, region_points=2, evidence=False)
    >>> job.wait().state
    'SUCCEEDED'
    >>> best = job.result().plans[0]
    >>> best.rank, best.plan == job.result().plans[0].plan
    (1, True)
    """

    def __init__(
        self,
        transport: Transport,
        json: Mapping[str, Any],
        read: Callable[[Any, Transport, str], Result],
        patience_s: float = 60.0,
    ) -> None:
        self._transport, self._read, self._patience_s = transport, read, patience_s
        self.json = json

    @property
    def id(self) -> str:
        """By which Client.job() finds it again.

        >>> client.job(job.id).state
        'SUCCEEDED'
        """
        return str(self.json["id"])

    @property
    def kind(self) -> str:
        """One of "plans", "study", "import", "fit" and "model".

        >>> job.kind
        'plans'
        """
        return str(self.json["kind"])

    @property
    def state(self) -> JobState:
        """QUEUED, RUNNING, SUCCEEDED, FAILED or CANCELLED, when it was last asked for.

        >>> job.state
        'SUCCEEDED'
        """
        state: JobState = self.json["state"]
        return state

    @property
    def ended(self) -> bool:
        """Whether the job has ended.

        >>> job.ended
        True
        """
        return self.state in ENDED

    @property
    def progress(self) -> Progress:
        """How far it was when it was last asked for.

        >>> job.progress.best_leak_mm2 < valve.close().measure.leak_mm2
        True
        """
        return Progress.from_json(self.json["progress"])

    @property
    def problems(self) -> tuple[Problem, ...]:
        """Of a failed job: why.

        >>> job.problems
        ()
        """
        return tuple(map(Problem.from_json, self.json["problems"]))

    @property
    def path(self) -> str:
        """Of its requests.

        >>> job.path == f"/v1/jobs/{job.id}"
        True
        """
        return f"/v1/jobs/{self.id}"

    def refresh(self) -> Job[Result]:
        """Asks how the job is now; the same job.

        >>> job.refresh().state
        'SUCCEEDED'
        """
        self.json = self._transport.request("GET", self.path).json()
        return self

    def events(self, after: int = 0, timeout_s: float | None = None) -> Iterator[Event]:
        """What has happened since event number `after`, then what happens, until the job has ended.

        A stream that breaks off is taken up where it was, also when the service was started again. A connection that stays
        away longer than the client's patience is Unreachable.

        >>> [event.state for event in job.events()][-1]
        'SUCCEEDED'

        :raises NotEnded: timeout_s is over
        """
        deadline = None if timeout_s is None else time.monotonic() + timeout_s
        heard = time.monotonic()

        def lines(response: Iterable[bytes]) -> Iterator[bytes]:
            """Those that come in time: heartbeats, too, are a sign of life, and a time to look at the clock."""
            nonlocal heard
            for line in response:
                heard = time.monotonic()
                self._left(deadline, 0.0)
                yield line
            heard = time.monotonic()

        while True:
            pause_s = _PAUSE_S
            try:
                with self._transport.follow(
                    f"{self.path}/events", {"Last-Event-ID": str(after)}, self._left(deadline, 3 * _HEARTBEAT_S)
                ) as response:
                    if response.status == 204:
                        return
                    for event in read_events(lines(response)):
                        after = event.number
                        yield event
                        if event.state in ENDED:
                            return
            except Busy as busy:
                heard = time.monotonic()
                pause_s = busy.retry_after_s or pause_s
            except LOST as error:
                if time.monotonic() - heard > self._patience_s:
                    raise self._transport.unreachable(error) from error
            self._transport.pause(self._left(deadline, pause_s))

    def _left(self, deadline: float | None, most_s: float) -> float:
        """Seconds that may pass."""
        if deadline is None:
            return most_s
        left = deadline - time.monotonic()
        if left <= 0:
            raise NotEnded(f"job {self.id} has not ended in time and continues")
        return min(left, most_s)

    def wait(self, progress: Callable[[Progress], object] | None = None, timeout_s: float | None = None) -> Job[Result]:
        """Until the job has ended, SUCCEEDED or CANCELLED; the same job. Ctrl-C ends a job of this process with the best so far,
        the second one at once; a job of a service goes on.

        >>> job.wait(timeout_s=60).ended
        True

        :param progress: called with each news of it, for instance show_progress or print
        :raises JobFailed: it ended otherwise
        :raises NotEnded: timeout_s is over; the job goes on
        """
        if not self.ended:
            try:
                self._follow(progress, timeout_s)
            except KeyboardInterrupt:
                if not self._transport.ends_with_us:
                    raise
                self.cancel()
                self._follow(progress, None)
            self.refresh()
        if progress is show_progress:
            print(file=sys.stderr)
        if self.state == "FAILED":
            raise JobFailed(self.id, self.problems)
        return self

    def _follow(self, progress: Callable[[Progress], object] | None, timeout_s: float | None) -> None:
        for event in self.events(timeout_s=timeout_s):
            if event.progress is not None and progress is not None:
                progress(event.progress)

    def result(self, timeout_s: float | None = None) -> Result:
        """The result, after waiting for the end of the job. A cancelled search has its best plans so far.

        >>> job.result().plans[0].rank
        1

        :raises NotFound: it was cancelled before it had anything
        """
        self.wait(timeout_s=timeout_s)
        return self._read(self._transport.request("GET", f"{self.path}/result").json(), self._transport, self.path)

    def cancel(self) -> Job[Result]:
        """End the job early with the best result so far; wait() for it. A job that has ended is not changed.

        >>> begun = client.search("human-functional-mr", evaluations=50_000, plans=1, region_points=2, evidence=False)
        >>> begun.cancel().wait().state
        'CANCELLED'
        """
        self.json = self._transport.request("POST", f"{self.path}:cancel", {}).json()
        return self

    def delete(self) -> None:
        """Removes an ended job with all its results.

        >>> begun = client.search("human-normal", evaluations=1, plans=1, region_points=1, evidence=False)
        >>> begun.wait().delete()

        :raises Conflict: it has not ended
        """
        self._transport.request("DELETE", self.path)

    def report(self) -> str:
        """The report of the job: a self-contained HTML page.

        >>> "human-functional-mr" in job.report()
        True
        """
        return self._transport.request("GET", f"{self.path}/report").body.decode()

    def files(self) -> dict[str, int]:
        """Names of its pages, tables and charts, with their bytes.

        >>> sorted(job.files())
        ['evaluations.csv', 'plan-1.html', 'report.html']
        """
        listed = self._transport.request("GET", f"{self.path}/files").json()["files"]
        return {file["name"]: file["bytes"] for file in listed}

    def file(self, name: str) -> bytes:
        """One of them.

        >>> job.file("report.html")[:15]
        b'<!DOCTYPE html>'

        :raises NotFound: there is none of that name
        """
        return self._transport.request("GET", f"{self.path}/files/{name}").body

    def table(self, name: str) -> Table:
        """One of its files that is CSV, such as "annulus.csv" of a study of the annulus.

        >>> study = client.study("porcine-3", "annulus").wait()
        >>> len(study.table("annulus.csv").to_frame()) > 2
        True
        """
        return Table(self.file(name).decode())

    def evaluations(self) -> Table:
        """Every plan that a search has tried, a row each in the order of trying; rank is empty for those that are not in its
        result, plan is a coapt.plan/1 as JSON.

        >>> job.evaluations().to_frame()["leak_mm2"].min() < 5
        True
        """
        return Table(self._transport.request("GET", f"{self.path}/evaluations.csv").body.decode())

    def __repr__(self) -> str:
        return tables.printable(f"Job({self.id}, {self.kind}, {self.state})")

    def _repr_html_(self) -> str:
        return f"<p>{tables.escaped(f'{self!r}: {self.progress}')}</p><p><small>{tables.NOTICE}</small></p>"
