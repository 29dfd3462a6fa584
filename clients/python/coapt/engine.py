"""The engine in this process, all that a service answers without one, and its valves."""

from __future__ import annotations

import json
import os
import pathlib
import threading
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

from .asking import checked_threads
from .closures import Closure
from .comparison import Comparison, ShapeSource, local_closure, native_shape
from .files import Path, read_json
from .fits import FitResult, Known
from .jobs import Job
from .local_transport import LocalTransport, engine_module, reading, refusing, with_threads_of_ones_own
from .meshes import Picture
from .openings import Opening
from .results import Evaluations, SearchResult, StudyResult
from .service import Service
from .sources import PlanSource, Valve, ValveHere, valve_document
from .transport import CopiedAsItself, encoded

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    from . import _engine


class Engine(CopiedAsItself, Service):
    """Closes, searches and studies in this process. Its functions are a Client's; threads may share an engine.

    Jobs end with the process: with a database they go on in the next engine that has it, and closures of searches and studies
    that it knows are not made again.

    >>> engine = coapt.Engine(threads=2)
    >>> "human-functional-mr" in engine.presets()
    True
    >>> engine.close("human-functional-mr", Plan(OwnRing(2))).trusted
    True
    >>> engine.end()

    In another process, pickled or forked, it is that process's own (coapt.engine()): its valves, closures and results come
    along, its jobs and its database do not.

    :param database: file of valves, jobs and closures, made if it is not there; None: one that goes with this process
    :param threads: of a job, an evaluation and a sweep; does not change any result; 0: all cores
    :raises MissingPackage: this installation has no engine
    """

    def __init__(self, database: str | os.PathLike[str] | None = None, *, threads: int = 0) -> None:
        self.threads = checked_threads(threads)
        self._local = LocalTransport(database, threads)
        super().__init__(self._local)

    def __reduce__(self) -> tuple[Any, ...]:
        return engine_here, ()

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
            fitted, told = with_threads_of_ones_own(
                engine_module().fit,
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

    def _closure(self, source: LocalValve, plan: Any, material: Mapping[str, float] | None = None) -> Closure:
        with refusing():
            native = source.native.close(b"" if plan is None else encoded(plan), encoded(material) if material else b"")
        return local_closure(native)


class LocalValve(CopiedAsItself, ValveHere):
    """A mitral valve in this process; nothing changes it, and threads may share it. See preset(), read_valve() and
    Engine.valve(). Frame: x posteromedial, y anterior, z to the atrium. A Client takes it, too.

    Arrays are the engine's own numbers: views that are not copied, read-only, and keep the valve alive.

    >>> valve = coapt.preset("human-normal")
    >>> valve
    LocalValve('human-normal', 378 vertices, 648 triangles)
    >>> valve.vertices_mm.shape, valve.faces.shape, valve.annulus_mm.shape[1]
    ((378, 3), (648, 3), 3)
    >>> wider = valve.with_arrays(annulus_mm=valve.annulus_mm * [1.0, 1.2, 1.0])  # 20 % deeper, from front to back
    >>> wider.close().measure.leak_mm2 > valve.close().measure.leak_mm2
    True
    """

    def __init__(self, engine: Engine, native: _engine.Valve, id: str | None = None) -> None:
        """:param id: by which the engine's requests name it; None: it is not stored yet"""
        self.engine, self.native, self._name = engine, native, id
        self._stored: tuple[_engine.Service | None, str] = (None, "")  # where, and under which id

    def __reduce__(self) -> tuple[Any, ...]:
        return _valve_of, (self.native.write(),)

    @property
    def name(self) -> str:
        """Of its document."""
        return self.native.name

    @property
    def vertices_mm(self) -> NDArray[numpy.float64]:
        """V x 3, unstressed."""
        return self.native.vertices_mm

    @property
    def faces(self) -> NDArray[numpy.int32]:
        """F x 3, numbers of vertices from 0; counter-clockwise seen from the atrium."""
        return self.native.faces

    @property
    def annulus_mm(self) -> NDArray[numpy.float64]:
        """A x 3, under pressure, in the order of the annulus's loop."""
        return self.native.annulus_mm

    def to_json(self) -> dict[str, Any]:
        """The coapt.valve/1."""
        document: dict[str, Any] = json.loads(self.native.write())
        return document

    def with_arrays(
        self,
        *,
        vertices_mm: NDArray[numpy.float64] | None = None,
        faces: NDArray[numpy.int32] | None = None,
        annulus_mm: NDArray[numpy.float64] | None = None,
    ) -> LocalValve:
        """A valve that has these instead, copied; the rest is this one's.

        >>> valve = coapt.preset("human-normal")
        >>> try:
        ...     valve.with_arrays(annulus_mm=valve.annulus_mm[:, :2])
        ... except coapt.BadDocument as error:
        ...     print(error.problems[0].path)
        /annulus_mm

        :param vertices_mm: V x 3, float64, unstressed
        :param faces: F x 3, int32
        :param annulus_mm: A x 3, float64, under pressure
        :raises TypeError: no array
        :raises BadDocument: another type or shape, a number that is not finite, or no valve: problems say where
        """
        with reading("these arrays make no valve"):
            return LocalValve(self.engine, self.native.with_arrays(vertices_mm, faces, annulus_mm))

    def id(self, engine: Engine) -> str:
        """By which requests to this engine name it; it is stored if need be."""
        if engine is not self.engine:
            return engine.put_valve(self.to_json()).id
        if self._name is not None:
            return self._name
        service = engine._local.service
        if self._stored[0] is not service:
            self._stored = service, engine.put_valve(self.to_json()).id
        return self._stored[1]

    # The engine's functions, of this valve.

    def close(self, plan: PlanSource | None = None, **options: Any) -> Closure:
        """See Engine.close()."""
        return self.engine.close(self, plan, **options)

    def open(self, plan: PlanSource | None = None, **options: Any) -> Opening:
        """See Engine.open()."""
        return self.engine.open(self, plan, **options)

    def picture(self, plan: PlanSource | None = None) -> Picture:
        """See Engine.picture()."""
        return self.engine.picture(self, plan)

    def evaluate(
        self,
        plans: Any,
        region_points: int | None = None,
        evidence: bool | None = None,
        model_draws: int | None = None,
    ) -> Evaluations:
        """See Engine.evaluate()."""
        return self.engine.evaluate(self, plans, region_points, evidence, model_draws)

    def search(self, **options: Any) -> Job[SearchResult]:
        """See Engine.search()."""
        return self.engine.search(self, **options)

    def study(self, name: Any = "thesis", **options: Any) -> Job[StudyResult]:
        """See Engine.study()."""
        return self.engine.study(self, name, **options)

    def compare(self, reference: ShapeSource, plan: PlanSource | None = None, **options: Any) -> Comparison:
        """The closed valve with a reference: see Engine.compare()."""
        return self.engine.compare(self.close(plan), reference, **options)

    def fit(self, points_mm: NDArray[numpy.float64], **options: Any) -> tuple[LocalValve, FitResult]:
        """See Engine.fit()."""
        return self.engine.fit(self, points_mm, **options)

    def __repr__(self) -> str:
        return f"LocalValve({self.name!r}, {len(self.vertices_mm)} vertices, {len(self.faces)} triangles)"


_engines: list[Engine] = []  # none or one
_making = threading.Lock()


def _forked() -> None:
    global _making
    _making = threading.Lock()  # another thread of the parent may have held it


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def engine_here() -> Engine:
    """That of this process, made when it is first asked for."""
    with _making:
        if not _engines:
            _engines.append(Engine())
        return _engines[0]


def _valve_of(document: str) -> LocalValve:
    """One that was pickled, of this process's engine."""
    return LocalValve(engine_here(), engine_module().Valve.read(document, ""))
