"""What the planning twin is asked: place one target and do its operations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose, Vector
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import Jobsite
from sitewright.planning_twin.kept_refusals import KeptRefusals
from sitewright.planning_twin.motion import PlanningBackends
from sitewright.planning_twin.scene import Pair, pair_of
from sitewright.robot_team.cell import Cell, EndEffector
from sitewright.robot_team.skill import SkillCall

UP: Vector = (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Insertion:
    """A straight way in to a target.

    Attributes:
        come_from: World direction, from the target pose to where the piece comes from.
        slide_m: So far from its place it still slides along its neighbours.
    """

    come_from: Vector = UP
    slide_m: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One target, placed in the world, with everything that the graph says about it.

    Attributes:
        candidates: Pieces that may become it.
        touches: Bodies that the placed piece touches: construction parents and joined
            neighbours that stand already, or the fixture under it.
        rests_on: Those of them that carry it, and must be felt once it is placed.
        insertions: Ways in, best first.
        lies_on: What each piece lies on now: the piece or fixture below, and what stands beside.
        spots: Its fasteners and finishes.
        hold_until: So many fasteners must be driven before the robot lets go.
        buffers: World pose of each buffer station's surface.
        placed: The piece that is at the target pose already, held or standing.
    """

    target: ComponentId
    world_T_target: Pose
    candidates: tuple[ComponentId, ...]
    touches: tuple[BodyId, ...]
    rests_on: tuple[BodyId, ...] = ()
    insertions: tuple[Insertion, ...] = (Insertion(),)
    lies_on: Mapping[ComponentId, tuple[BodyId, ...]] = field(default_factory=dict)
    spots: tuple[Spot, ...] = ()
    hold_until: int = 0
    buffers: Mapping[str, Pose] = field(default_factory=dict)
    placed: ComponentId | None = None

    def spot(self, operation: str) -> Spot | None:
        """Return a fastener or finish by its operation id."""
        return next((s for s in self.spots if s.operation == operation), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class TwinContext:
    """The twin's engines, the site as it stands at a moment of the plan, and the task.

    Attributes:
        kept: Refusals that were met before.
        detours: How often people called the way of a call unsafe; it goes another way then.
    """

    backends: PlanningBackends
    site: Jobsite
    task: Task
    seed: int = 0
    kept: KeptRefusals = field(default_factory=KeptRefusals)
    detours: Mapping[SkillCall, int] = field(default_factory=dict)

    @property
    def cell(self) -> Cell:
        """The cell that the site is in."""
        return self.site.cell

    def tool_of(self, robot: RobotId) -> EndEffector | None:
        """Return the end effector on a robot's flange."""
        mounted = self.site.arms[robot].mounted
        return None if mounted is None else self.cell.end_effector_by_id[mounted]


def declared(
    threshold_m: float, left: tuple[BodyId, ...], right: tuple[BodyId, ...]
) -> dict[Pair, float]:
    """Return one threshold for all pairs between two groups of bodies."""
    return {pair_of(a, b): threshold_m for a in left for b in right if a != b}
