"""From the keys of `building.json` to the building model."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace

from sitewright.building_model.component import (
    AsBuilt,
    BoxGeometry,
    Component,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    FastenerSpec,
    Geometry,
    Layer,
    MeshGeometry,
    Operation,
    PlaneCut,
    Source,
    SurfacePatch,
)
from sitewright.building_model.formats.native_file import (
    AsBuiltFile,
    BuildingFile,
    ComponentFile,
    GeometryFile,
    OperationFile,
    PartFile,
    PoseFile,
    SolidFile,
    SourceFile,
    StackFile,
)
from sitewright.building_model.model import BuildingModel, Relation, Stack
from sitewright.building_model.piling import generated_pieces, piled
from sitewright.foundation.ids import ComponentId, OperationId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose

_EXACT = 2e-9
"""A quaternion this near to length one is kept to the bit, so that files do not drift."""


def model_from(file: BuildingFile) -> BuildingModel:
    """Return the model of a validated file; every id must be unique."""
    components = {ComponentId(c.id): _component(c) for c in file.components}
    unplaced = {c.id for c in file.components if c.world_T_component is None}
    stacks = []
    for stack_file in file.stacks:
        stack, pieces = _stack(stack_file, components)
        stacks.append(stack)
        for piece in piled(stack, pieces):
            if piece.id in unplaced or stack_file.generated:
                components[piece.id] = piece
    return BuildingModel(
        name=file.name,
        component_by_id={i: components[i] for i in sorted(components)},
        relations=tuple(
            Relation(
                kind=r.kind,
                a=ComponentId(r.a),
                b=ComponentId(r.b),
                origin=r.origin,
                confidence=r.confidence,
                data=r.data,
            )
            for r in file.relations
        ),
        stacks=tuple(sorted(stacks, key=lambda s: s.id)),
        sources=tuple(_source(s) for s in file.sources),
        materials={
            name: material.model_dump(exclude_defaults=True)
            for name, material in sorted(file.materials.items())
        },
        component_types=dict(sorted(file.component_types.items())),
        rules=tuple(file.rules),
        origin_shift_m=file.origin_shift_m,
        raw=file.raw,
        gravity=file.build.gravity,
        ground_z_m=file.build.ground_z_m,
        site_T_model=pose_from(file.build.site_T_model),
    )


def pose_from(file: PoseFile | None) -> Pose:
    """Return the pose with a unit quaternion and w >= 0; None is the identity."""
    if file is None:
        return Pose()
    length = math.hypot(*file.q_wxyz)
    by = 1.0 if abs(length - 1.0) <= _EXACT else length
    sign = -1.0 if file.q_wxyz[0] < 0.0 else 1.0
    w, x, y, z = (sign * part / by for part in file.q_wxyz)
    return Pose(file.p_m, (w, x, y, z))


def _stack(
    file: StackFile, components: Mapping[ComponentId, Component]
) -> tuple[Stack, list[Component]]:
    stack = Stack(
        id=StackId(file.id),
        place=StockPlaceId(file.place),
        items=_ids(file.items or ()),
        stock_T_stack=pose_from(file.stock_T_stack),
        spacer_m=file.spacer_m,
    )
    if file.generated is None:
        known = [components[i] for i in stack.items if i in components]
        return stack, known
    made = file.generated
    pieces = generated_pieces(
        stack.id,
        Component(
            id=ComponentId(file.id),
            layer=Layer.MATERIAL,
            type=made.type,
            material=made.material,
            geometry=BoxGeometry((made.length_m, *made.section_m)),
        ),
        made.count,
    )
    return replace(stack, items=tuple(p.id for p in pieces)), pieces


def _component(file: ComponentFile) -> Component:
    return Component(
        id=ComponentId(file.id),
        layer=file.layer,
        type=file.type,
        geometry=_geometry(file.geometry),
        world_T_component=pose_from(file.world_T_component),
        name=file.name,
        material=file.material,
        group=file.group,
        order=file.order,
        construction_parents=_ids(file.construction_parents),
        ground=file.ground,
        temporary_support=file.temporary_support,
        cuts=tuple(PlaneCut(c.plane.point_m, c.plane.normal) for c in file.cuts),
        mass_kg=file.mass_kg,
        density_kg_m3=file.density_kg_m3,
        com_m=file.com_m,
        hold_until_fasteners=file.hold_until_fasteners,
        operations=tuple(operation_from(o, file.id) for o in file.operations),
        grasps=tuple(pose_from(g) for g in file.grasps),
        source=None if file.source is None else _source(file.source),
        raw=file.raw,
        ext=file.ext,
        origins={k: (e.origin, e.evidence) for k, e in sorted(file.origins.items())},
        as_built=None if file.as_built is None else _as_built(file.as_built),
    )


def _geometry(file: GeometryFile) -> Geometry:
    if file.compound is None:
        return _solid(file)
    return CompoundGeometry(tuple(_part(p) for p in file.compound.parts))


def _part(
    file: PartFile,
) -> tuple[Pose, BoxGeometry | ExtrusionGeometry | ConvexGeometry | MeshGeometry]:
    return pose_from(file.component_T_part), _solid(file)


def _solid(file: SolidFile) -> BoxGeometry | ExtrusionGeometry | ConvexGeometry | MeshGeometry:
    if file.box is not None:
        return BoxGeometry(file.box.size_m)
    if file.extrusion is not None:
        made = file.extrusion
        holes = tuple(tuple(hole) for hole in made.holes_m)
        return ExtrusionGeometry(tuple(made.profile_m), made.depth_m, holes)
    if file.convex is not None:
        return ConvexGeometry(tuple(file.convex.points_m))
    if file.mesh is not None:
        return MeshGeometry(file.mesh.uri, file.mesh.sha256)
    raise AssertionError("the file model lets exactly one kind of geometry pass")


def operation_from(file: OperationFile, component: str) -> Operation:
    """Return an operation; without `on` it is of the component alone."""
    made, patch = file.fastener, file.patch
    return Operation(
        id=OperationId(file.id),
        process=file.process,
        on=_ids(file.on or (component,)),
        component_T_operation=pose_from(file.component_T_operation),
        method=file.method,
        fastener=None if made is None else FastenerSpec(type=made.type, d_m=made.d_m, l_m=made.l_m),
        after=tuple(OperationId(i) for i in file.after),
        needs_hold=file.needs_hold,
        patch=None
        if patch is None
        else SurfacePatch(
            size_m=patch.size_m,
            standoff_m=patch.standoff_m,
            width_m=patch.width_m,
            speed_m_s=patch.speed_m_s,
        ),
        params=file.params,
        origin=file.origin,
    )


def _as_built(file: AsBuiltFile) -> AsBuilt:
    measured = file.world_T_component_measured
    return AsBuilt(
        status=file.status,
        material_used=None if file.material_used is None else ComponentId(file.material_used),
        installed_at=file.installed_at,
        robot=file.robot,
        world_T_component_measured=None if measured is None else pose_from(measured),
        operations={OperationId(k): v for k, v in sorted(file.operations.items())},
    )


def _source(file: SourceFile) -> Source:
    return Source(
        file=file.file,
        kind=file.kind,
        id=file.id,
        sha256=file.sha256,
        import_sha256=file.import_sha256,
        options=file.options,
    )


def _ids(names: Iterable[str]) -> tuple[ComponentId, ...]:
    return tuple(ComponentId(name) for name in names)
