"""Certifies the very same motions again on the scene as sensed, right before they start."""

from __future__ import annotations

from sitewright.planning_twin.jobsite import Jobsite, scene_of
from sitewright.planning_twin.motion import Certificate, Certifier, PlannedMotion
from sitewright.planning_twin.refusal import NotClear, StaleCertificate


def recertify(
    certifier: Certifier, site: Jobsite, motions: tuple[PlannedMotion, ...]
) -> tuple[Certificate, ...] | StaleCertificate:
    """Prove the motions of one step in the sensed scene.

    Args:
        certifier: The continuous proof.
        site: The cell as sensed now: all robots, pieces, tools.
        motions: Of one step, in order; the scene edits between them are those of the plan.
    """
    scene = scene_of(site)
    certificates: list[Certificate] = []
    for motion in motions:
        path = motion.timed.path
        scene = scene.with_joints(path.robot, path.start_rad)
        answer = certifier.certify(scene, path)
        if isinstance(answer, NotClear):
            return StaleCertificate(cause=answer)
        certificates.append(answer)
        scene = scene.with_joints(path.robot, path.end_rad)
        for body, placement in motion.scene_edits.items():
            scene = scene.placed(body, placement)
    return tuple(certificates)
