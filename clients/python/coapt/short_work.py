"""What is answered at once of a valve and a plan."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, Literal

from .asking import Asking, checked_threads, given
from .closures import Closure
from .comparison import Comparison, ShapeSource, shape_document
from .leaflets import ServiceLeaflets
from .meshes import Picture
from .openings import Opening
from .results import Evaluations
from .sources import PlanSource, Valve, all_named_plans, every_valve, plan_document, valve_document
from .sweep import Sweep, SweepItem

FileFormat = Literal["glb", "vtk", "ply", "obj", "stl", "mrk.json", "csv", "feb", "nrrd", "nii", "nii.gz"]

MOST_THREADS = 32  # of a sweep: a quarter of the requests that a service answers at once


def repair_of(plan: PlanSource | None, **more: Any) -> dict[str, Any]:
    return more | ({} if plan is None else {"plan": plan_document(plan)})


def scoring_of(
    plans: PlanSource | Iterable[PlanSource],
    region_points: int | None,
    evidence: bool | None,
    model_draws: int | None = None,
) -> dict[str, Any]:
    documents = [plan for _, plan in all_named_plans(plans)]
    return {"plans": documents} | given(region_points=region_points, evidence=evidence, model_draws=model_draws)


class ShortWork(Asking):
    """What is answered at once."""

    def close(
        self,
        valve: Valve,
        plan: PlanSource | None = None,
        *,
        pressure_mmhg: float | None = None,
        tissue: Mapping[str, float] | None = None,
        certainty: Literal["quick", "sure", "proof"] | None = None,
        accuracy_mm2: float | None = None,
        method: Literal["fast", "thesis"] | None = None,
        membrane: Literal["continuum", "springs"] | None = None,
    ) -> Closure:
        """Closes a valve, optionally repaired by a plan, and measures its leak. Check Closure.trusted. Options are those of `coapt close`
        and `POST /v1/closures`.

        >>> client.close("human-normal", pressure_mmhg=150, tissue={"radial_extension": 0.08}).trusted
        True
        >>> client.close("human-normal", accuracy_mm2=20).json["accuracy"]["error_mm2"]
        20.0

        :param pressure_mmhg: pressure across the closed valve, overriding its own
        :param tissue: in place of its own: "thickness_mm", "radial_extension", "circumferential_extension" (strains at which
            leaflets become stiff), "radial_stiffness", "circumferential_stiffness" (moduli beyond, times 760 and 2,300 kPa)
        :param certainty: how much time the leak is worth: the mesh as given ("quick"), also one of four times the triangles and the
            mesh as given at half the speed ("sure"), or also finer and finer ones until the leak settles ("proof"); what they
            said is in json["convergence"]
        :param accuracy_mm2: of the leak: the mesh is refined and tolerances are chosen to reach it; not with certainty
        :param method: closure solver; "thesis": the much slower reference solver ("fast")
        :param membrane: a continuum, which converges under refinement, or the springs of the thesis ("continuum")
        """
        options = given(
            material=given(pressure_mmhg=pressure_mmhg) | dict(tissue or {}) or None,
            certainty=None if certainty == "quick" else certainty,
            accuracy_mm2=accuracy_mm2,
            method=method,
            membrane=membrane,
        )
        return self._closure(self._read(valve), None if plan is None else plan_document(plan), options)

    def close_many(
        self,
        valves: Valve | Iterable[Valve],
        plans: PlanSource | Iterable[PlanSource] | None = None,
        *,
        threads: int | None = None,
    ) -> list[SweepItem]:
        """All of map(), at once: every valve with every plan.

        >>> [item.trusted for item in client.close_many("human-normal", [Plan(), plan])]
        [True, True]
        """
        return list(self.map(valves, plans, threads=threads))

    def open(
        self,
        valve: Valve,
        plan: PlanSource | None = None,
        *,
        pressure_mmhg: float | None = None,
        flow_ml_s: float | None = None,
        exercise: float | None = None,
        frames: int = 0,
    ) -> Opening:
        """Opens a valve in diastole, optionally repaired by a plan, and measures its opening. Check Opening.trusted.

        >>> client.open("human-functional-mr", plan, flow_ml_s=155).gradient_mmhg < 10
        True

        :param pressure_mmhg: peak atrioventricular pressure difference during filling, 1 to 30 (the pressure that drives the flow)
        :param flow_ml_s: mean filling flow at rest, 10 to 1,000 (155, less for a small annulus)
        :param exercise: ratio of exercise flow to resting flow, 1 to 5 (1.4)
        :param frames: number of states between unstressed and open in Opening.scene, 0 to 60
        """
        options = given(pressure_mmhg=pressure_mmhg, flow_ml_s=flow_ml_s, exercise=exercise)
        return Opening.from_json(self._ask("/v1/openings", valve, repair_of(plan, frames=frames, **options)).json())

    def diagnose(self, valve: Valve, plan: PlanSource | None = None) -> dict[str, Any]:
        """Why a valve, optionally repaired by a plan, leaks (coapt.diagnosis/1): "competent", Carpentier "type", "segments" with a
        "finding" each, and a "sentence".

        >>> diagnosis = client.diagnose("human-p2-prolapse")
        >>> diagnosis["type"], [segment["name"] for segment in diagnosis["segments"] if segment["finding"] == "flail"]
        ('II', ['P2'])
        """
        diagnosis: dict[str, Any] = self._ask("/v1/diagnoses", valve, repair_of(plan)).json()
        return diagnosis

    def physiology(
        self,
        valve: Valve,
        plan: PlanSource | None = None,
        *,
        kind: Literal["healthy", "functional", "prolapse"] | None = None,
        species: Literal["human", "porcine"] | None = None,
    ) -> dict[str, Any]:
        """Comparison of a valve, optionally repaired by a plan, with published measurements (coapt.physiology/1): "rows", each with
        "quantity", "what", "value", "unit", the range from "low" to "high", its "source", and a "verdict". Seconds.

        >>> rows = client.physiology("human-normal", kind="healthy")["rows"]
        >>> rows[0]["quantity"], rows[0]["unit"], rows[0]["verdict"] in ("met", "below", "above", "unknown", "no range")
        ('leak', 'mm2', True)

        :param kind: kind of valve whose ranges apply (inferred from the closed valve)
        :param species: species whose ranges apply (porcine if the name of the valve says so, else human)
        """
        request = repair_of(plan, **given(kind=kind, species=species))
        physiology: dict[str, Any] = self._ask("/v1/physiology", valve, request).json()
        return physiology

    def information(
        self, valve: Valve, plan: PlanSource | None = None, *, draws: int | None = None, seed: int | None = None
    ) -> dict[str, Any]:
        """Measurements ranked by how much they would reduce the tissue error of the leak (coapt.information/1): "leak" with its error,
        and "rows" of "measurement", "share_removed" and "remaining_mm2", most informative first. Takes seconds.

        >>> rows = client.information("human-functional-mr", draws=8)["rows"]
        >>> len(rows), sorted(rows[0])
        (8, ['measurement', 'remaining_mm2', 'share_removed'])

        :param draws: number of variants of tissue and chordae (256)
        :param seed: of the draws (1)
        """
        information: dict[str, Any] = self._ask(
            "/v1/information", valve, repair_of(plan, **given(draws=draws, seed=seed))
        ).json()
        return information

    def observe(
        self,
        valve: Valve,
        observed: Mapping[str, Mapping[str, Any]] | None = None,
        *,
        effective_leak: Mapping[str, Any] | None = None,
        forget: bool = False,
    ) -> dict[str, Any]:
        """The valve (coapt.valve/1) with observations from images, which weight later results.

        >>> seen = client.observe("human-functional-mr", {"leak_mm2": {"value": 50, "sd": 10, "source": "3D planimetry"}})
        >>> seen["observed"]["leak_mm2"]["sd"]
        10.0
        >>> client.observe("human-functional-mr", effective_leak={"value": 24, "sd": 5})["observed"]["leak_mm2"]["value"]
        30.0

        :param observed: "leak_mm2", "tenting_area_mm2", "widest_gap_mm": each a "value", its standard deviation "sd", a "source"
        :param effective_leak: instead of "leak_mm2" an effective area, "value" and "sd", with its "discharge" (0.8) and
            "discharge_sd" (0.06): stored as the anatomic area
        :param forget: remove earlier observations
        """
        request = {**given(observed=observed, effective_leak=effective_leak), "forget": forget}
        seen: dict[str, Any] = self._ask("/v1/valves:observe", valve, request).json()
        return seen

    def compare(
        self, closed: ShapeSource, reference: ShapeSource, *, align: Literal["auto", "none", "rigid"] = "auto"
    ) -> Comparison:
        """Measures the distance from a closed shape to a reference.

        >>> client.compare(client.close("human-normal"), client.close("human-normal")).rms_mm
        0.0

        :param align: "rigid": by iterative closest point; "auto": only if the shapes do not share their nodes
        :raises NoSuchFile, BadDocument, InvalidRequest: of what is no shape
        """
        shapes = {"closed": shape_document(closed), "reference": shape_document(reference)}
        return Comparison.from_json(self._post("/v1/comparisons", {**shapes, "align": align, "nodes": True}))

    def map(
        self,
        valves: Valve | Iterable[Valve],
        plans: PlanSource | Iterable[PlanSource] | None = None,
        *,
        threads: int | None = None,
    ) -> Sweep:
        """Closes every valve with every plan, several at once, and yields the closures in order: all plans of the first valve,
        then all of the second. An error of one (no such file, an impossible plan) stands in its place, and the others go on.

        >>> for item in client.map(["human-normal", "porcine-1"], "examples/plans/ring.json"):
        ...     print(item.valve, item.plan, item.trusted)
        human-normal ring True
        porcine-1 ring True
        >>> len(client.map(["human-normal"], [Plan(), "examples/plans/ring.json"]).to_frame())
        2

        A valve is read when its turn comes, so there may be any number of them; at most two closures a thread are ahead of
        what was taken. Leaving the loop ends it.

        :param plans: read at once; None: the valves as they are
        :param threads: closures asked for at once; by default and with 0 as many as this machine has cores, 32 at most. More than
            the service's cores gain nothing
        :raises InvalidRequest: threads is no integer from 0 to 1,024
        """
        at_once = self._at_once(None if threads is None else checked_threads(threads))
        named = [("no repair", None)] if plans is None else all_named_plans(plans)
        return Sweep(self._closure, every_valve(valves), named, at_once, self._read)

    def export(
        self,
        valve: Valve,
        format: FileFormat,
        plan: PlanSource | None = None,
        *,
        open: bool = False,
    ) -> bytes:
        """The closed valve, optionally repaired by a plan, in the file format of another program.

        >>> client.export("human-functional-mr", "glb", plan)[:4]
        b'glTF'

        :param open: export the unstressed shape instead of the closed one; not for csv
        """
        return self._ask("/v1/exports", valve, repair_of(plan, format=format, open=open)).body

    def picture(self, valve: Valve, plan: PlanSource | None = None) -> Picture:
        """Picture of the closed valve, optionally repaired by a plan, from the atrium and in section, with its measurements; a notebook shows it.

        >>> client.picture("human-functional-mr", plan).write("closed.png")
        """
        return Picture(self._ask("/v1/pictures", valve, repair_of(plan)).body)

    def scene(self, valve: Valve, plan: PlanSource | None = None, *, frames: int = 0) -> dict[str, Any]:
        """All data for drawing a closed valve, as lists and numbers (coapt.scene/2): points, triangles, chordae with tension,
        the leak's surface, annulus.

        >>> scene = client.scene("human-functional-mr", plan, frames=3)
        >>> len(scene["motion_mm"]), scene["leak"][0]["area_mm2"] > 0
        (3, True)

        :param frames: number of states between open and closed, 0 to 60
        """
        scene: dict[str, Any] = self._ask("/v1/scenes", valve, repair_of(plan, frames=frames)).json()
        return scene

    def evaluate(
        self,
        valve: Valve,
        plans: PlanSource | Iterable[PlanSource],
        region_points: int | None = None,
        evidence: bool | None = None,
        model_draws: int | None = None,
    ) -> Evaluations:
        """Scores given plans as a search scores its finalists, in the given order.

        >>> scored = client.evaluate("human-functional-mr", [plan, Plan(OwnRing(2))], region_points=3)
        >>> sorted(one.rank for one in scored.plans)
        [1, 2]

        :param region_points: number of nodes of each plan's region of interest to close, 1 to 1,089, 1 by default; plans times nodes must stay
            below the service's limit (1,000 closures)
        :param evidence: also close each plan with errors of single sutures and further remodelling, 88 to 308 more closures; not
            by default
        :param model_draws: number of variants of tissue and chordae in which each plan is closed as planned, 0 to 200, none by default;
            with observations of the valve at least 64, weighted by them
        """
        request = scoring_of(plans, region_points, evidence, model_draws)
        return Evaluations.from_json(self._ask("/v1/evaluations", valve, request).json())

    def report(
        self,
        valve: Valve,
        plans: PlanSource | Iterable[PlanSource],
        region_points: int | None = None,
        evidence: bool | None = None,
        model_draws: int | None = None,
    ) -> str:
        """A report on at most ten given plans, scored as by evaluate(): a self-contained HTML page.

        >>> "ring" in client.report("human-functional-mr", [plan])
        True
        """
        return self._ask("/v1/reports", valve, scoring_of(plans, region_points, evidence, model_draws)).body.decode()

    def _at_once(self, threads: int | None) -> int:
        """Closures of a sweep."""
        return min(threads or os.cpu_count() or 1, MOST_THREADS)

    def _read(self, valve: Valve) -> Any:
        """What _closure() takes of a valve."""
        return valve_document(valve)

    def _closure(self, source: Any, plan: Any, options: Mapping[str, Any] = {}) -> Closure:
        """:param options: of `POST /v1/closures`"""
        repair = given(plan=plan, material=options.get("material"))
        closure = self._ask("/v1/closures", source, {**repair, **options}).json()
        # What is drawn and exported is the closure of the mesh as given.
        as_given = set(options) <= {"material"}
        return Closure.from_json(closure, ServiceLeaflets(self._ask, source, repair) if as_given else None)
