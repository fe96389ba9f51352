"""What a refusal depends on, as one hash: when it changes, the refusal is void."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId, ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.jobsite import Jobsite, scene_of
from sitewright.planning_twin.scene import Attachment, SceneSnapshot, shape_hash
from sitewright.symbolic_planning.nogood import scope_hash


def scope_of(
    site: Jobsite, robot: RobotId, about: tuple[str, ...], blockers: Iterable[str] = ()
) -> str:
    """Return the hash of a robot, what it was to do, and who was in its way.

    Args:
        site: The site on which the motion was refused.
        robot: Who should have moved.
        about: Ids of the skill and of what it is about; pieces count with where they lie.
        blockers: Bodies, and links as ``robot/link``, that were in the way.
    """
    arm, scene = site.arms[robot], scene_of(site)
    pieces = sorted({ComponentId(name) for name in about} & site.world_T_piece.keys())
    return scope_hash(
        {
            "robot": robot,
            "world_T_base": _numbers(site.cell.robot_by_id[robot].world_T_base),
            "end_effector": arm.mounted,
            "held": None if arm.held is None else [arm.held, _numbers(arm.tip_T_held)],
            "about": list(about),
            "pieces": {p: _numbers(site.world_T_piece[p]) for p in pieces},
            "blockers": {name: _blocker(scene, name) for name in sorted(set(blockers))},
        }
    )


def _blocker(scene: SceneSnapshot, name: str) -> Json:
    body = scene.bodies.get(BodyId(name))
    if body is None:
        robot = scene.robots.get(RobotId(name.split("/", maxsplit=1)[0]))
        return None if robot is None else list(robot.q_rad)
    placement = body.placement
    if isinstance(placement, Attachment):
        carrier = scene.robots[placement.robot]
        where: Json = [placement.robot, list(carrier.q_rad), _numbers(placement.tip_T_body)]
    else:
        where = _numbers(placement)
    return [shape_hash(body.shape), where]


def _numbers(pose: Pose) -> list[float]:
    return [*pose.position_m, *pose.quaternion_wxyz]
