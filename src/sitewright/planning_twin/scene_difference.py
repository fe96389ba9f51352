"""How a scene differs from another one that should be the same but for sensing."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from sitewright.foundation.pose import Pose, distance
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.scene import (
    Attachment,
    Body,
    RobotInScene,
    SceneSnapshot,
    arm_text,
)

SAME_M = 2e-4
"""A journal leaves out what changed by less than half of this."""
SAME_RAD = 4e-4
_HELD_FACTOR = 10.0
"""A held piece is seen from its robot's tip; what the joints are off by adds up there."""


def scene_differences(stored: SceneSnapshot, expected: SceneSnapshot) -> tuple[str, ...]:
    """Return, in sentences, how the stored scene is not what is expected."""
    return tuple(_differences(stored, expected))


def _differences(stored: SceneSnapshot, expected: SceneSnapshot) -> Iterator[str]:
    if stored.clearance_m != expected.clearance_m:
        yield (
            f"its clearance is {stored.clearance_m * 1e3:g} mm, "
            f"not {expected.clearance_m * 1e3:g} mm"
        )
    yield from _missing("robot", stored.robots.keys(), expected.robots.keys())
    yield from _missing("body", stored.bodies.keys(), expected.bodies.keys())
    for robot in sorted(stored.robots.keys() & expected.robots.keys()):
        if what := _arm_difference(stored.robots[robot], expected.robots[robot]):
            yield f"robot {robot} {what}"
    for body in sorted(stored.bodies.keys() & expected.bodies.keys()):
        if what := _body_difference(stored.bodies[body], expected.bodies[body]):
            yield f"body {body} {what}"


def _missing(kind: str, stored: AbstractSet[str], expected: AbstractSet[str]) -> Iterator[str]:
    for name in sorted(expected - stored):
        yield f"{kind} {name} is missing"
    for name in sorted(stored - expected):
        yield f"{kind} {name} is not in the cell"


def _arm_difference(stored: RobotInScene, expected: RobotInScene) -> str:
    if arm_text(stored.description) != arm_text(expected.description):
        return "is another arm"
    if not _is_near(stored.world_T_base, expected.world_T_base):
        return "stands somewhere else"
    joints = zip(stored.q_rad, expected.q_rad, strict=True)
    if max(abs(a - b) for a, b in joints) > SAME_RAD:
        return "has another posture"
    return ""


def _body_difference(stored: Body, expected: Body) -> str:
    if not _is_same_shape(stored.shape, expected.shape):
        return "has another shape"
    match stored.placement, expected.placement:
        case Attachment() as a, Attachment() as b:
            if a.robot != b.robot:
                return f"is carried by {a.robot}, not {b.robot}"
            same = _is_near(a.tip_T_body, b.tip_T_body, _HELD_FACTOR)
            return "" if same else "is held in another way"
        case Pose() as a, Pose() as b:
            return "" if _is_near(a, b) else "is somewhere else"
        case Attachment(), _:
            return "is carried, but was seen to stand"
        case _:
            return "stands, but was seen to be carried"


def _is_near(a: Pose, b: Pose, factor: float = 1.0) -> bool:
    return a.distance_to_m(b) <= SAME_M * factor and a.angle_to_rad(b) <= SAME_RAD * factor


def _is_same_shape(a: Shape, b: Shape) -> bool:
    if len(a) != len(b):
        return False
    for mine, other in zip(a, b, strict=True):
        corners, others = mine.vertices_m(), other.vertices_m()
        if len(corners) != len(others):
            return False
        if any(distance(p, q) > SAME_M for p, q in zip(corners, others, strict=True)):
            return False
    return True
