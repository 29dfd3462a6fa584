"""Valves and plans that are kept by what answers."""

from __future__ import annotations

import urllib.parse
from collections.abc import Iterable, Iterator
from typing import Any

from .asking import given
from .closures import known_fields
from .errors import NotFound, Problem
from .files import Path
from .imports import OF_SLICERHEART, files_to_import, packed_files, packed_folder
from .short_work import ShortWork, repair_of
from .sources import PlanSource, Valve, valve_document
from .stored import ImportDecision, KeptPlan, RingShape, StoredValve


def path_of(folder: str, name: str) -> str:
    return f"{folder}/{urllib.parse.quote(name, safe='')}"


class StoredWork(ShortWork):
    """Valves and plans that are kept, and the rings there are."""

    def rings(self) -> list[RingShape]:
        """Shapes that Ring() may name.

        >>> "generic-classic" in [ring.name for ring in client.rings()]
        True
        """
        return [RingShape(**known_fields(RingShape, ring)) for ring in self._get("/v1/rings")["rings"]]

    def put_valve(self, valve: Valve) -> StoredValve:
        """Stores a valve; the same valve has the same id.

        >>> client.put_valve(valve.to_json()).triangles
        648
        """
        document = valve_document(valve)
        stored = self._post("/v1/valves", document)
        return StoredValve(stored["id"], document["name"], stored["vertices"], stored["triangles"], stored["chordae"])

    def import_valve(
        self,
        leaflets: Iterable[Path | Any] | Path,
        annulus: Path | Any | None,
        chordae: Path | int,
        *,
        tips: Path | Any | None = None,
        name: str = "imported",
        **options: Any,
    ) -> StoredValve:
        """Makes a valve from the files of a segmentation tool, in one unit, and stores it.

        >>> folder = "examples/valves/source/bodyparts3d"
        >>> leaflets = [coapt.Mesh.read(f"{folder}/{name}_leaflet_sheet.obj") for name in ("anterior", "posterior")]
        >>> imported = client.import_valve(leaflets, f"{folder}/annulus_centerline.csv", f"{folder}/chordae.csv")
        >>> client.close(imported).trusted
        True

        :param leaflets: OBJ, PLY, STL or VTK: the anterior, then the posterior leaflet, or one file with both as its parts, or one
            skirt; or the path of a label map of both (NRRD or NIfTI). Also what is in memory: pairs of points and faces, meshes of
            meshio, PyVista, VTK, trimesh
        :param annulus: a table of x, y, z, or a closed curve of Slicer (.mrk.json), or points or a line in memory; None: that of the
            label map, else found at the leaflets
        :param chordae: CSV or JSON; or a seed, to synthesise chordae from anatomical data
        :param tips: imaged papillary tips for synthesised chordae: CSV of papillary,x,y,z or labelled Slicer points, or a mapping of
            "AL" and "PM" to a point; by default tips are synthesised as well
        :param options: provenance (sentences), triangles, branches, branch_at, slack, reference, thickness_mm (of the tissue),
            thickness_measured (True: that of thick leaflets), landmarks (a mapping of "saddle_peak", "mid_posterior",
            "anterolateral_commissure" and "posteromedial_commissure" to a point), observed (of the closed valve), phase, units ("mm",
            "cm", "in" or "m"; left out, they are guessed from the annulus), closed (True or False: the leaflets were imaged
            closed or open; left out, that is guessed), hidden_mm (of closed leaflets, what coaptation hides), label_numbers
            (of a label map or of parts of one file: a mapping of "anterior", "posterior" and "annulus" to a number or several),
            trust_labels (True: leaflets are what labels, names and order say, whatever they look like), flip (True: the atrium is on
            the other side than it looks), mirrored (True: the files are a mirror image), frame ("LPS" or "RAS")
        :raises Refused: what is wrong with which file
        """
        return self._imported(files_to_import(leaflets, annulus, chordae, tips), name, options)

    def import_files(
        self, files: Iterable[Path | Any] | Path, *, name: str = "imported", **options: Any
    ) -> StoredValve:
        """The same of files whose parts are detected from name and content, as `coapt valve import FILE...` does; chordae that they lack
        are synthesised.

        >>> folder = "examples/valves/source/bodyparts3d"
        >>> leaflets = [f"{folder}/{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
        >>> imported = client.import_files([*leaflets, f"{folder}/annulus_centerline.csv"])
        >>> imported.decisions[0].value
        'file 1 of 3 (.obj) is the anterior leaflet'

        :param files: in any order: a label map (and its voxel file), meshes, tables, markups, what is in memory; or a folder of these
        :param options: as import_valve(), and chordae_seed, grid (of the images of a label map: {"size": [i, j, k], "to_lps_mm":
            three rows of four})
        :raises Refused: what is wrong with which file
        """
        return self._imported({"files": packed_files(files)}, name, options)

    def import_slicerheart(self, folder: Path, *, name: str = "imported", **options: Any) -> StoredValve:
        """The same of a folder that SlicerHeart's ValveFemExport or `coapt export` wrote.

        >>> client.import_slicerheart("exported", triangles=300).triangles < 400
        True
        """
        return self._imported({"slicerheart": packed_folder(folder, OF_SLICERHEART)}, name, options)

    def _imported(self, files: dict[str, Any], name: str, options: dict[str, Any]) -> StoredValve:
        stored = self._post("/v1/valves:import", files | options | {"name": name})
        decisions = tuple(ImportDecision(**decision) for decision in stored["decisions"])
        return StoredValve(stored["id"], name, stored["vertices"], stored["triangles"], stored["chordae"], decisions)

    def valves(self) -> Iterator[StoredValve]:
        """Stored valves, newest first: those of put_valve() and those that jobs were asked for with.

        >>> kept = client.put_valve(valve.to_json())
        >>> kept.id in [one.id for one in client.valves()]
        True
        """
        for one in self._listed("/v1/valves", "valves"):
            yield StoredValve(one["valve"], one["name"], one["vertices"], one["triangles"])

    def get_valve(self, name: str) -> dict[str, Any]:
        """The coapt.valve/1 of a preset or a stored valve: millimetres; x posteromedial, y anterior, z to the atrium.

        >>> client.get_valve("human-normal")["schema"]
        'coapt.valve/1'
        """
        try:
            valve: dict[str, Any] = self._get(path_of("/v1/valves", name))
        except NotFound as error:
            raise self._with_preset(error, name) from None
        return valve

    def delete_valve(self, id: str) -> None:
        """
        >>> kept = client.put_valve(valve.replace(name="for a while"))
        >>> client.delete_valve(kept.id)

        :raises Conflict: jobs or kept plans refer to it; delete these first
        """
        self._transport.request("DELETE", path_of("/v1/valves", id))

    def validate_valve(self, valve: Valve) -> tuple[Problem, ...]:
        """Every problem of a valve document; empty if there is none. Nothing is stored.

        >>> client.validate_valve(valve), client.validate_valve(valve.to_json() | {"faces": []})[0].path
        ((), '/faces')
        """
        return tuple(map(Problem.from_json, self._post("/v1/valves:validate", valve_document(valve))["problems"]))

    def keep_plan(self, valve: Valve, plan: PlanSource, name: str) -> KeptPlan:
        """Keeps a plan that is possible on the valve, which is stored if it is a document; the page lists it, too.

        >>> client.keep_plan("human-functional-mr", plan, "ring of 36 mm").name
        'ring of 36 mm'

        :param name: one line, at most 200 bytes
        :raises Conflict: there are as many as the service keeps
        """
        source = valve_document(valve)
        of = source if isinstance(source, str) else self.put_valve(source).id
        return KeptPlan.from_json(self._ask("/v1/kept-plans", of, repair_of(plan, name=name)).json())

    def kept_plans(self, valve: str | StoredValve | None = None) -> Iterator[KeptPlan]:
        """Kept plans, newest first; only those of a valve, by the id or preset's name that they were kept for.

        >>> kept = client.keep_plan("human-functional-mr", plan, "ring of 36 mm")
        >>> kept in client.kept_plans("human-functional-mr")
        True
        """
        query = given(valve=None if valve is None else valve_document(valve))
        yield from map(KeptPlan.from_json, self._listed("/v1/kept-plans", "kept_plans", query))

    def rename_kept_plan(self, id: str, name: str) -> KeptPlan:
        """
        >>> kept = client.keep_plan("human-functional-mr", plan, "ring of 36 mm")
        >>> client.rename_kept_plan(kept.id, "ring").name
        'ring'

        :raises NotFound: there is none of this id
        """
        answer = self._transport.request("PATCH", path_of("/v1/kept-plans", id), {"name": name})
        return KeptPlan.from_json(answer.json())

    def delete_kept_plan(self, id: str) -> None:
        """
        >>> kept = client.keep_plan("human-functional-mr", plan, "ring of 36 mm")
        >>> client.delete_kept_plan(kept.id)

        :raises NotFound: there is none of this id
        """
        self._transport.request("DELETE", path_of("/v1/kept-plans", id))
