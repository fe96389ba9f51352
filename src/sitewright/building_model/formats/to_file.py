"""From the building model to the keys of `building.json`, in their fixed order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from typing import Any

from sitewright.building_model.component import (
    AsBuilt,
    BoxGeometry,
    Component,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    Geometry,
    MeshGeometry,
    Operation,
    Origin,
    Source,
)
from sitewright.building_model.formats.native_file import SCHEMA
from sitewright.building_model.model import BuildingModel, Relation, Stack
from sitewright.foundation.pose import Pose

_DECIMALS = 7
"""Lengths are written to 1e-7 m."""
_QUATERNION_DECIMALS = 9

Document = dict[str, Any]


def document_of(model: BuildingModel) -> Document:
    """Return the document of a model; keys at their default are left out."""
    return {
        "schema": SCHEMA,
        **_kept(
            name=model.name,
            sources=[_source(s) for s in model.sources],
            origin_shift_m=_plain(model.origin_shift_m) if any(model.origin_shift_m) else None,
            raw=_sorted(model.raw),
        ),
        "build": {
            "gravity": _plain(model.gravity),
            "ground_z_m": _plain(model.ground_z_m),
            **_kept(
                site_T_model=None if model.site_T_model == Pose() else _pose(model.site_T_model)
            ),
        },
        **_kept(
            materials=_sorted(model.materials),
            component_types=_sorted(model.component_types),
        ),
        "components": [
            _component(c) for c in sorted(model.component_by_id.values(), key=lambda c: c.id)
        ],
        **_kept(
            relations=[_relation(r) for r in model.relations],
            stacks=[_stack(s) for s in sorted(model.stacks, key=lambda s: s.id)],
            rules=[_plain(r) for r in model.rules],
        ),
    }


def _component(c: Component) -> Document:
    return {
        "id": c.id,
        **_kept(name=c.name),
        "layer": c.layer.value,
        "type": c.type,
        **_kept(
            material=c.material,
            group=c.group,
            order=c.order,
            construction_parents=list(c.construction_parents),
            ground=c.ground,
            temporary_support=c.temporary_support,
        ),
        "geometry": _geometry(c.geometry),
        **_kept(
            cuts=[
                {"plane": {"point_m": _plain(p.point_m), "normal": _plain(p.normal)}}
                for p in c.cuts
            ]
        ),
        "world_T_component": _pose(c.world_T_component),
        **_kept(
            mass_kg=_plain(c.mass_kg),
            density_kg_m3=_plain(c.density_kg_m3),
            com_m=_plain(c.com_m),
            hold_until_fasteners=c.hold_until_fasteners or None,
            operations=[_operation(o) for o in c.operations],
            grasps=[_pose(g) for g in c.grasps],
            source=None if c.source is None else _source(c.source),
            raw=_sorted(c.raw),
            ext=_sorted(c.ext),
            origins={
                name: {"origin": origin.value, **_kept(evidence=evidence)}
                for name, (origin, evidence) in sorted(c.origins.items())
            },
            as_built=None if c.as_built is None else _as_built(c.as_built),
        ),
    }


def _geometry(geometry: Geometry) -> Document:
    match geometry:
        case BoxGeometry(size_m=size):
            return {"box": {"size_m": _plain(size)}}
        case ExtrusionGeometry(profile_m=profile, depth_m=depth, holes_m=holes):
            extrusion = {"profile_m": _plain(profile), "depth_m": _plain(depth)}
            return {"extrusion": {**extrusion, **_kept(holes_m=_plain(holes))}}
        case ConvexGeometry(points_m=points):
            return {"convex": {"points_m": _plain(points)}}
        case MeshGeometry(uri=uri, sha256=sha256):
            return {"mesh": {"uri": uri, "sha256": sha256}}
        case CompoundGeometry(parts=parts):
            placed = [{**_geometry(g), "component_T_part": _pose(pose)} for pose, g in parts]
            return {"compound": {"parts": placed}}


def _operation(o: Operation) -> Document:
    fastener, patch = o.fastener, o.patch
    return {
        "id": o.id,
        "process": o.process.value,
        "on": list(o.on),
        "component_T_operation": _pose(o.component_T_operation),
        **_kept(
            method=o.method,
            fastener=None
            if fastener is None
            else {
                "type": fastener.type,
                "d_m": _plain(fastener.d_m),
                "l_m": _plain(fastener.l_m),
            },
            patch=None
            if patch is None
            else {
                "size_m": _plain(patch.size_m),
                "standoff_m": _plain(patch.standoff_m),
                "width_m": _plain(patch.width_m),
                "speed_m_s": _plain(patch.speed_m_s),
            },
            after=list(o.after),
            needs_hold=o.needs_hold,
            params=_sorted(o.params),
            origin=_origin(o.origin),
        ),
    }


def _relation(r: Relation) -> Document:
    return {
        "kind": r.kind.value,
        "a": r.a,
        "b": r.b,
        **_kept(
            origin=_origin(r.origin),
            confidence=_plain(r.confidence) if r.confidence != 1.0 else None,
            data=_sorted(r.data),
        ),
    }


def _stack(s: Stack) -> Document:
    return {
        "id": s.id,
        "place": s.place,
        **_kept(
            stock_T_stack=_pose(s.stock_T_stack) if s.stock_T_stack != Pose() else None,
            spacer_m=_plain(s.spacer_m) if s.spacer_m else None,
        ),
        "items": list(s.items),
    }


def _as_built(a: AsBuilt) -> Document:
    measured = a.world_T_component_measured
    return {
        "status": a.status,
        **_kept(
            material_used=a.material_used,
            installed_at=a.installed_at,
            robot=a.robot,
            world_T_component_measured=None if measured is None else _pose(measured),
            operations=_sorted(a.operations),
        ),
    }


def _source(s: Source) -> Document:
    kept = _kept(
        id=s.id, sha256=s.sha256, import_sha256=s.import_sha256, options=_sorted(s.options)
    )
    return {"file": s.file, "kind": s.kind, **kept}


def _pose(pose: Pose) -> Document:
    return {
        "p_m": _plain(pose.position_m),
        "q_wxyz": [_rounded(x, _QUATERNION_DECIMALS) for x in pose.quaternion_wxyz],
    }


def _origin(origin: Origin) -> str | None:
    return None if origin is Origin.GIVEN else origin.value


def _kept(**values: object) -> Document:
    """Return the entries that say something: no None, False, empty text or empty list."""
    return {k: v for k, v in values.items() if v is not None and v is not False and v not in _EMPTY}


_EMPTY: tuple[object, ...] = ("", [], {})


def _sorted(values: Mapping[Any, object]) -> Document:
    return {str(k): _plain(values[k]) for k in sorted(values)}


def _plain(value: object) -> Any:  # noqa: ANN401 - any JSON value
    match value:
        case Enum():
            return value.value
        case float():
            return _rounded(value, _DECIMALS)
        case Mapping():
            return {str(k): _plain(v) for k, v in value.items()}
        case str():
            return value
        case Sequence():
            return [_plain(v) for v in value]
        case _:
            return value


def _rounded(value: float, decimals: int) -> float:
    return round(value, decimals) + 0.0
