"""The engine, in C++ (clients/python/engine). Arrays are read-only views."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy
from numpy.typing import ArrayLike, NDArray

Status = Literal["converged", "step_limit", "diverged"]

class Problems(Exception):
    """Its text is a list of problems as JSON."""

class Valve:
    name: str
    counts: tuple[int, int]
    vertices_mm: NDArray[numpy.float64]
    faces: NDArray[numpy.int32]
    annulus_mm: NDArray[numpy.float64]
    @staticmethod
    def read(document: str, path: str) -> Valve: ...
    def write(self) -> str: ...
    def with_arrays(
        self,
        vertices_mm: ArrayLike | None,
        faces: ArrayLike | None,
        annulus_mm: ArrayLike | None,
    ) -> Valve: ...
    def with_material(self, material: bytes) -> Valve: ...
    def close(self, request: bytes) -> Closure: ...

class Closure:
    closed_mm: NDArray[numpy.float64]
    faces: NDArray[numpy.int32]
    def document(self) -> str: ...
    def fields(self) -> dict[str, Any]: ...
    def file(self, path: str, open: bool) -> bytes: ...
    def told(
        self,
    ) -> tuple[str, Status, bool, float | None, int, float, Sequence[Any], tuple[str, ...]]:
        """Name, status, crossing, residual, steps, seconds, the figures of a Measure, warnings."""

class Shape:
    vertices_mm: NDArray[numpy.float64]
    @staticmethod
    def of_closure(closed: Closure) -> Shape: ...
    @staticmethod
    def of_arrays(source: str, vertices_mm: NDArray[numpy.float64], faces: NDArray[numpy.int32]) -> Shape: ...
    @staticmethod
    def of_file(source: str, bytes: bytes, format: str) -> Shape: ...

class Comparison:
    document: str
    moved_mm: NDArray[numpy.float64]
    signed_mm: NDArray[numpy.float64]

def read_mesh(bytes: bytes, format: str) -> tuple[NDArray[numpy.float64], NDArray[numpy.int32]]: ...
def write_mesh(vertices_mm: ArrayLike, faces: ArrayLike, format: str) -> bytes: ...

class Space:
    def __init__(self, valve: Valve, search: str, indicated: bool) -> None: ...
    def document(self) -> str: ...
    def plan(self, branch: int, at: Sequence[int]) -> str: ...
    def place(self, branch: int, at: Sequence[int]) -> list[float]: ...

def guess(
    places: Sequence[Sequence[float]], values: Sequence[float], usual_sd: float, at: Sequence[Sequence[float]]
) -> tuple[list[float], list[float]]: ...
def order(
    plans: Sequence[Mapping[str, Any]],
    by_price: bool,
    acceptable: float,
    same_durability_mm: float,
    same_gradient_mmhg: float,
) -> list[tuple[int, int]]: ...

class Stream:
    def next(self) -> bytes | None: ...

class Service:
    def __init__(self, database: str, threads: int) -> None: ...
    def named(self, name: str) -> Valve: ...
    def request(
        self, method: str, path: str, query: Mapping[str, str], headers: Mapping[str, str], body: bytes
    ) -> tuple[int, Sequence[tuple[str, str]], bytes | Stream]: ...
    def close(self) -> None: ...

def compare(closed: Shape, reference: Shape, align: str) -> Comparison: ...
def fit(
    valve: Valve,
    points_mm: NDArray[numpy.float64],
    side: str,
    leak_mm2: float | None,
    leak_sd_mm2: float | None,
    known: Sequence[str],
    points: int | None,
    rounds: int | None,
    ruptures: bool,
    threads: int,
    progress: Callable[[int, float], object] | None,
) -> tuple[Valve, str]: ...
