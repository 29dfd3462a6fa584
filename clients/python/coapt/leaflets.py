"""The leaflets of a closure and what they bear: of the engine in this process, of a service, of a closure that was pickled."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, Protocol

from .closures import Closure, Measure
from .errors import CoaptError
from .fields import Fields
from .local_transport import reading
from .meshes import Mesh
from .transport import Answer

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    from . import _engine


def local_closure(native: _engine.Closure) -> Closure:
    """Its figures as they are; its document is written when it is asked for."""
    valve, status, crossing, residual, steps, seconds, figures, warnings = native.told()

    @cache
    def document() -> Any:
        return json.loads(native.document())

    measure = Measure(*(*figures, document))
    return Closure(
        valve, status, crossing, residual, steps, seconds, measure, warnings, document, LocalLeaflets(native)
    )


def known(told: Fields | None) -> Fields:
    if told is None:
        raise CoaptError("this closure diverged, so it has no strain, contact and tension")
    return told


class LocalLeaflets:
    """Of a closure in this process."""

    def __init__(self, native: _engine.Closure) -> None:
        self.native = native

    @cached_property
    def _told(self) -> Fields | None:
        told = self.native.fields()
        return Fields.of_engine(told) if told else None

    def fields(self) -> Fields:
        """:raises CoaptError: the closure diverged"""
        return known(self._told)

    def file(self, path: str, open: bool) -> bytes:
        """:raises BadDocument: another ending than of formats that are known"""
        with reading("the closure cannot be written"):
            return self.native.file(path, open)

    def __call__(self) -> Mesh:
        return Mesh(self.native.closed_mm, self.native.faces, self.fields, self.native.doubt)

    def __reduce__(self) -> tuple[Any, ...]:
        # Its numbers: elsewhere there is no engine that has them.
        return KeptLeaflets, (self.native.closed_mm, self.native.faces, self._told, self.native.doubt)


@dataclass(frozen=True, eq=False)
class KeptLeaflets:
    """Of a closure that was pickled."""

    closed_mm: NDArray[numpy.float64]
    faces: NDArray[numpy.int32]
    told: Fields | None
    doubt: str = ""

    def fields(self) -> Fields:
        """:raises CoaptError: the closure diverged"""
        return known(self.told)

    def __call__(self) -> Mesh:
        return Mesh(self.closed_mm, self.faces, self.fields, self.doubt)


class Asks(Protocol):
    """Asking._ask()."""

    def __call__(self, path: str, valve: Any, request: Mapping[str, Any], /) -> Answer:
        ...


class ServiceLeaflets:
    """Of a closure of a service, which closes again for each: the same bits, fewer digits."""

    def __init__(self, ask: Asks, valve: Any, repair: Mapping[str, Any]) -> None:
        self._ask, self._valve, self._repair = ask, valve, repair

    @cached_property
    def _told(self) -> Fields | None:
        scene = self._ask("/v1/scenes", self._valve, self._repair).json()
        return None if scene["strain"] is None else Fields.of_scene(scene)

    def fields(self) -> Fields:
        """:raises CoaptError: the closure diverged"""
        return known(self._told)

    def file(self, path: str, open: bool) -> bytes:
        """:raises InvalidRequest: another ending than of formats that are known"""
        last = path.rpartition(".")[2]
        ending = next((one for one in ("mrk.json", "nii.gz") if path.endswith(f".{one}")), last)
        asked = {**self._repair, "format": ending, "open": open}
        return self._ask("/v1/exports", self._valve, asked).body

    def __call__(self) -> Mesh:
        ply = self._ask("/v1/exports", self._valve, {**self._repair, "format": "ply"}).body
        return Mesh.from_ply(ply, self.fields)
