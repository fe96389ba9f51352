"""Which pairs of a scene count, for whom, and how thresholds are laid over them."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from motion_scenes import A, B, held_stud, kr120, two_arms
from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.layout import Layout
from sitewright.planning_twin.backends.pair_table import PairTable
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.scene import Attachment, Pair, link_name, pair_of

SCENE = two_arms(held_stud())
PROOFS = ProofScenes()
LAYOUT: Layout = PROOFS.of(SCENE).layout
LINKS = [link.name for link in kr120().links if link.shape]
"""From the base to the flange; each is carried by the joint before it."""


def carried_by(robot: RobotId) -> set[str]:
    """Everything that a robot's joints move."""
    placements = {b.id: b.placement for b in SCENE.bodies.values()}
    held = {str(i) for i, p in placements.items() if isinstance(p, Attachment) and p.robot == robot}
    return held | {link_name(robot, link) for link in LINKS[1:]}


def counted_of_one_arm(robot: RobotId) -> set[Pair]:
    """Pairs of an arm and what it carries, by the definition: links that share no joint, unless
    they overlap in every posture, and a body with every link but the one that holds it."""
    neighbours = PROOFS.arm(kr120()).neighbours
    links = combinations(LINKS, 2)
    own = {
        pair_of(*(link_name(robot, n) for n in p)) for p in links if frozenset(p) not in neighbours
    }
    bodies = carried_by(robot) - {link_name(robot, link) for link in LINKS}
    return own | {pair_of(body, link_name(robot, link)) for body in bodies for link in LINKS[:-1]}


@pytest.mark.parametrize(("robot", "other"), [(A, B), (B, A)])
def test_a_robot_changes_its_pairs_with_everything_that_it_does_not_carry(
    robot: RobotId, other: RobotId
) -> None:
    mine, others = carried_by(robot), carried_by(other)
    still = {str(b.id) for b in SCENE.bodies.values()} - mine - others
    still |= {link_name(r, LINKS[0]) for r in (A, B)}
    around = {pair_of(a, b) for a in mine for b in (still | others) - {link_name(robot, LINKS[0])}}
    assert set(LAYOUT.pairs_of[robot].names) == around | counted_of_one_arm(robot)
    standing = {pair_of(a, b) for a in others for b in still - {link_name(other, LINKS[0])}}
    assert set(LAYOUT.standing_of[robot].names) == standing | counted_of_one_arm(other)


@pytest.mark.parametrize("robot", [A, B])
def test_every_part_of_one_body_meets_every_part_of_the_other_once(robot: RobotId) -> None:
    table = LAYOUT.pairs_of[robot]
    count = {str(b.id): len(b.shape) for b in SCENE.bodies.values()}
    for number, (a, b) in enumerate(table.names):
        rows = np.flatnonzero(table.name == number)
        pairs = set(zip(table.a[rows].tolist(), table.b[rows].tolist(), strict=True))
        assert len(pairs) == len(rows) == count.get(a, 1) * count.get(b, 1)


def test_a_declared_pair_has_its_own_threshold_and_unknown_pairs_are_no_error() -> None:
    table: PairTable = LAYOUT.pairs_of[A]
    declared = {("held", "table"): -0.001, ("nobody", "table"): 0.5}
    rows = np.flatnonzero([table.names[n] == ("held", "table") for n in table.name])
    thresholds, flags = table.thresholds(0.01, declared), table.is_declared(declared)
    assert len(rows)
    assert (thresholds[rows] == -0.001).all()
    assert (np.delete(thresholds, rows) == 0.01).all()
    assert np.flatnonzero(flags).tolist() == rows.tolist()
