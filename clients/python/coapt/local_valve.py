"""A valve in this process."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from .local_transport import reading

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    from . import _engine
    from .closures import Closure
    from .comparison import Comparison, ShapeSource
    from .engine import Engine
    from .fits import FitResult
    from .jobs import Job
    from .meshes import Picture
    from .openings import Opening
    from .results import Evaluations, SearchResult, StudyResult
    from .sources import PlanSource


class LocalValve:
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
        self.engine, self.native, self._id = engine, native, id

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
        if self._id is None:
            self._id = engine.put_valve(self.to_json()).id
        return self._id

    # The engine's functions, of this valve.

    def close(self, plan: PlanSource | None = None) -> Closure:
        """See Engine.close()."""
        return self.engine.close(self, plan)

    def open(self, plan: PlanSource | None = None, **options: Any) -> Opening:
        """See Engine.open()."""
        return self.engine.open(self, plan, **options)

    def picture(self, plan: PlanSource | None = None) -> Picture:
        """See Engine.picture()."""
        return self.engine.picture(self, plan)

    def evaluate(self, plans: Any, region_points: int | None = None, evidence: bool | None = None) -> Evaluations:
        """See Engine.evaluate()."""
        return self.engine.evaluate(self, plans, region_points, evidence)

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
