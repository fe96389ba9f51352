"""Who is in the way where it waits: found before the first plan, not by a plan that is refused."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.approach import (
    Approach,
    Approaches,
    Reaching,
    Touch,
    straight_approach,
)
from sitewright.planning_twin.blockers import things_in_the_way
from sitewright.planning_twin.fastening import tool_poses
from sitewright.planning_twin.grasp_trial import with_held
from sitewright.planning_twin.jobsite import Jobsite, scene_of, with_tool
from sitewright.planning_twin.refusal import BlockedBy
from sitewright.planning_twin.study_facts import HolderOf, tools_at_spots
from sitewright.planning_twin.tacking import Holding
from sitewright.planning_twin.task import TwinContext
from sitewright.planning_twin.touches import place_touch, spot_touch
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.waiting import home_opposite, waiting_q_rad
from sitewright.symbolic_planning.site_index import preparation_place
from sitewright.symbolic_planning.site_view import PlaceId

Excluded = tuple[RobotId, PlaceId, PlaceId]
"""A robot must not go to the first place while somebody is at the second."""


def in_the_way_where_they_wait(context: TwinContext, holdings: HolderOf) -> Iterator[Excluded]:
    """Yield who must leave its preparation station for another robot to place or to fasten.

    Args:
        context: Engines, site and task.
        holdings: Grasps that were found.
    """
    waiting = _waiting(context)
    for holding in holdings.values():
        for other in _against_placing(context, waiting, holding):
            yield from _both_ways(context, holding.robot, context.task.target, other)
    piece = next((h.piece for h in holdings.values()), context.task.placed)
    if piece is None:
        return
    standing = _standing(context, waiting, piece)
    for robot, spot, tool in tools_at_spots(context):
        if spot.fastener is not None:
            touches = [
                spot_touch(tool, spot.body(piece), pose)
                for pose in tool_poses(spot, tool, has_yaw=False)
            ]
            for other in _against_any(context, with_tool(standing, robot.id, tool), robot, touches):
                yield from _both_ways(context, robot.id, spot.operation, other)


def _both_ways(
    context: TwinContext, robot: RobotId, place: PlaceId, other: RobotId
) -> Iterator[Excluded]:
    station = preparation_place(context.cell, other)
    yield robot, place, station
    yield other, station, place


def _waiting(context: TwinContext) -> Jobsite:
    """Return the site with every robot that carries nothing where it waits."""
    robots = context.cell.robot_by_id
    arms = {
        r: arm if arm.held is not None else replace(arm, q_rad=waiting_q_rad(robots[r], arm.q_rad))
        for r, arm in context.site.arms.items()
    }
    return replace(context.site, arms=arms)


def _standing(context: TwinContext, site: Jobsite, piece: ComponentId) -> Jobsite:
    """Return the site with a piece at the target."""
    if piece in site.steadied:
        return site
    at_target = {**site.world_T_piece, piece: context.task.world_T_target}
    return replace(site, world_T_piece=at_target)


def _against_placing(context: TwinContext, site: Jobsite, holding: Holding) -> frozenset[RobotId]:
    """Return the robots that keep a piece from its target where they wait."""
    tool = context.tool_of(holding.robot)
    if tool is None or context.task.placed is not None:
        return frozenset()
    scene = scene_of(with_held(site, holding.robot, holding.piece, holding.grasp, tool))
    insertion = context.task.insertions[holding.insertion]
    touch = place_touch(context.task, tool, holding.piece, holding.grasp, insertion)
    reaching = Reaching(backends=context.backends, scene=scene, robot=holding.robot)
    pairs = reaching.violations(holding.hold_rad, touch.near_m)
    way = straight_approach(reaching, touch, holding.hold_rad)
    if not pairs and isinstance(way, Approach):
        pairs = reaching.violations(way.pre_rad, touch.free_m, is_padded=True)
    return _if_waiting(site, things_in_the_way(scene, holding.robot, pairs))


def _against_any(
    context: TwinContext, site: Jobsite, robot: Robot, touches: list[Touch]
) -> frozenset[RobotId]:
    """Return the fewest robots that keep another one from all contacts where they wait."""
    reaching = Reaching(backends=context.backends, scene=scene_of(site), robot=robot.id)
    removals: list[frozenset[RobotId]] = []
    for touch in touches:
        near_rad = home_opposite(robot, touch.world_T_tip.position_m)
        search = Approaches(reaching, touch, near_rad)
        if next(iter(search), None) is not None:
            return frozenset()
        why = search.why_not()
        if isinstance(why, BlockedBy):
            removals += [_if_waiting(site, frozenset(names)) for names in why.removals]
    return min((r for r in removals if r), key=lambda r: (len(r), sorted(r)), default=frozenset())


def _if_waiting(site: Jobsite, things: frozenset[str] | None) -> frozenset[RobotId]:
    """Return things as robots if they all are robots that wait, else nothing."""
    free = {r for r, arm in site.arms.items() if arm.held is None}
    robots = frozenset(RobotId(name) for name in things or ())
    return robots if robots <= free else frozenset()
