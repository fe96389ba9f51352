"""What may touch where robots stand: contacts that rest while another robot moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.planning_twin.approach import CONTACT_M, NEIGHBOUR_M
from sitewright.planning_twin.jobsite import bodies_of_tool, scene_of
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.skill_motions.dock import dock_contacts, tool_in_dock
from sitewright.planning_twin.skill_motions.stage import Stage
from sitewright.planning_twin.task import Task


def resting_contacts(stage: Stage, mover: RobotId) -> dict[Pair, float]:
    """Return the contacts of the robots that stand still while another one moves.

    Only pairs that may touch or be near are looked at: an end effector and a piece, a held piece
    and what it lies on, a flange and a tool in its dock, a gripper and what carries the piece
    between its fingers. They do not move, so they keep their threshold throughout.
    """
    known = stage.resting_of.get(mover)
    if known is None:
        known = stage.resting_of[mover] = _found(stage, mover)
    return dict(known)


def _found(stage: Stage, mover: RobotId) -> dict[Pair, float]:
    scene = scene_of(stage.site)
    found: dict[Pair, float] = {}
    for robot, arm in stage.site.arms.items():
        if robot == mover:
            continue
        pairs = stage.context.backends.collision.violations(scene, robot, arm.q_rad, {})
        found.update(may_touch(stage, robot).thresholds_m(pairs))
        tool = tool_in_dock(stage, robot)
        if tool is not None:
            mating = dock_contacts(stage, robot, tool)
            found.update({p: mating[p] for p in pairs if p in mating})
    return found


def may_touch(stage: Stage, robot: RobotId) -> Allowed:
    """Return which pairs of a robot can be contacts at all, as the site is now."""
    tool = stage.context.tool_of(robot)
    held = stage.site.arms[robot].held
    return Allowed(
        tools=frozenset(() if tool is None else bodies_of_tool(tool)),
        pieces=frozenset(BodyId(p) for p in stage.site.world_T_piece),
        held=None if held is None else BodyId(held),
        fixtures=frozenset(BodyId(f) for f in stage.context.cell.fixture_by_id),
        carriers=frozenset(_carriers(stage.context.task)),
    )


def _carriers(task: Task) -> Iterator[BodyId]:
    """Yield what carries the target, and the pieces that may become it, where they lie."""
    yield from task.touches
    for below in task.lies_on.values():
        yield from below


@dataclass(frozen=True, slots=True, kw_only=True)
class Allowed:
    """Which pairs of one robot can be contacts at all, and which may be near.

    Attributes:
        carriers: What pieces lie on that the robot may have between its fingers: near to the
            fingers when a piece is low, and never touched by them.
    """

    tools: frozenset[BodyId]
    pieces: frozenset[BodyId]
    held: BodyId | None
    fixtures: frozenset[BodyId]
    carriers: frozenset[BodyId]

    def thresholds_m(self, pairs: Iterable[Pair]) -> dict[Pair, float]:
        """Return the least distance of each of some pairs that may be near; others are left out."""
        found = ((pair, self._threshold_m(pair)) for pair in pairs)
        return {pair: tau_m for pair, tau_m in found if tau_m is not None}

    def _threshold_m(self, pair: Pair) -> float | None:
        a, b = (BodyId(name) for name in pair)
        both = ((a, b), (b, a))
        if any(self._is_contact(x, y) for x, y in both):
            return CONTACT_M
        is_near = any(x in self.tools and y in self.carriers for x, y in both)
        return NEIGHBOUR_M if is_near else None

    def _is_contact(self, body: BodyId, other: BodyId) -> bool:
        """Tell whether a pair is an end effector on a piece, or a held piece on its support."""
        on_piece = body in self.tools and other in self.pieces
        return on_piece or (body == self.held and other in self.pieces | self.fixtures)
