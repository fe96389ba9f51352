"""Makes the reach check's question of a project: what stands when, and what each target needs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from sitewright.app.planning import start_of
from sitewright.app.project import Project
from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import mass_of, shape_of, size_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.site_state import PlacedPiece
from sitewright.central_controller.situation import task_of
from sitewright.construction_graph.build import graph_of
from sitewright.construction_graph.graph import ConstructionGraph, MaterialNode
from sitewright.construction_graph.supply import Supplied, supplied_in_order
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.jobsite import PieceShape, end_effector_bodies, world_T_dock
from sitewright.planning_twin.reachability.question import (
    FOREVER,
    ReachQuestion,
    ReachTarget,
    TimedBody,
)
from sitewright.robot_team.cell import Capability, Cell

_NOBODY = RobotId("")


def reach_question(project: Project) -> ReachQuestion:
    """Return everything that the reach check looks at, on the site as designed."""
    model, cell = project.model, project.cell
    graph = graph_of(model, cell)
    hands = (r for r in cell.robot_by_id.values() if Capability.GRASPING in r.can)
    supply = supplied_in_order(graph, (r.world_T_base.position_m for r in hands))
    design = Design(model=model, cell=cell)
    finished = _finished(design, start_of(project))
    lying = {i: n.world_T_component for i, n in graph.node_by_id.items()}
    targets = tuple(
        _target(design, graph, finished, lying, number, supplied)
        for number, supplied in enumerate(supply)
    )
    bodies = (*cell_bodies(cell), *_model_bodies(model, cell, targets, lying))
    return ReachQuestion(cell=cell, bodies=bodies, targets=targets)


def cell_bodies(cell: Cell) -> Iterator[TimedBody]:
    """Yield fixtures, zones, and end effectors in their docks."""
    for fixture in cell.fixture_by_id.values():
        yield TimedBody(
            id=BodyId(fixture.id), shape=fixture.shape, world_T_body=fixture.world_T_fixture
        )
    for zone in cell.zone_by_id.values():
        yield TimedBody(id=BodyId(zone.id), shape=zone.shape, world_T_body=zone.world_T_zone)
    for tool in cell.end_effector_by_id.values():
        if tool.station is not None:
            for body in end_effector_bodies(tool, world_T_dock(cell, tool), 0.0):
                if isinstance(body.placement, Pose):
                    at = body.placement
                    yield TimedBody(id=body.id, shape=body.shape, world_T_body=at, docked=tool.id)


def _finished(design: Design, start: SiteContext) -> SiteContext:
    """Return the site as if every target stood where it belongs, under its own name."""
    placed = {
        target: PlacedPiece(
            piece=target,
            world_T_wanted=pose,
            world_T_measured=pose,
            robot=_NOBODY,
        )
        for target in start.site.targets
        for pose in (design.world_T_target(target),)
    }
    return replace(start, site=replace(start.site, placed=placed))


def _target(
    design: Design,
    graph: ConstructionGraph,
    finished: SiteContext,
    lying: Mapping[ComponentId, Pose],
    number: int,
    supplied: Supplied,
) -> ReachTarget:
    component = design.component(supplied.target)
    task = task_of(design, graph, finished, supplied.target, supplied.accessible)
    pieces = (*supplied.accessible, *supplied.others)
    return ReachTarget(
        number=number,
        shape=_shape(design.model, component, pieces),
        task=replace(task, placed=None),
        world_T_piece={p: lying[p] for p in pieces},
        waits_for=supplied.waits_for,
        place=_place(graph, supplied),
    )


def _place(graph: ConstructionGraph, supplied: Supplied) -> str:
    nodes = (graph.node_by_id[p] for p in supplied.accessible[:1])
    return next((n.place for n in nodes if isinstance(n, MaterialNode)), "")


def _shape(model: BuildingModel, component: Component, pieces: Iterable[ComponentId]) -> PieceShape:
    """Return the shape of a target with the mass of the lightest piece that may become it.

    A target is too heavy only if every piece is; what is lifted is the piece.
    """
    masses_kg = (mass_of(model.component_by_id[p], model.materials) for p in pieces)
    return PieceShape(
        shape=shape_of(component),
        size_m=size_of(component),
        mass_kg=min(masses_kg, default=mass_of(component, model.materials)),
    )


def _model_bodies(
    model: BuildingModel,
    cell: Cell,
    targets: Iterable[ReachTarget],
    lying: Mapping[ComponentId, Pose],
) -> Iterator[TimedBody]:
    """Yield what stands from the start, the stock until it is used, the targets once built."""
    used_at = {t.task.candidates[0]: t.number for t in targets if t.task.candidates}
    built_at = {t.id: t.number for t in targets}
    for component in model.component_by_id.values():
        match component.layer:
            case Layer.AS_BUILT | Layer.VIRTUAL_COLLISION:
                pose = cell.world_T_model @ component.world_T_component
                yield _body(component, pose)
            case Layer.MATERIAL if component.id in lying:
                gone = used_at.get(component.id, FOREVER - 1) + 1
                yield replace(_body(component, lying[component.id]), vanishes=gone)
            case Layer.TARGET:
                pose = cell.world_T_model @ component.world_T_component
                yield replace(_body(component, pose), appears=built_at[component.id] + 1)
            case _:
                pass


def _body(component: Component, pose: Pose) -> TimedBody:
    return TimedBody(id=BodyId(component.id), shape=shape_of(component), world_T_body=pose)
