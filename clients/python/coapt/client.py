"""The service, as functions. What it takes and answers is in its /openapi.json."""

from __future__ import annotations

import json
import os
import urllib.parse
import uuid
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from .errors import Problem
from .jobs import Job
from .meshes import Picture
from .repair import Plan
from .results import Closure, Evaluations, RankedPlan, SearchResult, StudyResult, known_fields
from .transport import Transport

Valve: TypeAlias = str | Mapping[str, Any] | os.PathLike[str]
"""A preset's name or the id of a stored valve; a coapt.valve/1 document; or the path (pathlib.Path) of a file of one."""

Protocol = Literal["lookup-clamped", "lookup-extended", "closed", "optimum"]
FileFormat = Literal["glb", "vtk", "ply", "obj", "stl", "mrk.json", "csv", "feb"]
StudyName = Literal["annulus", "papillary", "ring", "approximation", "thesis"]

LOCAL = "http://127.0.0.1:8080"


@dataclass(frozen=True)
class StoredValve:
    id: str
    vertices: int
    triangles: int
    chordae: int


@dataclass(frozen=True)
class RingShape:
    """Widths are shares of the labelled transverse size; transverse_factor: true transverse width over the label."""

    name: str
    ap_over_transverse: float
    transverse_factor: float
    saddle_over_transverse: float
    note: str


def _document(valve: Valve) -> Any:
    if isinstance(valve, os.PathLike):
        with open(valve, encoding="utf-8") as file:
            return json.load(file)
    return valve


def _plan(plan: Plan | RankedPlan | Mapping[str, Any]) -> Any:
    if isinstance(plan, RankedPlan):
        plan = plan.plan
    return plan.to_json() if isinstance(plan, Plan) else plan


def _repair(valve: Valve, plan: Plan | RankedPlan | Mapping[str, Any] | None) -> dict[str, Any]:
    return {"valve": _document(valve)} | ({} if plan is None else {"plan": _plan(plan)})


def _plans(valve: Valve, plans: Iterable[Plan | RankedPlan | Mapping[str, Any]], **options: Any) -> dict[str, Any]:
    return {"valve": _document(valve), "plans": [_plan(plan) for plan in plans]} | _given(**options)


def _given(**fields: Any) -> dict[str, Any]:
    return {name: value for name, value in fields.items() if value is not None}


