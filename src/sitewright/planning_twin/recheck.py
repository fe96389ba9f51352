"""Certifies the very same motions again on the scene as sensed, right before they start."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sitewright.planning_twin.jobsite import Jobsite, scene_of
from sitewright.planning_twin.motion import Certificate, Certifier, PlannedMotion
from sitewright.planning_twin.refusal import NotClear, StaleCertificate
from sitewright.planning_twin.scene import SceneSnapshot


@dataclass(frozen=True, slots=True)
class Recertified:
    """A motion's certificate with the scene that it was made against."""

    scene: SceneSnapshot
    certificate: Certificate


def recertify(
    certifier: Certifier, site: Jobsite, motions: tuple[PlannedMotion, ...]
) -> tuple[Recertified, ...] | StaleCertificate:
    """Prove the motions of one step in the sensed scene.

    Args:
        certifier: The continuous proof.
        site: The cell as sensed now: all robots, pieces, tools.
        motions: Of one step, in order; the scene edits between them are those of the plan.
    """
    proven: list[Recertified] = []
    for scene, motion in scenes_in_turn(scene_of(site), motions):
        answer = certifier.certify(scene, motion.timed.path)
        if isinstance(answer, NotClear):
            return StaleCertificate(cause=answer)
        proven.append(Recertified(scene, answer))
    return tuple(proven)


def scenes_in_turn(
    scene: SceneSnapshot, motions: tuple[PlannedMotion, ...]
) -> Iterator[tuple[SceneSnapshot, PlannedMotion]]:
    """Yield each motion with the scene in which it starts, if the ones before it went well."""
    for motion in motions:
        path = motion.timed.path
        scene = scene.with_joints(path.robot, path.start_rad)
        yield scene, motion
        scene = scene.with_joints(path.robot, path.end_rad)
        for body, placement in motion.scene_edits.items():
            scene = scene.placed(body, placement)
