"""A slice of the campaign with planted thin things."""

from __future__ import annotations

from dataclasses import replace

from benchmarks.certificate_campaign import campaign
from benchmarks.planted import look_densely, planted, with_clutter

from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.proof_scene import ProofScenes


def test_nothing_is_certified_that_dense_samples_find_too_near() -> None:
    counts, _ = campaign(16)
    assert counts["trajectories"] == 16
    assert counts["certified, but collides"] == 0
    assert counts["certified, but nearer than the clearance"] == 0
    assert counts["certified"] >= 3
    assert counts["dense: collides"] >= 3


def test_clutter_that_is_left_out_makes_no_certificate_wrong() -> None:
    counts, _ = campaign(8, 100, clutter=60)
    assert counts["certified, but nearer than the clearance"] == 0
    assert counts["certified"] >= 2
    proofs = ProofScenes()
    certifier = ConservativeAdvancement(proofs)
    bare = next(c for seed in range(100, 120) if (c := planted(certifier, seed)) is not None)
    scene = with_clutter(bare, 1, 60).scene
    standing = {robot: [state.q_rad] for robot, state in scene.robots.items()}
    assert proofs.around(scene, standing).left_out > 20


def test_the_dense_look_sees_a_thing_that_is_planted_and_not_one_that_is_far_off() -> None:
    certifier = ConservativeAdvancement(ProofScenes())
    cases = [case for seed in range(12) if (case := planted(certifier, seed)) is not None]
    case = next(c for c in cases if look_densely(c).collides)
    (name,) = case.things
    elsewhere = case.scene.placed(name, Pose((0.0, 0.0, 9.0)))
    assert not look_densely(replace(case, scene=elsewhere)).is_near
