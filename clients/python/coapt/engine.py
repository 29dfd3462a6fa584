"""The engine in this process, all that a service answers without one, and its valves."""

from __future__ import annotations

import json
import os
import pathlib
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Self

from .asking import checked_threads, given, search_rules
from .closures import Closure
from .comparison import Comparison, ShapeSource
from .errors import BadDocument
from .files import GEOMETRY, Path, read_bounded, read_json
from .fits import FitResult, Known, fit_target
from .leaflets import local_closure
from .local_transport import LocalTransport, engine_module, reading, refusing, with_threads_of_ones_own
from .native_valves import NativeValve
from .service import Service
from .sources import PlanSource, Valve, of_this_valve, valve_document
from .spaces import Objective, Space, space_of
from .steps import Step
from .transport import CopiedAsItself, encoded

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Engine(CopiedAsItself, Service):
    """Closes, searches and studies in this process. Its functions are a Client's; threads may share an engine.

    Jobs end with the process: with a database they go on in the next engine that has it, and closures of searches and studies
    that it knows are not made again.

    >>> with coapt.Engine(threads=2) as engine:
    ...     engine.close("human-functional-mr", Plan(OwnRing(2))).trusted
    True

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
        """Stops jobs, and removes what was kept for this process alone. Without it, that is done at the end of the process.

        >>> engine = coapt.Engine()
        >>> engine.end()
        """
        self._local.end()

    def __repr__(self) -> str:
        return f"Engine({self._local.database!r}, threads={self.threads})"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.end()

    def valve(self, source: Valve) -> LocalValve:
        """What may be given for a valve, read once.

        >>> coapt.engine().valve("examples/valves/bodyparts3d-leaking.json").name
        'bodyparts3d-leaking'

        :raises InvalidRequest: it is none; problems have pointers below "/valve"
        """
        return self._read(source)

    def preset(self, name: str) -> LocalValve:
        """
        >>> coapt.engine().preset("porcine-1").name
        'porcine-1'

        :raises InvalidRequest: there is none of that name
        """
        return self._named(name)

    def read_valve(self, path: Path) -> LocalValve:
        """A file of a coapt.valve/1.

        >>> len(coapt.engine().read_valve("examples/valves/bodyparts3d-leaking.json").chordae) > 20
        True

        :raises NoSuchFile, BadDocument: problems have pointers into the file
        """
        if pathlib.Path(path).suffix.lower() in GEOMETRY:
            raise BadDocument(
                f"{path}: is geometry, from which import_valve() makes a valve (Mesh.read() reads a mesh); a valve is a .json file"
            )
        try:
            text = read_bounded(path).decode("utf-8")
        except (OSError, UnicodeDecodeError):
            read_json(path)  # says why
            raise
        with reading(f"{path} is no valve"):
            return LocalValve(self, engine_module().Valve.read(text, ""))

    def fit(
        self,
        valve: Valve,
        points_mm: ArrayLike,
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
        """Fits chordae, papillary tips and tissue of a valve to its imaged closed leaflets; Ctrl-C ends the fit with the best result so far.

        >>> fitted, told = coapt.engine().fit(valve, valve.close().closed_mm, side="middle", points=300, rounds=1)
        >>> fitted.close().trusted, told.rms_mm < 1
        (True, True)

        :param points_mm: N x 3, of the closed surface in the valve's own frame
        :param side: surface of the leaflets that was imaged
        :param leak_mm2: imaged leak, with standard deviation leak_sd_mm2
        :param known: parameters that are not fitted
        :param ruptured: estimate for each scallop whether its marginal chordae are ruptured
        :param points: maximum number of surface points
        :param rounds: maximum number of rounds of each pass
        :param progress: called with the rounds done and the distance left, rms in mm
        """
        with refusing():
            points_document = json.loads(engine_module().points_document(points_mm))
        surface = {"mesh": {"vertices_mm": points_document}, "source": "an array"}
        target = fit_target(side, leak_mm2, leak_sd_mm2, known, ruptured, points, rounds)
        request = {"valve": self._request_source(self._read(valve)), "surface": surface, "frame": "valve"} | target
        with refusing():
            answer = with_threads_of_ones_own(self._local.service.compute, "fit", encoded(request), progress)
        told = json.loads(answer)
        fitted = engine_module().Valve.read(json.dumps(told["fitted"]), "")
        return LocalValve(self, fitted), FitResult.from_json(told)

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

    def _closure(self, source: LocalValve, plan: Any, options: Mapping[str, Any] = {}) -> Closure:
        asked = given(plan=plan) | dict(options)
        with refusing():
            return local_closure(source.native.close(encoded(asked)))


class LocalValve(CopiedAsItself, NativeValve):
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

    engine: Engine

    def __reduce__(self) -> tuple[Any, ...]:
        return _valve_of, (self.native.write(),)

    def id(self, engine: Engine) -> str:
        """By which requests to this engine name it; it is stored if need be.

        >>> valve.id(valve.engine)
        'human-functional-mr'
        """
        if engine is not self.engine:
            return engine.put_valve(self.to_json()).id
        if self._name is not None:
            return self._name
        service = engine._local.service
        if self._stored[0] is not service:
            self._stored = service, engine.put_valve(self.to_json()).id
        return self._stored[1]

    def space(
        self,
        *steps: Step | PlanSource,
        fixed: PlanSource | None = None,
        forbidden: Sequence[str] | None = None,
        rules: Mapping[str, Any] | None = None,
        objective: Objective | None = None,
    ) -> Space:
        """The plans that a search of this valve may try, as vectors of numbers for optimisers of one's own.

        >>> valve = coapt.preset("human-functional-mr")
        >>> space = valve.space(Ring("generic-classic", 30), PapillaryApproximation("posteromedial", 22))
        >>> space.names, space.get_bounds()
        (('ring_size_mm', 'posteromedial_movement_mm'), ([24.0, 3.0], [32.0, 10.0]))
        >>> from scipy.optimize import Bounds, minimize
        >>> found = minimize(space, space.start, method="Nelder-Mead", bounds=Bounds(*space.get_bounds()), options={"maxfev": 9})
        >>> found.fun <= space(space.start)
        True

        :param steps: or a plan: its operation alone, of which sizes, lengths and places are free; none: all that is indicated
        :param fixed: as in Engine.search(), likewise forbidden and rules
        :param objective: of a closure, less is better; None: its leak
        :raises InvalidRequest: rules are wrong, or this valve is not offered such an operation
        """
        return space_of(self, steps, search_rules(fixed, forbidden, rules), objective)

    # The engine's functions, of this valve.

    close = of_this_valve(Engine.close)
    open = of_this_valve(Engine.open)
    diagnose = of_this_valve(Engine.diagnose)
    physiology = of_this_valve(Engine.physiology)
    evaluate = of_this_valve(Engine.evaluate)
    search = of_this_valve(Engine.search)
    study = of_this_valve(Engine.study)
    fit = of_this_valve(Engine.fit)
    picture = of_this_valve(Engine.picture)
    scene = of_this_valve(Engine.scene)
    export = of_this_valve(Engine.export)
    report = of_this_valve(Engine.report)

    def compare(
        self,
        reference: ShapeSource,
        plan: PlanSource | None = None,
        *,
        align: Literal["auto", "none", "rigid"] = "auto",
    ) -> Comparison:
        """The closed valve with a reference: see Engine.compare().

        >>> valve.compare(valve.close(), plan).max_mm > 1
        True
        """
        return self.engine.compare(self.close(plan), reference, align=align)


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
