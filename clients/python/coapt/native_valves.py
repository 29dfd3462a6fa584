"""What a valve in this process is made of: its arrays, chordae, tips and tissue, and how another is made of it."""

from __future__ import annotations

import json
import pathlib
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Self

from .asking import given
from .errors import BadDocument
from .files import Path
from .local_transport import engine_module, reading, refusing
from .sources import ValveHere
from .transport import encoded

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike, NDArray

    from . import _engine


class NativeValve(ValveHere):
    """See LocalValve."""

    def __init__(self, engine: Any, native: _engine.Valve, id: str | None = None) -> None:
        """
        :param engine: an Engine
        :param id: by which the engine's requests name it; None: it is not stored yet
        """
        self.engine, self.native, self._name = engine, native, id
        self._stored: tuple[_engine.Service | None, str] = (None, "")  # where, and under which id

    def __eq__(self, other: object) -> bool:
        return self is other or isinstance(other, NativeValve) and self.native.write() == other.native.write()

    def __hash__(self) -> int:
        return hash(self.native.write())

    def __repr__(self) -> str:
        vertices, triangles = self.native.counts
        return f"{type(self).__name__}({self.name!r}, {vertices} vertices, {triangles} triangles)"

    @property
    def name(self) -> str:
        """Of its document.

        >>> valve.name
        'human-functional-mr'
        """
        return self.native.name

    @property
    def vertices_mm(self) -> NDArray[numpy.float64]:
        """V x 3, unstressed.

        >>> valve.vertices_mm.shape, valve.vertices_mm.flags.writeable
        ((378, 3), False)
        """
        return self.native.vertices_mm

    @property
    def faces(self) -> NDArray[numpy.int32]:
        """F x 3, numbers of vertices from 0; counter-clockwise seen from the atrium.

        >>> corners_mm = valve.vertices_mm[valve.faces]  # F x 3 x 3
        """
        return self.native.faces

    @property
    def annulus_mm(self) -> NDArray[numpy.float64]:
        """A x 3, under pressure, in the order of the annulus's loop.

        >>> height_mm = valve.annulus_mm[:, 2].max() - valve.annulus_mm[:, 2].min()
        """
        return self.native.annulus_mm

    def to_json(self) -> dict[str, Any]:
        """The coapt.valve/1."""
        document: dict[str, Any] = json.loads(self.native.write())
        return document

    def with_arrays(
        self,
        *,
        vertices_mm: ArrayLike | None = None,
        faces: ArrayLike | None = None,
        annulus_mm: ArrayLike | None = None,
    ) -> Self:
        """A valve that has these instead, copied; the rest is this one's.

        >>> valve = coapt.preset("human-normal")
        >>> try:
        ...     valve.with_arrays(annulus_mm=valve.annulus_mm[:, :2])
        ... except coapt.BadDocument as error:
        ...     print(error.problems[0].path)
        /annulus_mm

        :param vertices_mm: V x 3, unstressed, an array or list of any numbers
        :param faces: F x 3, of any integers
        :param annulus_mm: A x 3, under pressure
        :raises BadDocument: no numbers, another shape, a number that is not finite, or no valve: problems say where
        """
        with reading("these arrays make no valve"):
            return type(self)(self.engine, self.native.with_arrays(vertices_mm, faces, annulus_mm))

    def replace(
        self,
        *,
        name: str | None = None,
        pressure_mmhg: float | None = None,
        tissue: Mapping[str, float] | None = None,
        papillary_mm: Mapping[str, Sequence[float]] | None = None,
        chordae: Iterable[Mapping[str, Any]] | None = None,
    ) -> Self:
        """A valve that has these instead; the rest is this one's.

        >>> valve = coapt.preset("human-normal")
        >>> outwards = valve.papillary_mm["posteromedial"] + [5, 0, -5]
        >>> displaced = valve.replace(pressure_mmhg=140, papillary_mm={"posteromedial": outwards})
        >>> displaced.close().measure.tenting_height_mm > valve.close().measure.tenting_height_mm
        True
        >>> without = valve.replace(chordae=[one for one in valve.chordae if one["kind"] != "strut"])

        :param pressure_mmhg: across the closed valve
        :param tissue: as of Engine.close()
        :param papillary_mm: of a side, where the mean of its heads goes under pressure; the heads move as one, unpressurised too
        :param chordae: as in chordae
        :raises InvalidRequest: of pressure and tissue, with the accepted range
        :raises BadDocument: the rest makes no valve
        """
        made = self
        if name is not None or papillary_mm is not None or chordae is not None:
            document = self.to_json() | given(name=name, chordae=None if chordae is None else list(chordae))
            for side, to in (papillary_mm or {}).items():
                if side not in self.papillary_mm:
                    raise BadDocument(f"papillary_mm: {side!r} must be one of {', '.join(self.papillary_mm)}")
                by = [float(a - b) for a, b in zip(to, self.papillary_mm[side], strict=True)]
                for head in document["papillary_heads"]:
                    if head["side"] == side:
                        for place in ("rest_mm", "tip_mm"):
                            head[place] = [a + b for a, b in zip(head[place], by)]
            with reading("these make no valve"):
                made = type(self)(self.engine, engine_module().Valve.read(json.dumps(document), ""))
        if material := given(pressure_mmhg=pressure_mmhg) | dict(tissue or {}):
            with refusing():
                made = type(self)(self.engine, made.native.with_material(encoded(material)))
        return made

    @property
    def papillary_mm(self) -> dict[str, NDArray[numpy.float64]]:
        """Of each side the mean of its heads under pressure.

        >>> sorted(valve.papillary_mm)
        ['anterolateral', 'posteromedial']
        """
        import numpy

        heads = self.to_json()["papillary_heads"]
        sides = dict.fromkeys(head["side"] for head in heads)
        return {side: numpy.mean([one["tip_mm"] for one in heads if one["side"] == side], axis=0) for side in sides}

    @property
    def chordae(self) -> list[dict[str, Any]]:
        """As in the coapt.valve/1.

        >>> sorted({one["kind"] for one in valve.chordae})
        ['basal', 'marginal', 'strut']
        """
        chordae: list[dict[str, Any]] = self.to_json()["chordae"]
        return chordae

    def save(self, path: Path) -> None:
        """To a file of a coapt.valve/1, which read_valve() reads; close().save() writes what other programs open.

        >>> valve = coapt.preset("human-normal")
        >>> valve.save("normal.json")
        >>> coapt.read_valve("normal.json") == valve
        True
        """
        pathlib.Path(path).write_text(self.native.write(), encoding="utf-8")
