"""The batch check before symbolic planning: which robot can take, place and reach what."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.planning_twin.approach import Reaching
from sitewright.planning_twin.fastening import Spot, tool_poses
from sitewright.planning_twin.grasp_trial import alone
from sitewright.planning_twin.holding import find_holding, steadying
from sitewright.planning_twin.jobsite import Jobsite, scene_of, tool_for, with_tool, world_T_dock
from sitewright.planning_twin.refusal import NoIk, Refusal
from sitewright.planning_twin.tacking import Holding, can_drive, held_site
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import Capability, EndEffectorKind, Robot, StationKind
from sitewright.robot_team.skill import Skill
from sitewright.symbolic_planning.site_index import preparation_place
from sitewright.symbolic_planning.site_view import GeometricFacts, PlaceId

SKILL_TIME_S: Mapping[str, float] = {
    Capability.GRASPING: 2.0,
    Capability.POSITIONING: 1.5,
    Capability.RELEASING: 1.5,
    Capability.RETRACTING: 1.5,
    Capability.FASTENING: 1.0,
    Capability.FINISHING: 6.0,
    Capability.TOOL_CHANGING: 15.0,
}
"""First estimates, for the plan's costs only; motions are timed exactly afterwards."""

ACT_TIME_S: Mapping[str, float] = {
    Skill.GRASP: 2.0,
    Skill.POSITION: 1.0,
    Skill.SET_DOWN: 1.0,
    Skill.RELEASE: 1.0,
    Skill.FASTEN: 0.5,
}
"""Time of the end effector's act in each skill."""

_TYPICAL_REACH_S = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyRefusal:
    """What the batch check found impossible.

    Attributes:
        fact: The symbolic fact that is missing because of it, in site ids.
    """

    fact: tuple[str, ...]
    refusal: Refusal


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """What the twin knows of a task before any plan is made.

    Attributes:
        holdings: By robot and piece: the grasp that serves all its motions.
    """

    facts: GeometricFacts
    holdings: Mapping[tuple[RobotId, ComponentId], Holding]
    refusals: tuple[StudyRefusal, ...] = field(default=())


def study(context: TwinContext, lies_at: Mapping[ComponentId, PlaceId]) -> Study:
    """Check reach, grasps, holds and fastener access of every robot for a task.

    Args:
        context: Engines, site and task.
        lies_at: Stock place or buffer station of each candidate piece.
    """
    robots = list(context.cell.robot_by_id.values())
    holdings: dict[tuple[RobotId, ComponentId], Holding] = {}
    refusals: list[StudyRefusal] = []
    for robot, piece in _handlers(context, robots):
        found = _holding(context, robot, piece)
        if isinstance(found, Holding):
            holdings[robot.id, piece] = found
        elif found is not None:
            fact = ("can-place", robot.id, piece, context.task.target)
            refusals.append(StudyRefusal(fact=fact, refusal=found))
    facts = _holding_facts(context, holdings, lies_at)
    facts = _spot_facts(context, facts, holdings, robots)
    facts = _station_facts(context, facts, robots)
    return Study(facts=_with_times(facts), holdings=holdings, refusals=tuple(refusals))


def with_another_grasp(
    context: TwinContext, studied: Study, holding: Holding, tried: tuple[Holding, ...]
) -> Study | None:
    """Return the study with the next grasp of a robot for a piece, or None if none is left.

    Args:
        context: As for `study`.
        studied: What is known so far.
        holding: The one whose motions were refused.
        tried: All that were refused, this one included, in order.
    """
    robot = context.cell.robot_by_id[holding.robot]
    found = find_holding(context, robot, holding.piece, tried=tried)
    if not isinstance(found, Holding):
        return None
    holdings = {**studied.holdings, (holding.robot, holding.piece): found}
    tacks = frozenset((c, context.task.target) for h in holdings.values() for c in h.tacks)
    return replace(studied, holdings=holdings, facts=replace(studied.facts, tacks=tacks))


