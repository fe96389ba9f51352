"""What differs between a stored scene and the cell as sensed is named."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from motion_scenes import HOME, A, B, box, held_stud, two_arms
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.planning_twin.scene import Attachment, SceneSnapshot
from sitewright.planning_twin.scene_difference import scene_differences

SCENE = two_arms(held_stud())
TABLE, STOCK, HELD = BodyId("table"), BodyId("stock-0"), BodyId("held")


def pose_of(body: BodyId) -> Pose:
    placement = SCENE.bodies[body].placement
    assert isinstance(placement, Pose)
    return placement


def with_base(scene: SceneSnapshot, pose: Pose) -> SceneSnapshot:
    return replace(scene, robots={**scene.robots, B: replace(scene.robots[B], world_T_base=pose)})


CHANGES: dict[str, Callable[[SceneSnapshot], SceneSnapshot]] = {
    "body table is missing": lambda s: s.without(TABLE),
    "body wall is not in the cell": lambda s: s.with_body(box("wall", (1, 1, 1), Pose())),
    "body table has another shape": lambda s: s.with_body(
        box("table", (1.6, 2.6, 0.399), pose_of(TABLE))
    ),
    "body stock-0 is somewhere else": lambda s: s.placed(
        STOCK, translation(0.0, 0.0, 0.0005) @ pose_of(STOCK)
    ),
    "body stock-0 is carried, but was seen to stand": lambda s: s.placed(
        STOCK, Attachment(A, Pose())
    ),
    "body held stands, but was seen to be carried": lambda s: s.placed(HELD, Pose()),
    "body held is carried by b, not a": lambda s: s.placed(HELD, Attachment(B, Pose())),
    "body held is held in another way": lambda s: s.placed(HELD, Attachment(A, Pose())),
    "robot a has another posture": lambda s: s.with_joints(A, (HOME[0] + 0.001, *HOME[1:])),
    "robot b stands somewhere else": lambda s: with_base(s, Pose()),
    "robot b is missing": lambda s: replace(s, robots={A: s.robots[A]}),
    "its clearance is 5 mm, not 10 mm": lambda s: replace(s, clearance_m=0.005),
}


def test_equal_scenes_do_not_differ() -> None:
    assert scene_differences(SCENE, two_arms(held_stud())) == ()


@pytest.mark.parametrize("what", CHANGES)
def test_what_differs_is_named(what: str) -> None:
    assert scene_differences(CHANGES[what](SCENE), SCENE) == (what,)


def test_what_sensors_may_differ_by_is_no_difference() -> None:
    nearly = SCENE.placed(
        STOCK, pose_of(STOCK) @ translation(0.0001, 0.0, 0.0) @ rotation((0, 0, 1), 2e-4)
    ).with_joints(A, tuple(q + 1e-4 for q in HOME))
    assert scene_differences(nearly, SCENE) == ()


def test_another_arm_is_named() -> None:
    arm = SCENE.robots[A]
    shorter = replace(arm.description, tip=arm.description.links[-2].name)
    other = replace(SCENE, robots={**SCENE.robots, A: replace(arm, description=shorter)})
    assert scene_differences(other, SCENE) == ("robot a is another arm",)
