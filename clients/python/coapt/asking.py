"""How questions about valves are asked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from .errors import InvalidRequest, Problem, Refused
from .files import did_you_mean
from .sources import PlanSource, Valve, plan_document, valve_document
from .transport import Answer, Transport


def given(**fields: Any) -> dict[str, Any]:
    return {name: value for name, value in fields.items() if value is not None}


def search_rules(
    fixed: PlanSource | None, forbidden: Sequence[str] | None, rules: Mapping[str, Any] | None
) -> dict[str, Any]:
    """The "rules" of a request."""
    return dict(rules or {}) | given(
        fixed=None if fixed is None else plan_document(fixed),
        forbidden=None if forbidden is None else list(forbidden),
    )


MOST_THREADS = 1024


def checked_threads(threads: Any) -> int:
    """How many threads something may have, 0 for all cores: the same wherever threads are asked for.

    :raises InvalidRequest: no integer from 0 to 1,024
    """
    if isinstance(threads, int) and not isinstance(threads, bool) and 0 <= threads <= MOST_THREADS:
        return threads
    problem = Problem(
        "out_of_range",
        "/threads",
        f"is {threads!r}, must be an integer from 0 (all cores) to {MOST_THREADS:,}",
    )
    raise InvalidRequest(422, "number of threads out of range", [problem])


class Asking:
    """Questions, and how an answer that refuses them is told."""

    def __init__(self, transport: Transport) -> None:
        self._transport = transport

    def presets(self) -> list[str]:
        """Names of the preset valves.

        >>> "human-normal" in client.presets()
        True
        """
        return [preset["name"] for preset in self._get("/v1/presets")["presets"]]

    def _ask(
        self,
        path: str,
        valve: Valve,
        request: Mapping[str, Any],
        headers: Mapping[str, str] | None = None,
    ) -> Answer:
        """The answer to a request about a valve."""
        source = self._request_source(valve)
        try:
            return self._transport.request("POST", path, {"valve": source, **request}, headers)
        except InvalidRequest as error:
            if isinstance(source, str) and any(problem.path == "/valve" for problem in error.problems):
                raise self._with_preset(error, source) from None
            raise

    def _request_source(self, valve: Valve) -> Any:
        """What a request carries of a valve."""
        return valve_document(valve)

    def _with_preset(self, error: Refused, name: str) -> Refused:
        """The error, with the preset that an unknown valve's name may stand for."""
        hint = did_you_mean(name, self.presets())
        problems = [
            replace(problem, message=problem.message + hint) if problem.path in ("", "/valve") else problem
            for problem in error.problems
        ]
        return type(error)(error.status, error.title, problems, error.retry_after_s)

    def _listed(self, path: str, name: str, query: Mapping[str, Any] | None = None) -> Iterator[Any]:
        """Every member of a list that comes in pages."""
        asked = {"page_size": 100, **(query or {})}
        while True:
            page = self._transport.request("GET", path, query=asked).json()
            yield from page[name]
            if page["next_page_token"] is None:
                return
            asked["page_token"] = page["next_page_token"]

    def _get(self, path: str) -> Any:
        return self._transport.request("GET", path).json()

    def _post(self, path: str, request: Any) -> Any:
        return self._transport.request("POST", path, request).json()
