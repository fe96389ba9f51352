"""What may touch where robots stand: contacts that rest while another robot moves."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.foundation.ids import BodyId, RobotId
from sitewright.planning_twin.approach import CONTACT_M
from sitewright.planning_twin.jobsite import bodies_of_tool, scene_of
from sitewright.planning_twin.scene import Pair
from sitewright.planning_twin.skill_motions.dock import dock_contacts, tool_in_dock
from sitewright.planning_twin.skill_motions.stage import Stage


def resting_contacts(stage: Stage, mover: RobotId) -> dict[Pair, float]:
    """Return the contacts of the robots that stand still while another one moves.

    Only pairs that may touch are looked at: an end effector and a piece, a held piece and what
    it lies on, a flange and a tool in its dock. They do not move, so they keep the threshold of
    a declared contact throughout.
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
        allowed = may_touch(stage, robot)
        found.update({p: CONTACT_M for p in pairs if allowed(p)})
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
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Allowed:
    """Which pairs of one robot can be contacts at all."""

    tools: frozenset[BodyId]
    pieces: frozenset[BodyId]
    held: BodyId | None
    fixtures: frozenset[BodyId]

    def __call__(self, pair: Pair) -> bool:
        """Tell whether a pair is an end effector on a piece, or a held piece on its support."""
        a, b = (BodyId(name) for name in pair)
        return any(
            (x in self.tools and y in self.pieces)
            or (x == self.held and y in self.pieces | self.fixtures)
            for x, y in ((a, b), (b, a))
        )
