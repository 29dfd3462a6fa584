"""How requests reach what answers them."""

from __future__ import annotations

import http.client
import json
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Protocol, Self

from .errors import BadDocument, Unreachable

LOST = (OSError, http.client.HTTPException)  # the answer, or a part of it, did not come


class CopiedAsItself:
    """What holds a connection or native state: copies of it are the same object."""

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: Any) -> Self:
        return self


@dataclass(frozen=True)
class Answer:
    status: int
    headers: Mapping[str, str]  # names in lower case
    body: bytes

    def json(self) -> Any:
        return json.loads(self.body)


class Stream(Protocol):
    """An answer that is still coming: its lines."""

    status: int

    def __iter__(self) -> Iterator[bytes]:
        ...


class Transport(Protocol):
    """ends_with_us: what answers is this process, so that jobs do not outlive it."""

    @property
    def ends_with_us(self) -> bool:
        ...

    def request(
        self,
        method: str,
        path: str,
        body: Any = None,
        headers: Mapping[str, str] | None = None,
        query: Mapping[str, Any] | None = None,
    ) -> Answer:
        """The answer, of a status below 400.

        :param path: percent-encoded
        :param body: sent as JSON unless None
        :raises BadDocument: the body is no JSON
        :raises Refused: what is wrong
        :raises Unreachable: no answer
        """

    def follow(self, path: str, headers: Mapping[str, str], timeout_s: float) -> AbstractContextManager[Stream]:
        """One try of a GET whose answer has no end known beforehand. Raises Refused and LOST."""

    def unreachable(self, error: Exception) -> Unreachable:
        ...

    def pause(self, seconds: float) -> None:
        ...


def encoded(body: Any) -> bytes:
    try:
        return json.dumps(body, allow_nan=False).encode()
    except (TypeError, ValueError) as error:
        raise BadDocument(f"what was to be sent is no JSON: {error}") from error
