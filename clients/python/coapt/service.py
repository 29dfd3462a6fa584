"""What can be asked for, as functions. What it takes and answers is in server/openapi.json."""

from __future__ import annotations

import uuid
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

from .asking import checked_threads, given, search_rules
from .files import Path
from .fits import Fit, FitResult, ImportResult, Known, fit_target
from .imports import OF_SLICERHEART, files_to_import, packed, packed_files, packed_folder
from .jobs import Job
from .results import SearchResult, StudyResult
from .short_work import repair_of
from .sources import PlanSource, Valve
from .stored_work import StoredWork, path_of
from .transport import Transport

Protocol = Literal["lookup-clamped", "lookup-extended", "closed", "optimum"]
StudyName = Literal["annulus", "papillary", "ring", "approximation", "thesis"]


def document_of(json: Any, *_: Any) -> Any:
    """A result that is a document."""
    return json


class Service(StoredWork):
    """What Client (a coapt-server) and Engine (this process) can both do; code that takes a Service runs with either.

    >>> def leak_mm2(service: coapt.Service, valve: str) -> float:
    ...     return service.close(valve).measure.leak_mm2
    >>> leak_mm2(coapt.engine(), "human-functional-mr") > 5
    True
    """

    def __init__(self, transport: Transport, patience_s: float = 60.0) -> None:
        super().__init__(transport)
        self._patience_s = patience_s

    def version(self) -> str:
        """Of what answers.

        >>> client.version() == coapt.__version__
        True
        """
        return str(self._get("/version")["version"])

    def search(
        self,
        valve: Valve,
        *,
        evaluations: int | None = None,
        front_share: float | None = None,
        seed: int | None = None,
        plans: int | None = None,
        region_points: int | None = None,
        evidence: bool | None = None,
        openings: bool | None = None,
        fine_levels: int | None = None,
        model_draws: int | None = None,
        rank_by_price: bool | None = None,
        seconds: float | None = None,
        no_improvement: int | None = None,
        target_mm2: float | None = None,
        threads: int | None = None,
        fixed: PlanSource | None = None,
        forbidden: Sequence[str] | None = None,
        rules: Mapping[str, Any] | None = None,
        weights: Mapping[str, float] | None = None,
        idempotency_key: str | None = None,
    ) -> Job[SearchResult]:
        """Searches for repair plans. Omitted options have the default of the service, given in brackets.

        >>> rules = dict(forbidden=["neochorda"], fixed=Plan(OwnRing(2)))
        >>> job = client.search("human-functional-mr", evaluations=20, plans=1, region_points=2, evidence=False, **rules)
        >>> OwnRing(2) in job.result().plans[0].plan.steps
        True

        :param evaluations: maximum number of closures for the search itself; ranking needs more (2,000)
        :param front_share: extra closures, as a fraction of those, for exploring trade-offs between leak, opening and reserve (0.3)
        :param seed: the same seed gives the same plans (1)
        :param plans: number of ranked plans to report, up to 50 (5)
        :param region_points: number of nodes of each reported plan's region of interest to close, 1 to 1,089 (1,089)
        :param evidence: also close the reported plans with errors of single sutures, further remodelling and disease (True)
        :param openings: also open plans in diastole, once they are closed at more than one node (True)
        :param fine_levels: number of mesh refinements for the final check of each reported plan, 0 to 2 (1)
        :param model_draws: number of variants of tissue and chordae in which each reported plan is closed as planned, 0 to 200 (8)
        :param rank_by_price: rank acceptable plans by cost instead of by equivalence classes (False)
        :param seconds: time limit, of which the last 40 % is reserved for ranking; 0: none (0)
        :param no_improvement: stop after this many closures without a better plan; 0: never (0)
        :param target_mm2: stop once the leak of a plan (mean + sd over 17 nodes) is at or below this; -1: never (-1)
        :param threads: number of threads, 0: all cores; does not change the result (0)
        :param fixed: steps that every plan must include
        :param forbidden: techniques that no plan may include: "neochorda", "papillary_approximation:saddle_peak", "annuloplasty:own", ...
        :param rules: further rules of io/schema/search.schema.json; fixed and forbidden go into them
        :param weights: of the cost, likewise
        :param idempotency_key: the same key with the same request gives the same job; a new one by default
        """
        search = given(
            evaluations=evaluations,
            front_share=front_share,
            seed=seed,
            threads=None if threads is None else checked_threads(threads),
            plans=plans,
            region_points=region_points,
            evidence=evidence,
            openings=openings,
            fine_levels=fine_levels,
            model_draws=model_draws,
            rank_by_price=rank_by_price,
            seconds=seconds,
            no_improvement=no_improvement,
            target_mm2=target_mm2,
            rules=search_rules(fixed, forbidden, rules) or None,
            weights=None if weights is None else dict(weights),
        )
        json = self._submit("/v1/plans", valve, {"search": search}, idempotency_key)
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

        >>> result = client.study("porcine-3", "annulus").result()
        >>> result.findings[0].section, sum(finding.agrees for finding in result.findings) > 0
        ('4.3.1', True)

        :param protocols: methods that determine the orifice at a position (both look-ups)
        :param displacement_step_mm: step of the displacements, 1, 2, 3 or 6
        :param region_points: number of nodes of each region of interest to close, 17 to 1,089
        :param scan_sites: number of anchors around the annulus, in addition to trigone and saddle peak, 0 to 360
        """
        study = {"name": name} | given(
            protocols=None if protocols is None else list(protocols),
            scan_sites=scan_sites,
            displacement_step_mm=displacement_step_mm,
            region_points=region_points,
        )
        json = self._submit("/v1/studies", valve, {"study": study}, idempotency_key)
        return Job(self._transport, json, StudyResult.from_json, self._patience_s)

    def import_job(
        self,
        leaflets: Iterable[Path | Any] | Path = (),
        annulus: Path | Any | None = None,
        chordae: Path | int | None = None,
        *,
        files: Iterable[Path | Any] | Path | None = None,
        slicerheart: Path | None = None,
        tips: Path | Any | None = None,
        fit: Fit | None = None,
        name: str = "imported",
        idempotency_key: str | None = None,
        **options: Any,
    ) -> Job[ImportResult]:
        """The imports above as a job, which also draws the valve beside the input and fits it, in seconds to minutes.

        >>> folder = "examples/valves/source/bodyparts3d"
        >>> leaflets = [f"{folder}/{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
        >>> job = client.import_job(leaflets, f"{folder}/annulus_centerline.csv", 1, name="chordae drawn by seed")
        >>> result = job.wait().result()
        >>> result.picture().write("import.png")
        >>> client.close(result.valve).valve
        'chordae drawn by seed'

        :param files: as import_files(), instead of leaflets, annulus and chordae
        :param slicerheart: a folder, likewise
        :param chordae: CSV or JSON, or a seed; of a folder a seed alone, where it has none
        :param fit: None: the valve is not fitted
        :param options: as import_valve(), and landmarks: a mapping of "anterolateral_commissure",
            "posteromedial_commissure", "saddle_peak" and "mid_posterior" to x, y, z in the files' coordinates
        :raises Refused: what is wrong with which file, at once
        """
        if files is not None:
            parts: dict[str, Any] = {"files": packed_files(files)} | given(chordae_seed=chordae)
        elif slicerheart is not None:
            parts = {"slicerheart": packed_folder(slicerheart, OF_SLICERHEART)} | given(chordae_seed=chordae)
        elif (isinstance(leaflets, tuple) and not leaflets) or chordae is None:
            raise TypeError("import_job() takes files, or leaflets and chordae, or slicerheart")
        else:
            parts = files_to_import(leaflets, annulus, chordae, tips)
        request = parts | options | {"name": name} | given(fit=None if fit is None else fit.to_json())
        key = {"Idempotency-Key": idempotency_key or uuid.uuid4().hex}
        json = self._transport.request("POST", "/v1/imports", request, key).json()
        return Job(self._transport, json, ImportResult.from_json, self._patience_s)

    def fit_job(
        self,
        valve: Valve,
        surface: Path | Any,
        *,
        frame: Literal["patient", "valve"] | None = None,
        side: Literal["atrial", "middle"] = "atrial",
        leak_mm2: float | None = None,
        leak_sd_mm2: float | None = None,
        known: Iterable[Known] = (),
        ruptured: bool = False,
        points: int | None = None,
        rounds: int | None = None,
        idempotency_key: str | None = None,
    ) -> Job[FitResult]:
        """Fits chordae, papillary tips and tissue of a valve to its imaged closed leaflets; the fitted valve is json["fitted"] of the result.

        >>> closed = client.close("porcine-1").leaflets()
        >>> fit = client.fit_job("porcine-1", closed, side="middle", points=200, rounds=1).result()
        >>> fit.rms_mm < 0.3, fit.json["fitted"]["schema"]
        (True, 'coapt.valve/1')

        :param surface: a mesh or points in memory, or a file: OBJ, PLY, STL, VTK, VTP, VTU, or points (CSV), in mm
        :param frame: of the surface: that of the images (the default where the valve knows it), or the valve's own
        :param side: surface of the leaflets that was imaged
        :param leak_mm2: imaged leak, with standard deviation leak_sd_mm2
        :param known: parameters that are not fitted
        :param ruptured: estimate for each scallop whether its marginal chordae are ruptured
        :param points: maximum number of surface points
        :param rounds: maximum number of rounds of each pass
        """
        target = fit_target(side, leak_mm2, leak_sd_mm2, known, ruptured, points, rounds)
        request = target | {"surface": {"file": packed(surface)}} | given(frame=frame)
        json = self._submit("/v1/fits", valve, request, idempotency_key)
        return Job(self._transport, json, FitResult.from_json, self._patience_s)

    def model_job(
        self,
        valve: Valve,
        plan: PlanSource | None = None,
        *,
        draws: int | None = None,
        seed: int | None = None,
        idempotency_key: str | None = None,
    ) -> Job[dict[str, Any]]:
        """Closes variants of tissue and chordae of a valve, optionally repaired by a plan (coapt.model_study/2): "leak" with its mean,
        standard deviation and percentiles, and the Sobol indices of each of its "parameters".

        >>> study = client.model_job("porcine-1", draws=4).result()
        >>> study["schema"], study["draws"]
        ('coapt.model_study/2', 4)

        :param draws: number of variants (256)
        :param seed: of the draws (1)
        """
        request = repair_of(plan, **given(draws=draws, seed=seed))
        json = self._submit("/v1/model-studies", valve, request, idempotency_key)
        return Job(self._transport, json, document_of, self._patience_s)

    def job(self, id: str) -> Job[Any]:
        """A job that was begun before.

        >>> client.job(job.id).result() == result
        True
        """
        return self._job(self._get(path_of("/v1/jobs", id)))

    def jobs(self, state: str | None = None) -> Iterator[Job[Any]]:
        """All jobs, newest first; only those QUEUED, RUNNING, SUCCEEDED, FAILED or CANCELLED if state says so.

        >>> job.id in [one.id for one in client.jobs("SUCCEEDED")]
        True
        """
        yield from map(self._job, self._listed("/v1/jobs", "jobs", given(state=state)))

    def _job(self, json: Mapping[str, Any]) -> Job[Any]:
        readers: dict[str, Any] = {
            "plans": SearchResult.from_json,
            "study": StudyResult.from_json,
            "import": ImportResult.from_json,
            "fit": FitResult.from_json,
        }
        return Job(self._transport, json, readers.get(json["kind"], document_of), self._patience_s)

    def _submit(self, path: str, valve: Valve, request: Mapping[str, Any], key: str | None) -> Any:
        return self._ask(path, valve, request, {"Idempotency-Key": key or uuid.uuid4().hex}).json()