class Client:
    """A coapt-server.

    :param url: COAPT_SERVER or http://127.0.0.1:8080 by default
    :param token: of a service that wants one; COAPT_TOKEN by default
    :param timeout_s: for an answer to come
    :param retries: further tries of requests whose answer got lost or that find the service busy (its Retry-After is kept).
        Jobs carry an idempotency key, so a repeated request makes no second job
    :param patience_s: how long the service may be away while a job is followed
    """

    def __init__(
        self,
        url: str | None = None,
        token: str | None = None,
        *,
        timeout_s: float = 120.0,
        retries: int = 3,
        patience_s: float = 60.0,
    ) -> None:
        self._transport = Transport(
            (url or os.environ.get("COAPT_SERVER") or LOCAL).rstrip("/"),
            token or os.environ.get("COAPT_TOKEN") or None,
            timeout_s,
            retries,
        )
        self._patience_s = patience_s

    @property
    def url(self) -> str:
        return self._transport.url

    def version(self) -> str:
        """Of the service."""
        return str(self._get("/version")["version"])

    # Valves

    def presets(self) -> list[str]:
        """Names of the valves that coapt brings along."""
        return [preset["name"] for preset in self._get("/v1/presets")["presets"]]

    def rings(self) -> list[RingShape]:
        """Shapes that Ring() may name."""
        return [RingShape(**known_fields(RingShape, ring)) for ring in self._get("/v1/rings")["rings"]]

    def put_valve(self, valve: Valve) -> StoredValve:
        """Stores a valve; the same valve has the same id."""
        answer = self._post("/v1/valves", _document(valve))
        return StoredValve(answer["id"], answer["vertices"], answer["triangles"], answer["chordae"])

    def get_valve(self, name: str) -> dict[str, Any]:
        """The coapt.valve/1 of a preset or a stored valve: millimetres; x posteromedial, y anterior, z to the atrium."""
        valve: dict[str, Any] = self._get("/v1/valves/" + urllib.parse.quote(name, safe=""))
        return valve

    def delete_valve(self, id: str) -> None:
        """:raises Conflict: jobs refer to it; delete these first"""
        self._transport.request("DELETE", "/v1/valves/" + urllib.parse.quote(id, safe=""))

    def validate_valve(self, valve: Valve) -> tuple[Problem, ...]:
        """Every problem of what is to be a valve; empty: it is one. Nothing is stored."""
        return tuple(map(Problem.from_json, self._post("/v1/valves:validate", _document(valve))["problems"]))

    # Short work

    def close(self, valve: Valve, plan: Plan | RankedPlan | Mapping[str, Any] | None = None) -> Closure:
        """Closes a valve, repaired if there is a plan, and measures what leaks. Look at Closure.trusted."""
        return Closure.from_json(self._post("/v1/closures", _repair(valve, plan)))

    def export(
        self,
        valve: Valve,
        format: FileFormat,
        plan: Plan | RankedPlan | Mapping[str, Any] | None = None,
        *,
        open: bool = False,
    ) -> bytes:
        """A file that other programs open, of the valve closed, repaired if there is a plan.

        :param open: the unstressed shape, not the closed one; not for csv
        """
        request = _repair(valve, plan) | {"format": format, "open": open}
        return self._transport.request("POST", "/v1/exports", request).body

    def picture(self, valve: Valve, plan: Plan | RankedPlan | Mapping[str, Any] | None = None) -> Picture:
        """The closed valve, repaired if there is a plan, from the atrium and in section, with its figures; a notebook shows it."""
        return Picture(self._transport.request("POST", "/v1/pictures", _repair(valve, plan)).body)

    def scene(
        self, valve: Valve, plan: Plan | RankedPlan | Mapping[str, Any] | None = None, *, frames: int = 0
    ) -> dict[str, Any]:
        """All that is drawn of a closed valve as lists and numbers (coapt.scene/1): points, triangles, chordae with tension,
        orifices, annulus. One end state, where close() takes the mean of five.

        :param frames: 0 to 60 states on the way from open to closed
        """
        scene: dict[str, Any] = self._post("/v1/scenes", _repair(valve, plan) | {"frames": frames})
        return scene

    def evaluate(
        self,
        valve: Valve,
        plans: Iterable[Plan | RankedPlan | Mapping[str, Any]],
        region_points: int | None = None,
        evidence: bool | None = None,
    ) -> Evaluations:
        """Scores plans of one's own as a search scores its finalists, in the order given.

        :param region_points: 1 to 1,089 nodes of each plan's region of interest, 1 by default; plans times nodes must stay
            below the service's limit (1,000 closures)
        :param evidence: each plan also under errors of single sutures and further remodelling, 24 to 284 closures more; not
            by default
        """
        request = _plans(valve, plans, region_points=region_points, evidence=evidence)
        return Evaluations.from_json(self._post("/v1/evaluations", request))

    def report(
        self,
        valve: Valve,
        plans: Iterable[Plan | RankedPlan | Mapping[str, Any]],
        region_points: int | None = None,
        evidence: bool | None = None,
    ) -> str:
        """The page about plans of one's own, ten at most, scored as evaluate() does: HTML that stands alone."""
        request = _plans(valve, plans, region_points=region_points, evidence=evidence)
        return self._transport.request("POST", "/v1/reports", request).body.decode()

    # Long work

    def search(
        self,
        valve: Valve,
        *,
        evaluations: int | None = None,
        seed: int | None = None,
        plans: int | None = None,
        region_points: int | None = None,
        evidence: bool | None = None,
        seconds: float | None = None,
        no_improvement: int | None = None,
        target_mm2: float | None = None,
        threads: int | None = None,
        fixed: Plan | None = None,
        forbidden: Sequence[str] | None = None,
        rules: Mapping[str, Any] | None = None,
        weights: Mapping[str, float] | None = None,
        idempotency_key: str | None = None,
    ) -> Job[SearchResult]:
        """Searches repair plans. What is left out has the service's default, in brackets.

        :param evaluations: closures for the search itself; ranking takes more (2,000)
        :param seed: the same seed gives the same plans (1)
        :param plans: how many ranked plans to report, up to 50 (5)
        :param region_points: 1 to 1,089 nodes of each reported plan's region of interest (1,089)
        :param evidence: close the reported plans also under errors of single sutures and further remodelling (True)
        :param seconds: stop after this time, the last 40 % spent on ranking; 0: no limit (0)
        :param no_improvement: stop after so many closures without a better plan; 0: never (0)
        :param target_mm2: stop when mean + sd of a plan's leak over 17 nodes is not above this; -1: never (-1)
        :param threads: does not change the result; 0: all cores (0)
        :param fixed: steps that every plan must contain
        :param forbidden: what no plan may contain: "neochorda", "papillary_approximation:saddle_peak", "annuloplasty:own", ...
        :param rules: further rules of io/schema/search.schema.json; fixed and forbidden go into them
        :param weights: of the cost, likewise
        :param idempotency_key: the same key with the same request gives the same job; a new one by default
        """
        all_rules = dict(rules or {}) | _given(
            fixed=None if fixed is None else fixed.to_json(), forbidden=None if forbidden is None else list(forbidden)
        )
        search = _given(
            evaluations=evaluations,
            seed=seed,
            threads=threads,
            plans=plans,
            region_points=region_points,
            evidence=evidence,
            seconds=seconds,
            no_improvement=no_improvement,
            target_mm2=target_mm2,
            rules=all_rules or None,
            weights=None if weights is None else dict(weights),
        )
        json = self._submit("/v1/plans", {"valve": _document(valve), "search": search}, idempotency_key)
        return Job(self._transport, json, SearchResult.from_json, self._patience_s)

    def study(
        self,
        valve: Valve,
        name: StudyName = "thesis",
        *,
        protocols: Sequence[Protocol] | None = None,
        displacement_step_mm: int | None = None,
        region_points: int | None = None,
        scan_sites: int | None = None,
        idempotency_key: str | None = None,
    ) -> Job[StudyResult]:
        """Repeats a study of the thesis on a valve. The options are those of "approximation" and "thesis" alone.

        :param protocols: how positions of a region get their orifice (both look-ups)
        :param displacement_step_mm: 1, 2, 3 or 6, of the displaced configurations
        :param region_points: 17 to 1,089 nodes of each region of interest
        :param scan_sites: 0 to 360 anchors around the annulus, besides trigone and saddle peak
        """
        study = {"name": name} | _given(
            protocols=None if protocols is None else list(protocols),
            scan_sites=scan_sites,
            displacement_step_mm=displacement_step_mm,
            region_points=region_points,
        )
        json = self._submit("/v1/studies", {"valve": _document(valve), "study": study}, idempotency_key)
        return Job(self._transport, json, StudyResult.from_json, self._patience_s)

    def job(self, id: str) -> Job[Any]:
        """A job that was begun before."""
        return self._job(self._get("/v1/jobs/" + urllib.parse.quote(id, safe="")))

    def jobs(self, state: str | None = None) -> Iterator[Job[Any]]:
        """All jobs, newest first; only those QUEUED, RUNNING, SUCCEEDED, FAILED or CANCELLED if state says so."""
        query = _given(state=state, page_size=100)
        while True:
            page = self._transport.request("GET", "/v1/jobs", query=query).json()
            yield from map(self._job, page["jobs"])
            if page["next_page_token"] is None:
                return
            query["page_token"] = page["next_page_token"]

    def _job(self, json: Mapping[str, Any]) -> Job[Any]:
        read: Any = SearchResult.from_json if json["kind"] == "plans" else StudyResult.from_json
        return Job(self._transport, json, read, self._patience_s)

    def _submit(self, path: str, request: Any, key: str | None) -> Any:
        return self._transport.request("POST", path, request, {"Idempotency-Key": key or uuid.uuid4().hex}).json()

    def _get(self, path: str) -> Any:
        return self._transport.request("GET", path).json()

    def _post(self, path: str, request: Any) -> Any:
        return self._transport.request("POST", path, request).json()
