"""Everything that is looked at for one motion of an audit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sitewright.app.run_folder import RunFolder
from sitewright.journal.errors import JournalCorruptError
from sitewright.planning_twin.audit import CertificateAudit, Fault, Objection
from sitewright.planning_twin.contact_bounds import contact_use
from sitewright.planning_twin.motion import Certificate, PlannedMotion
from sitewright.planning_twin.path_fit import misfit
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.planning_twin.scene_difference import scene_differences


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """What a run folder holds about one motion.

    Attributes:
        motion: As it was proposed and approved.
        claimed: The certificate made when it started.
        trajectory_sha256: Of what the driver was told, as the journal has it.
        expected_scene: The cell as the journal says that it was sensed; None if the cell file
            is another one by now.
        pieces: Names of the pieces of material.
    """

    motion: PlannedMotion
    claimed: Certificate
    trajectory_sha256: str
    expected_scene: SceneSnapshot | None
    pieces: frozenset[str]


@dataclass(frozen=True, slots=True, kw_only=True)
class Findings:
    """What the audit of one motion came to.

    Attributes:
        pairs, gaps: As in `Reproof`; 0 if it came to no proof.
        closest_distance_m: What the certificate claims.
        longest_contact_m: Way of the tip on which something that moves may touch.
    """

    objections: tuple[Objection, ...]
    pairs: int = 0
    gaps: int = 0
    closest_distance_m: float | None = None
    longest_contact_m: float = 0.0


def findings_of(evidence: Evidence, folder: RunFolder, audit: CertificateAudit) -> Findings:
    """Look whether what ran is what was certified, then prove it again."""
    path, claimed = evidence.motion.timed.path, evidence.claimed
    try:
        scene = folder.load_scene(claimed.scene_revision)
    except JournalCorruptError as error:
        return Findings(objections=(Objection(fault=Fault.RECORD, what=str(error)),))
    contacts = contact_use(scene, path, evidence.pieces)
    proof = audit.reprove(scene, path, claimed)
    return Findings(
        objections=(
            *_wrong_trajectory(evidence),
            *_wrong_scene(evidence, scene),
            *(Objection(fault=Fault.THRESHOLD, what=what) for what in contacts.wrong),
            *proof.objections,
        ),
        pairs=proof.pairs,
        gaps=proof.gaps,
        closest_distance_m=claimed.closest_distance_m,
        longest_contact_m=contacts.longest_m,
    )


def _wrong_trajectory(evidence: Evidence) -> Iterator[Objection]:
    timed = evidence.motion.timed
    if timed.trajectory.sha256() != evidence.trajectory_sha256:
        what = "the trajectory that was started is not the one that was approved"
        yield Objection(fault=Fault.TRAJECTORY, what=what)
    if timed.path.sha256() != evidence.claimed.path_sha256:
        what = "the certificate is about another path"
        yield Objection(fault=Fault.TRAJECTORY, what=what)
    if what := misfit(timed):
        yield Objection(fault=Fault.TRAJECTORY, what=f"the trajectory leaves its path: {what}")


def _wrong_scene(evidence: Evidence, scene: SceneSnapshot) -> Iterator[Objection]:
    robot, path = evidence.motion.timed.path.robot, evidence.motion.timed.path
    if scene.clearance_m != evidence.claimed.clearance_m:
        yield Objection(fault=Fault.SCENE, what="the certificate is about another clearance")
    if scene.robots[robot].q_rad != path.start_rad:
        yield Objection(fault=Fault.SCENE, what=f"robot {robot} does not stand where it starts")
    if evidence.expected_scene is not None:
        for what in scene_differences(scene, evidence.expected_scene):
            yield Objection(fault=Fault.SCENE, what=what)
