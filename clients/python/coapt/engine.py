"""The engine in this process: all that a service answers, without one."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Literal

from .closures import Closure
from .comparison import Comparison, ShapeSource, local_closure, native_shape
from .files import Path, read_json
from .fits import FitResult, Known
from .local_transport import LocalTransport, engine_module, reading, refusing
from .local_valve import LocalValve
from .service import Service
from .sources import Valve, valve_document
from .transport import encoded

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray


class Engine(Service):
    """Closes, searches and studies in this process. Its functions are a Client's; threads may share an engine.

    Jobs end with the process: with a database they go on in the next engine that has it, and closures of searches and studies
    that it knows are not made again.

    >>> engine = coapt.Engine(threads=2)
    >>> "human-functional-mr" in engine.presets()
    True
    >>> engine.close("human-functional-mr", Plan(OwnRing(2))).trusted
    True
    >>> engine.end()

    :param database: file of valves, jobs and closures, made if it is not there; None: one that goes with this process
    :param threads: of a job, an evaluation and a sweep; does not change any result; 0: all cores
    :raises MissingPackage: this installation has no engine
    """

    def __init__(self, database: str | os.PathLike[str] | None = None, *, threads: int = 0) -> None:
        self._local, self.threads = LocalTransport(database, threads), threads
        super().__init__(self._local)

    def end(self) -> None:
        """Stops jobs, and removes what was kept for this process alone. Without it, that is done at the end of the process."""
        self._local.end()

    def valve(self, source: Valve) -> LocalValve:
        """What may be given for a valve, read once.

        :raises InvalidRequest: it is none; problems have pointers below "/valve"
        """
        return self._read(source)

    def preset(self, name: str) -> LocalValve:
        """:raises InvalidRequest: there is none of that name"""
        return self._named(name)

    def read_valve(self, path: Path) -> LocalValve:
        """A file of a coapt.valve/1.

        :raises NoSuchFile, BadDocument: problems have pointers into the file
        """
        try:
            text = pathlib.Path(path).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError):
            read_json(path)  # says why
            raise
        with reading(f"{path} is no valve"):
            return LocalValve(self, engine_module().Valve.read(text, ""))

    def compare(
        self, closed: ShapeSource, reference: ShapeSource, *, align: Literal["auto", "none", "rigid"] = "auto"
    ) -> Comparison:
        """How far a closed shape lies from a reference.

        :param align: "rigid" by iterative closest point; "auto": only if they have not the same nodes
        :raises NoSuchFile, BadDocument, InvalidRequest: of what is no shape
        """
        shapes = [native_shape(one) for one in (closed, reference)]
        with refusing():
            native = engine_module().compare(*shapes, align)
        told = json.loads(native.document)
        return Comparison(
            told["rms_mm"],
            told["p95_mm"],
            told["max_mm"],
            told["pairing"] == "node_to_node",
            told["alignment"]["rigid"],
            native.signed_mm,
            native.moved_mm,
            told,
        )

    def fit(
        self,
        valve: Valve,
        points_mm: NDArray[numpy.float64],
        *,
        side: Literal["atrial", "middle"] = "atrial",
        leak_mm2: float | None = None,
        leak_sd_mm2: float | None = None,
        known: Iterable[Known] = (),
        ruptured: bool = False,
        points: int | None = None,
        rounds: int | None = None,
        progress: Callable[[int, float], object] | None = None,
    ) -> tuple[LocalValve, FitResult]:
        """Fits chordae, papillary tips and tissue of a valve to its closed leaflets as imaged; Ctrl-C ends it with the best so far.

        :param points_mm: N x 3, float64, of the closed surface in the valve's own frame
        :param side: of the leaflets that they show
        :param leak_mm2: as imaged, known to within leak_sd_mm2
        :param known: what stays as it is
        :param ruptured: ask for each scallop whether its marginal chordae are ruptured
        :param points: of the surface, at most
        :param rounds: of either pass, at most
        :param progress: called with the rounds done and the distance left, rms in mm
        """
        native = self._read(valve).native
        with refusing():
            fitted, told = engine_module().fit(
                native,
                points_mm,
                side,
                leak_mm2,
                leak_sd_mm2,
                list(known),
                points,
                rounds,
                ruptured,
                self.threads,
                progress,
            )
        return LocalValve(self, fitted), FitResult.from_json(json.loads(told))

    # What differs from a service.

    def _request_source(self, valve: Valve) -> Any:
        return valve.id(self) if isinstance(valve, LocalValve) else valve_document(valve)

    def _read(self, valve: Valve) -> LocalValve:
        if isinstance(valve, LocalValve):
            return valve
        document = valve_document(valve)
        if isinstance(document, str):
            return self._named(document)
        with refusing():
            return LocalValve(self, engine_module().Valve.read(encoded(document).decode(), "/valve"))

    def _named(self, name: str) -> LocalValve:
        with refusing():
            return LocalValve(self, self._local.service.named(name), name)

    def _at_once(self, threads: int | None) -> int:
        return threads or self.threads or os.cpu_count() or 1

    def _closure(self, source: LocalValve, plan: Any) -> Closure:
        with refusing():
            native = source.native.close(b"" if plan is None else encoded(plan))
        return local_closure(native)
