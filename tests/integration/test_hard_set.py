"""The hard set: witnesses hold by the independent checker, and no query is a plain line."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest
from benchmarks.motion.generate import FAMILIES, made
from benchmarks.motion.hard_set import stored_queries, stored_witness
from benchmarks.motion.query import MotionQuery, from_plain, to_plain
from benchmarks.motion.solvers.ours import Sitewright

from sitewright.planning_twin.backends.audit.reproof import SeparatingPlanes
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.motion import Certificate
from sitewright.planning_twin.refusal import NotClear
from sitewright.robot_team.description import Joints

PROVER = ConservativeAdvancement(ProofScenes())


def faults(query: MotionQuery, witness: tuple[Joints, ...]) -> tuple[str, ...]:
    """Return what the second proof objects to."""
    path = query.path(witness)
    certificate = PROVER.certify(query.scene, path)
    assert isinstance(certificate, Certificate)
    found = SeparatingPlanes().reprove(query.scene, path, certificate)
    return tuple(o.what for o in found.objections)


def test_every_family_has_at_least_ten_queries() -> None:
    count = Counter(q.family for q in stored_queries())
    assert set(count) == set(FAMILIES)
    assert min(count.values()) >= 10
    assert len({q.name for q in stored_queries()}) == count.total() >= 60


@pytest.mark.parametrize("family", FAMILIES)
def test_the_witness_of_a_query_holds_by_separating_planes(family: str) -> None:
    query, *_ = stored_queries(family)
    witness = stored_witness(query)
    assert (witness[0], witness[-1]) == (query.start_rad, query.goal_rad)
    assert faults(query, witness) == ()


def test_every_witness_is_proven_and_no_query_is_a_plain_line() -> None:
    for query in stored_queries():
        witness = stored_witness(query)
        assert (witness[0], witness[-1]) == (query.start_rad, query.goal_rad)
        assert PROVER.objection(query.scene, query.path(witness)) is None, query.name
        line = query.path((query.start_rad, query.goal_rad))
        assert isinstance(PROVER.objection(query.scene, line), NotClear), query.name


def test_every_witness_is_in_a_narrow_place() -> None:
    """With 17 mm of clearance instead of 10 mm none of them would hold."""
    for query in stored_queries():
        wide = replace(query.scene, clearance_m=0.017)
        path = query.path(stored_witness(query))
        assert isinstance(PROVER.objection(wide, path), NotClear), query.name


@pytest.mark.parametrize("family", FAMILIES)
def test_our_planner_finds_a_path_that_holds_by_separating_planes(family: str) -> None:
    query, *_ = stored_queries(family)[1:]
    answer = Sitewright().solve(query, seed=0)
    assert (answer.waypoints_rad[0], answer.waypoints_rad[-1]) == (query.start_rad, query.goal_rad)
    assert faults(query, answer.waypoints_rad) == ()


@pytest.mark.parametrize("name", ["stud-between-studs-01", "last-stud-10"])
def test_a_piece_under_a_ledge_is_got_out_sideways_within_the_first_budget(name: str) -> None:
    query = next(q for q in stored_queries() if q.name == name)
    assert "ledge" in query.scene.bodies
    found = TwoTrees(ProofScenes()).plan(query.scene, query.request(), seed=0)
    assert isinstance(found, tuple)
    assert PROVER.objection(query.scene, query.path(found)) is None


def test_a_query_made_anew_has_a_witness_that_holds() -> None:
    query, witness = next(made("both-arms", 1))
    assert from_plain(to_plain(query)) == query
    assert faults(query, witness) == ()
