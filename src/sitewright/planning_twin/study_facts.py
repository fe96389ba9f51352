"""Symbolic facts of the batch check: what holdings, tools and stations make possible."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.driving import DrivingWays
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.jobsite import Jobsite, tool_for, world_T_dock
from sitewright.planning_twin.refusal import NoIk
from sitewright.planning_twin.setting_down import places_to_set_down
from sitewright.planning_twin.skill_times import SKILL_TIME_S, TYPICAL_REACH_S
from sitewright.planning_twin.tacking import Holding, held_site
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import EndEffector, Robot, Station, StationKind
from sitewright.robot_team.waiting import home_opposite
from sitewright.symbolic_planning.site_index import preparation_place
from sitewright.symbolic_planning.site_view import GeometricFacts, PlaceId

HolderOf = Mapping[tuple[RobotId, ComponentId], Holding]
Reach = tuple[RobotId, PlaceId]


def base_facts(
    context: TwinContext,
    handlers: list[tuple[RobotId, ComponentId]],
    holdings: HolderOf,
    lies_at: Mapping[ComponentId, PlaceId],
) -> GeometricFacts:
    """Return the facts as if every robot could do what its end effectors are for.

    What the batch check refuses is taken away by nogoods, so that each can be lifted to see
    whether it is to blame.

    Args:
        context: Engines, site and task.
        handlers: Robots with a gripper, and the pieces that they might take.
        holdings: Grasps that were found.
        lies_at: Stock place or buffer station of each candidate piece.
    """
    target = context.task.target
    mounted = {r: arm.mounted for r, arm in context.site.arms.items()}
    reach: set[Reach] = {(r, target) for r, _ in handlers}
    reach |= {(r, lies_at[p]) for r, p in handlers if p in lies_at}
    reach |= {(r.id, s.operation) for r, s, _ in tools_at_spots(context)}
    reach |= set(_stations_in_reach(context))
    set_downs = frozenset(places_to_set_down(context, holdings.values()))
    reach |= {(r, place) for r, _, place in set_downs}
    facts = GeometricFacts(
        can_set_down=set_downs,
        can_reach=frozenset(reach),
        can_grasp=frozenset((r, tool, p) for r, p in handlers if (tool := mounted[r]) is not None),
        can_place=frozenset((r, p, target) for r, p in handlers),
        tacks=frozenset((c, target) for h in holdings.values() for c in h.tacks),
        excludes=frozenset(_only_after_letting_go(context, holdings)),
    )
    return _with_times(facts)


def tools_at_spots(context: TwinContext) -> Iterator[tuple[Robot, Spot, EndEffector]]:
    """Yield each robot that has a tool for an operation of the task, mounted or docked."""
    for robot in context.cell.robot_by_id.values():
        for spot in context.task.spots:
            tool = tool_for(context.site, robot, spot)
            if tool is not None:
                yield robot, spot, tool


def out_of_reach(context: TwinContext, robot: Robot, spot: Spot, tool: EndEffector) -> NoIk | None:
    """Return why no pose of a tool at an operation has a posture; None if one has."""
    refusals: list[NoIk] = []
    for pose in tool_poses(spot, tool, has_yaw=False):
        found = _solved(context, robot, pose.world_T_tip)
        if not isinstance(found, NoIk):
            return None
        refusals.append(found)
    return NoIk(
        is_proven=all(r.is_proven for r in refusals),
        extension_m=min(r.extension_m for r in refusals),
        tried=len(refusals),
        reason=refusals[0].reason,
    )


def _solved(context: TwinContext, robot: Robot, world_T_tip: Pose) -> object:
    base_T_tip = robot.world_T_base.inverse() @ world_T_tip
    near_rad = home_opposite(robot, world_T_tip.position_m)
    return context.backends.kinematics.solve(robot.description, base_T_tip, near_rad)


def _only_after_letting_go(
    context: TwinContext, holdings: HolderOf
) -> Iterator[tuple[RobotId, PlaceId, PlaceId]]:
    """Yield which robot must not be at which fastener while the handler is at the target."""
    for holding in holdings.values():
        held, ways = _held(context, holding), DrivingWays(context, holding.piece)
        for robot, spot, _ in tools_at_spots(context):
            if held is None or spot.fastener is None or spot.operation in holding.tacks:
                continue
            if not ways.can_drive(held, robot, spot):
                yield robot.id, spot.operation, context.task.target
        return


def _held(context: TwinContext, holding: Holding) -> Jobsite | None:
    gripper = context.tool_of(holding.robot)
    return None if gripper is None else held_site(context, holding, gripper)


def _stations_in_reach(context: TwinContext) -> Iterator[Reach]:
    """Yield each robot's preparation station, and tool stations whose docks are within reach."""
    for robot in context.cell.robot_by_id.values():
        yield robot.id, preparation_place(context.cell, robot.id)
        for station in context.cell.station_by_id.values():
            is_own = station.robot in (None, robot.id)
            if is_own and station.kind is StationKind.TOOL and _docks(context, robot, station):
                yield robot.id, station.id


def _docks(context: TwinContext, robot: Robot, station: Station) -> bool:
    tools = [context.cell.end_effector_by_id[i] for i in robot.end_effectors]
    docks = [world_T_dock(context.cell, t) for t in tools if t.station == station.id]
    return bool(docks) and not any(isinstance(_solved(context, robot, d), NoIk) for d in docks)


def _with_times(facts: GeometricFacts) -> GeometricFacts:
    robots = {r for r, _ in facts.can_reach}
    return replace(
        facts,
        reach_time_s=dict.fromkeys(facts.can_reach, TYPICAL_REACH_S),
        skill_time_s={(r, k): t for r in sorted(robots) for k, t in SKILL_TIME_S.items()},
    )
