"""From the folded site and what was sensed to what the two planners look at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sitewright.building_model.component import Component, Layer, Operation, Process
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import mass_of, shape_of, size_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.errands import buffers
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.touching import body_of, lies_on, rests_on, touches
from sitewright.construction_graph.graph import (
    ConstructionGraph,
    TargetNode,
)
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose, Vector, scale
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import ArmState, Jobsite, PieceShape
from sitewright.planning_twin.motion import ForwardKinematics
from sitewright.planning_twin.task import Insertion, Task
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import RobotObservation

_LEVEL = 0.2
INSERTION = "insertion"
"""Key of `Component.ext` for the way in: ``{"from": [x, y, z], "slide_m": s}``, model frame."""
_TOUCHING_M = 0.002
_LONGEST_SLIDE_M = 0.3
_FASTENING = (Process.NAIL, Process.SCREW, Process.DRILL)


def piece_shapes(model: BuildingModel) -> dict[ComponentId, PieceShape]:
    """Return every piece of stock, and what stands already, as bodies."""
    return {
        c.id: PieceShape(shape=shape_of(c), size_m=size_of(c), mass_kg=mass_of(c, model.materials))
        for c in model.component_by_id.values()
        if c.layer in (Layer.MATERIAL, Layer.AS_BUILT)
    }


def jobsite_of(
    design: Design,
    shapes: Mapping[ComponentId, PieceShape],
    context: SiteContext,
    kinematics: ForwardKinematics,
) -> Jobsite:
    """Return the cell as sensed, for the planning twin."""
    seen = context.observation
    placed = {p.piece for p in context.site.placed.values()}
    arms = {
        robot: _arm(design.cell, robot, state, seen.world_T_piece, kinematics)
        for robot, state in seen.robots.items()
    }
    return Jobsite(
        cell=design.cell,
        pieces=shapes,
        world_T_piece={p: pose for p, pose in seen.world_T_piece.items() if p in shapes},
        arms=arms,
        docked=dict(seen.docked),
        obstacles={
            c.id: (shape_of(c), design.world_T_target(c.id))
            for c in design.model.component_by_id.values()
            if c.layer is Layer.VIRTUAL_COLLISION
        },
        steadied={
            arm.held: robot
            for robot, arm in arms.items()
            if arm.held is not None and arm.held in placed
        },
    )


def _arm(
    cell: Cell,
    robot: RobotId,
    state: RobotObservation,
    world_T_piece: Mapping[ComponentId, Pose],
    kinematics: ForwardKinematics,
) -> ArmState:
    unit = cell.robot_by_id[robot]
    held = state.gripped if state.gripped in world_T_piece else None
    tip = unit.world_T_base @ kinematics.tip(unit.description, state.q_rad)
    return ArmState(
        q_rad=state.q_rad,
        mounted=state.mounted,
        aperture_m=_possible_aperture_m(cell, state),
        held=held,
        tip_T_held=Pose() if held is None else tip.inverse() @ world_T_piece[held],
    )


def _possible_aperture_m(cell: Cell, state: RobotObservation) -> float:
    """Return the sensed aperture within the gripper's range, which sensors may leave a little."""
    tool = None if state.mounted is None else cell.end_effector_by_id[state.mounted]
    return 0.0 if tool is None else min(max(state.aperture_m, 0.0), tool.opens_to_m)


def task_of(
    design: Design,
    graph: ConstructionGraph,
    context: SiteContext,
    target: ComponentId,
    candidates: tuple[ComponentId, ...],
) -> Task:
    """Return what the planning twin has to do for a target.

    Args:
        design: Model and cell.
        graph: Graph as it stands now.
        context: Folded site and observation.
        target: The active target.
        candidates: Pieces that may become it.
    """
    placed = context.site.placed.get(target)
    component = design.component(target)
    world_T_target = design.world_T_target(target)
    if placed is not None:
        world_T_target = context.observation.world_T_piece.get(
            placed.piece, placed.world_T_measured
        )
    done = context.site.done_operations
    driven = sum(o.process in _FASTENING and o.id in done for o in component.operations)
    return Task(
        target=target,
        world_T_target=world_T_target,
        candidates=candidates,
        touches=touches(design, context, component),
        rests_on=rests_on(design, context, component),
        insertions=_insertions(design, component, world_T_target),
        lies_on={c: lies_on(design, graph, context, c) for c in candidates},
        spots=tuple(
            spot_of(context, target, o, world_T_target)
            for o in component.operations
            if o.id not in done and o.process is not Process.PLACE
        ),
        hold_until=max(0, component.hold_until_fasteners - driven),
        buffers=buffers(design.cell),
        placed=None if placed is None else placed.piece,
    )


def spot_of(
    context: SiteContext,
    target: ComponentId,
    operation: Operation,
    world_T_target: Pose,
) -> Spot:
    """Return an operation placed in the world, with the pieces that its components were made of."""
    other = next((c for c in operation.on if c != target), None)
    body = None if other is None else body_of(context, other)
    is_first = other is None or operation.on[0] == target
    return Spot(
        operation=operation.id,
        process=operation.process,
        target=target,
        world_T_operation=world_T_target @ operation.component_T_operation,
        through=None if is_first else body,
        into=body if is_first else None,
        fastener=operation.fastener,
        patch=operation.patch,
        needs_hold=operation.needs_hold,
        after=operation.after,
    )


def _insertions(
    design: Design, component: Component, world_T_target: Pose
) -> tuple[Insertion, ...]:
    """Return the ways in: the stated or inferred one, then from above, then its own sides.

    A stated way only says what is tried first: the proof decides which one is clear.
    """
    first: tuple[Insertion, ...] = ()
    stated = component.ext.get(INSERTION)
    if isinstance(stated, Mapping):
        come_from = design.cell.world_T_model.turn(_vector(stated["from"]))
        first = (Insertion(come_from=come_from, slide_m=float(str(stated["slide_m"]))),)
    axes = (world_T_target.x_axis, world_T_target.y_axis, world_T_target.z_axis)
    depths = zip(axes, size_of(component), strict=True)
    sides = [(scale(axis, sign), depth_m) for axis, depth_m in depths for sign in (1.0, -1.0)]
    level = [(s, depth_m) for s, depth_m in sides if -_LEVEL < s[2] < 1.0 - _LEVEL]
    straight = [Insertion(come_from=s) for s, _ in level]
    sliding = [Insertion(come_from=s, slide_m=d) for s, d in level if d < _LONGEST_SLIDE_M]
    return (*first, Insertion(), *straight, *sliding)


def _vector(value: Json) -> Vector:
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise TypeError(f"{value!r} is no direction")
    x, y, z = (float(str(v)) for v in value)
    return (x, y, z)


def target_node(graph: ConstructionGraph, target: ComponentId) -> TargetNode:
    """Return the node of a target that is not installed yet."""
    node = graph.node_by_id[target]
    if not isinstance(node, TargetNode):
        raise TypeError(f"{target} is {node.layer.value}, not a target")
    return node