def _holding(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | Refusal | None:
    """Return a holding, why there is none, or None where none is needed."""
    if context.task.placed is None:
        return find_holding(context, robot, piece)
    return steadying(context, robot, piece)


def _handlers(context: TwinContext, robots: list[Robot]) -> Iterator[tuple[Robot, ComponentId]]:
    for robot in robots:
        tool = context.tool_of(robot.id)
        if tool is None or tool.kind is not EndEffectorKind.GRIPPER:
            continue
        held = context.site.arms[robot.id].held
        for piece in context.task.candidates:
            if held in (None, piece) and _is_free_for(context.site, robot.id, piece):
                yield robot, piece


def _is_free_for(site: Jobsite, robot: RobotId, piece: ComponentId) -> bool:
    return all(arm.held != piece or r == robot for r, arm in site.arms.items())


def _holding_facts(
    context: TwinContext,
    holdings: Mapping[tuple[RobotId, ComponentId], Holding],
    lies_at: Mapping[ComponentId, PlaceId],
) -> GeometricFacts:
    target = context.task.target
    reach: set[tuple[RobotId, PlaceId]] = set()
    excludes: set[tuple[RobotId, PlaceId, PlaceId]] = set()
    for robot, piece in holdings:
        reach.add((robot, target))
        if piece in lies_at:
            reach.add((robot, lies_at[piece]))
    mounted = {r: arm.mounted for r, arm in context.site.arms.items()}
    return GeometricFacts(
        can_reach=frozenset(reach),
        can_grasp=frozenset((r, tool, p) for r, p in holdings if (tool := mounted[r]) is not None),
        can_place=frozenset((r, p, target) for r, p in holdings),
        tacks=frozenset((c, target) for h in holdings.values() for c in h.tacks),
        excludes=frozenset(excludes),
    )


def _spot_facts(
    context: TwinContext,
    facts: GeometricFacts,
    holdings: Mapping[tuple[RobotId, ComponentId], Holding],
    robots: list[Robot],
) -> GeometricFacts:
    """Add which robot reaches which fastener or finish, and which only after letting go."""
    task = context.task
    holding = next(iter(holdings.values()), None)
    piece = holding.piece if holding is not None else task.placed
    if piece is None or not task.spots:
        return facts
    held = None if holding is None else _held(context, holding)
    placed = context.site if held is None or holding is None else _let_go(held, holding)
    reach, excludes = set(facts.can_reach), set(facts.excludes)
    for robot, spot in ((r, s) for r in robots for s in task.spots):
        if not _reaches(context, placed, robot, spot):
            continue
        reach.add((robot.id, spot.operation))
        is_tack = holding is not None and spot.operation in holding.tacks
        if held is None or spot.fastener is None or is_tack:
            continue
        if not can_drive(context, held, robot, spot, piece):
            excludes.add((robot.id, spot.operation, task.target))
    return replace(facts, can_reach=frozenset(reach), excludes=frozenset(excludes))


def _held(context: TwinContext, holding: Holding) -> Jobsite | None:
    gripper = context.tool_of(holding.robot)
    return None if gripper is None else held_site(context, holding, gripper)


def _let_go(held: Jobsite, holding: Holding) -> Jobsite:
    arm = replace(held.arms[holding.robot], held=None)
    steadied = {p: r for p, r in held.steadied.items() if p != holding.piece}
    return replace(held, arms={**held.arms, holding.robot: arm}, steadied=steadied)


def _reaches(context: TwinContext, site: Jobsite, robot: Robot, spot: Spot) -> bool:
    tool = tool_for(site, robot, spot)
    if tool is None:
        return False
    scene = alone(scene_of(with_tool(site, robot.id, tool)), robot.id)
    reaching = Reaching(backends=context.backends, scene=scene, robot=robot.id)
    return any(
        not isinstance(reaching.solve(pose.world_T_tip, robot.home_q_rad), NoIk)
        for pose in tool_poses(spot, tool, has_yaw=False)
    )


def _station_facts(
    context: TwinContext, facts: GeometricFacts, robots: list[Robot]
) -> GeometricFacts:
    """Add each robot's preparation station, and tool stations whose docks are within reach."""
    reach = set(facts.can_reach)
    reach |= {(r.id, preparation_place(context.cell, r.id)) for r in robots}
    scene = scene_of(context.site)
    for station in context.cell.station_by_id.values():
        for robot in robots:
            if station.robot not in (None, robot.id):
                continue
            if station.kind is StationKind.TOOL and robot.end_effectors:
                reaching = Reaching(backends=context.backends, scene=scene, robot=robot.id)
                docks = [
                    world_T_dock(context.cell, tool)
                    for i in robot.end_effectors
                    if (tool := context.cell.end_effector_by_id[i]).station == station.id
                ]
                if docks and not any(
                    isinstance(reaching.solve(d, robot.home_q_rad), NoIk) for d in docks
                ):
                    reach.add((robot.id, station.id))
    return replace(facts, can_reach=frozenset(reach))


def _with_times(facts: GeometricFacts) -> GeometricFacts:
    robots = {r for r, _ in facts.can_reach}
    return replace(
        facts,
        reach_time_s=dict.fromkeys(facts.can_reach, _TYPICAL_REACH_S),
        skill_time_s={(r, k): t for r in sorted(robots) for k, t in SKILL_TIME_S.items()},
    )
