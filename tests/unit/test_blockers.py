from __future__ import annotations

from motion_scenes import A, B, two_arms
from sitewright.planning_twin.blockers import blocked_by, removals, things_in_the_way
from sitewright.planning_twin.scene import owner_of, pair_of

SCENE = two_arms()
ELBOW = f"{A}/link_3"


def test_what_a_robot_carries_stands_for_the_robot() -> None:
    assert owner_of(SCENE, "nailer") == B
    assert owner_of(SCENE, f"{B}/link_4") == B
    assert owner_of(SCENE, "table") is None
    pairs = (pair_of(ELBOW, "nailer"), pair_of(ELBOW, f"{B}/link_4"), pair_of("gripper", "stud-1"))
    assert things_in_the_way(SCENE, A, pairs) == frozenset({B, "stud-1"})


def test_a_robot_in_its_own_way_is_helped_by_nothing() -> None:
    pairs = (pair_of(ELBOW, "gripper"), pair_of("gripper", "stud-1"))
    assert things_in_the_way(SCENE, A, pairs) is None
    assert removals(SCENE, A, [pairs]) == ()


def test_only_the_smallest_sets_are_named_the_smallest_first() -> None:
    both = (pair_of("gripper", "stud-1"), pair_of("gripper", "stud-2"))
    postures = [both, (pair_of("gripper", "stud-2"),), (pair_of(ELBOW, "table"), *both[:1])]
    assert removals(SCENE, A, postures) == (("stud-2",), ("stud-1", "table"))


def test_a_blocked_pose_tells_the_pairs_of_the_posture_that_is_freed_most_easily() -> None:
    one_thing_twice = (pair_of(ELBOW, "stud-1"), pair_of("gripper", "stud-1"))
    two_things = (pair_of(ELBOW, "stud-2"), pair_of(ELBOW, "table"))
    itself = (pair_of(ELBOW, "gripper"),)
    postures = [((0.1,), two_things), ((0.2,), itself), ((0.3,), one_thing_twice)]
    found = blocked_by(SCENE, A, postures, reason="no room")
    assert found.pairs == one_thing_twice
    assert found.removals == (("stud-1",), ("stud-2", "table"))
    assert found.reason == "no room"
    assert found.moment is not None
    assert found.moment.q_rad == {A: (0.3,)}
    assert set(found.moment.bodies) == {"gripper", "gripper/left", "gripper/right", "stud-1"}
