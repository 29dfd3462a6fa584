"""Steps of repair plans from their JSON in coapt.plan/1."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

from .errors import BadDocument
from .files import did_you_mean
from .steps import (
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    DesignedRing,
    EdgeToEdge,
    LeafletPoint,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    QuadrangularResection,
    Ring,
    Step,
    TriangularResection,
)

_KINDS: dict[str, type[Step]] = {
    Ring.step: Ring,
    Neochorda.step: Neochorda,
    ChordalLengthChange.step: ChordalLengthChange,
    ChordalExcision.step: ChordalExcision,
    ChordalTransfer.step: ChordalTransfer,
    PapillaryApproximation.step: PapillaryApproximation,
    EdgeToEdge.step: EdgeToEdge,
    TriangularResection.step: TriangularResection,
}
_SHAPES: dict[str, dict[str, type[Step]]] = {
    Ring.step: {"own": OwnRing, "designed": DesignedRing},
    TriangularResection.step: {"triangular": TriangularResection, "quadrangular": QuadrangularResection},
}


def _made(kind: Any, json: Any) -> Any:
    """A part from its fields. Their values are checked by the service.

    :raises BadDocument: one is unknown or missing
    """
    if not isinstance(json, Mapping):
        raise BadDocument(f"no step of coapt.plan/1: {kind.__name__} cannot be {json!r}")
    needed = {one.name: one.default is dataclasses.MISSING for one in dataclasses.fields(kind)}
    wrong = [f'has no field "{name}"{did_you_mean(name, needed)}' for name in json if name not in needed]
    wrong += [f'needs "{name}"' for name in needed if needed[name] and name not in json]
    if wrong:
        raise BadDocument(f"no step of coapt.plan/1: {kind.__name__} {', '.join(wrong)}")
    return kind(**json)


def step_from_json(json: Mapping[str, Any]) -> Step:
    """:raises BadDocument: it is no step of coapt.plan/1"""
    if not isinstance(json, Mapping):
        raise BadDocument(f"no step of coapt.plan/1: {json!r} is no object")
    fields = {name: value for name, value in json.items() if name != "step"}
    name = json.get("step")
    if not isinstance(name, str) or name not in _KINDS:
        known = ", ".join(_KINDS)
        raise BadDocument(
            f'no step of coapt.plan/1: "step" is {name!r}, must be one of {known}{did_you_mean(str(name), _KINDS)}'
        )
    if "insertion" in fields:
        fields["insertion"] = _made(LeafletPoint, fields["insertion"])
    kind, shape = _KINDS[name], fields.get("shape")
    if isinstance(shape, str) and shape in _SHAPES.get(name, {}):
        kind = _SHAPES[name][fields.pop("shape")]
    elif name == TriangularResection.step:
        raise BadDocument(f'no step of coapt.plan/1: "shape" is {shape!r}, must be triangular or quadrangular')
    step: Step = _made(kind, fields)
    return step
