"""The symbolic state of robots and stock, from what was sensed and what was done last."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.construction_graph.graph import NOWHERE, ConstructionGraph, MaterialNode
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.jobsite import ArmState, Jobsite
from sitewright.robot_team.waiting import is_at_home
from sitewright.symbolic_planning.site_index import preparation_place
from sitewright.symbolic_planning.site_view import PlaceId, RobotStatus

_AT_HOME_RAD = 0.02


def robot_statuses(
    design: Design, context: SiteContext, site: Jobsite
) -> dict[RobotId, RobotStatus]:
    """Return the symbolic state of each robot from what was sensed and last done."""
    targets = {p.piece: t for t, p in context.site.placed.items()}
    statuses: dict[RobotId, RobotStatus] = {}
    for robot, arm in site.arms.items():
        steadying = None if arm.held is None else targets.get(arm.held)
        statuses[robot] = RobotStatus(
            place=_place(design, context, robot, arm),
            mounted=arm.mounted,
            holding=arm.held if steadying is None else None,
            steadying=steadying,
        )
    return statuses


def _place(design: Design, context: SiteContext, robot: RobotId, arm: ArmState) -> PlaceId | None:
    """Return where a robot is: what its last motion says, else its station if it is at home."""
    if robot in context.site.place_by_robot:
        return context.site.place_by_robot[robot]
    unit = design.cell.robot_by_id[robot]
    is_home = is_at_home(unit, arm.q_rad, within_rad=_AT_HOME_RAD)
    return preparation_place(design.cell, robot) if is_home else None


def lies_at(
    graph: ConstructionGraph, context: SiteContext, pieces: Iterable[ComponentId]
) -> dict[ComponentId, PlaceId]:
    """Return the stock place or buffer of each piece, or the name of where it fell.

    A piece in a gripper lies nowhere, nor one that is not seen.
    """
    held = {robot.gripped for robot in context.observation.robots.values()}
    lying = (p for p in pieces if p not in held and p in context.observation.world_T_piece)
    nodes = ((p, graph.node_by_id.get(p)) for p in lying)
    return {p: n.place or where_it_fell(p) for p, n in nodes if isinstance(n, MaterialNode)}


def where_it_fell(piece: ComponentId) -> PlaceId:
    """Return the name of the place of a piece that lies at no stock place."""
    return f"where-{piece}-lies"


def strays(graph: ConstructionGraph, context: SiteContext) -> frozenset[ComponentId]:
    """Return the pieces of stock that lie at no stock place and are in no gripper."""
    held = {robot.gripped for robot in context.observation.robots.values()}
    return frozenset(
        node.id
        for node in graph.node_by_id.values()
        if isinstance(node, MaterialNode) and node.place == NOWHERE and node.id not in held
    )
