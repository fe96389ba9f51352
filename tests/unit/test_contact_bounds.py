"""Declared contacts are short, shallow, straight, and at the ends of a motion only."""

from __future__ import annotations

import pytest

from motion_scenes import HOME, A, gripper, held_stud, kr120, lowering, one_arm, two_arms
from sitewright.foundation.pose import rotation, translation
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.contact_bounds import contact_use
from sitewright.planning_twin.motion import JointPath, PathSegment
from sitewright.planning_twin.scene import Pair, SceneSnapshot
from sitewright.planning_twin.straight import straight_line
from sitewright.robot_team.description import Joints
from sitewright.robot_team.kinematics import tip_pose

TOUCH: Pair = ("held", "table")
SCENE, APPROACH, LAST = lowering(0.12)


def path(*segments: tuple[tuple[Joints, ...], dict[Pair, float]]) -> JointPath:
    return JointPath(
        robot=A, segments=tuple(PathSegment(waypoints_rad=w, threshold_m=t) for w, t in segments)
    )


def straight(length_m: float) -> tuple[Joints, ...]:
    """The tip goes straight up by a length."""
    return turned_up(length_m, 0.0)


def turned_up(length_m: float, turn_rad: float) -> tuple[Joints, ...]:
    tip = tip_pose(kr120(), HOME)
    up = translation(0.0, 0.0, length_m) @ tip @ rotation((0.0, 0.0, 1.0), turn_rad)
    found = straight_line(OpwKinematics(), SCENE.robots[A], tip, up, HOME)
    assert isinstance(found, tuple)
    return found


def wrong(scene: SceneSnapshot, line: JointPath, *pieces: str) -> tuple[str, ...]:
    return contact_use(scene, line, pieces).wrong


def test_touching_in_the_last_three_centimetres_is_within_bounds() -> None:
    use = contact_use(SCENE, path((APPROACH, {}), (LAST, {TOUCH: -0.001})))
    assert use.wrong == ()
    assert use.deepest_m == -0.001
    assert use.longest_m == pytest.approx(0.03, abs=1e-6)


def test_a_path_without_contacts_uses_none() -> None:
    use = contact_use(SCENE, path((APPROACH, {}), (LAST, {TOUCH: 0.001})))
    assert (use.wrong, use.deepest_m, use.longest_m) == ((), 0.0, 0.0)


def test_a_long_contact_is_out_of_bounds() -> None:
    (what,) = wrong(SCENE, path((straight(0.05), {TOUCH: -0.001})))
    assert "over 50 mm; at most 35 mm" in what


def test_two_short_contacts_in_a_row_are_one_long_one() -> None:
    up = straight(0.06)
    (what,) = wrong(SCENE, path((up[:2], {TOUCH: -0.001}), (up[1:], {TOUCH: -0.001})))
    assert "over 60 mm" in what


def test_only_a_held_piece_may_slide_for_longer() -> None:
    line = path((straight(0.30), {TOUCH: -0.001}))
    assert wrong(SCENE, line, "held") == ()
    assert len(wrong(SCENE, line, "table")) == 1
    both = path((straight(0.30), {TOUCH: -0.001, ("a/link_6", "table"): -0.001}))
    assert len(wrong(SCENE, both, "held")) == 1
    assert len(wrong(SCENE, path((straight(0.36), {TOUCH: -0.001})), "held")) == 1


def test_a_contact_in_the_middle_is_out_of_bounds() -> None:
    (what,) = wrong(SCENE, path((APPROACH, {}), (LAST, {TOUCH: -0.001}), (LAST[::-1], {})))
    assert "in the middle" in what


def test_a_contact_while_the_tip_turns_is_out_of_bounds() -> None:
    (what,) = wrong(SCENE, path((turned_up(0.02, 0.1), {TOUCH: -0.001})))
    assert "turns" in what


def test_a_contact_on_a_curve_is_out_of_bounds() -> None:
    up, (*_, back) = straight(0.01), straight(0.005)
    aside = tuple(v + (0.004 if k == 0 else -0.004 if k == 5 else 0.0) for k, v in enumerate(back))
    found = wrong(SCENE, path(((HOME, aside, up[-1]), {TOUCH: -0.001})))
    assert any("straight" in what for what in found)


@pytest.mark.parametrize(("pair", "deepest_m"), [(TOUCH, -0.001), (("a/link_6", "held"), -0.003)])
def test_depth_is_bounded(pair: Pair, deepest_m: float) -> None:
    within = path((LAST, {pair: deepest_m}))
    beyond = path((LAST, {pair: deepest_m - 0.0005}))
    assert wrong(SCENE, within) == ()
    (what,) = wrong(SCENE, beyond)
    assert "overlap" in what


def test_contacts_of_others_that_rest_may_last() -> None:
    scene = two_arms(held_stud(), *gripper(A))
    line = path(((HOME, tuple(v + 0.2 for v in HOME)), {("nailer", "stud-1"): -0.001}))
    assert wrong(scene, line) == ()
    assert len(wrong(scene, path((line.segments[0].waypoints_rad, {("held", "stud-1"): -0.001}))))


def test_standing_still_in_contact_is_within_bounds() -> None:
    assert wrong(one_arm(held_stud()), path(((HOME, HOME), {TOUCH: -0.001}))) == ()
