"""Run folders in which a step started, honest or forged, for tests of the audit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from builders_planning import EXAMPLES, Rehearsal
from builders_run import Boundaries, Clock, Ids
from sitewright.app.event_log import EventLog
from sitewright.app.project import Project, read_project
from sitewright.app.run_folder import RunFolder
from sitewright.central_controller.events import EpochOpened, RunStarted, SkillIntent
from sitewright.central_controller.ports import SiteContext, StillClear
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.rehearsal import after_step
from sitewright.central_controller.sensed import differences
from sitewright.foundation.ids import CommandId, ComponentId, RunId
from sitewright.journal.sqlite import SqliteJournal
from sitewright.planning_twin.motion import Certificate, PathSegment, PlannedMotion
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.trajectory import Trajectory


@dataclass(frozen=True)
class Started:
    """A step with one motion that is about to start.

    Attributes:
        told: The trajectory that the driver is told; None: the one of the step.
        keeps_proofs: Whether the journal keeps the certificate.
    """

    proposal: Proposal
    step: ProposedStep
    context: SiteContext
    certificate: Certificate
    scene: SceneSnapshot
    told: Trajectory | None = None
    keeps_proofs: bool = True

    @property
    def motion(self) -> PlannedMotion:
        """The motion of the step."""
        (motion,) = self.step.motions
        return motion

    def with_motion(self, motion: PlannedMotion) -> Started:
        """Return the same with another motion in the proposal, and a certificate about it."""
        step = replace(self.step, motions=(motion,))
        steps = tuple(step if s.number == step.number else s for s in self.proposal.steps)
        return replace(
            self,
            step=step,
            proposal=replace(self.proposal, steps=steps),
            certificate=replace(self.certificate, path_sha256=motion.timed.path.sha256()),
        )

    def with_segments(self, change: Callable[[int, PathSegment], PathSegment]) -> Started:
        """Return the same with every segment of the path changed."""
        timed = self.motion.timed
        segments = tuple(change(k, s) for k, s in enumerate(timed.path.segments))
        path = replace(timed.path, segments=segments)
        return self.with_motion(replace(self.motion, timed=replace(timed, path=path)))

    def with_scene(self, scene: SceneSnapshot) -> Started:
        """Return the same with the certificate about another scene."""
        return replace(
            self,
            scene=scene,
            certificate=replace(
                self.certificate,
                scene_revision=scene.revision(),
                clearance_m=scene.clearance_m,
            ),
        )


def started(frame: Rehearsal, target: ComponentId, skill: str) -> Started:
    """Return the first step with a skill in a target's plan, as the start check lets it start."""
    proposal, context = frame.planned[target].proposal, frame.before[target]
    for step in proposal.steps:
        if step.call.skill == skill:
            clear = frame.proposals.check(step, context)
            assert isinstance(clear, StillClear)
            return Started(proposal, step, context, clear.certificates[0], clear.scenes[0])
        context = after_step(context, step, target)
    raise AssertionError(f"no {skill} for {target}")


def wooden_frame(folder: Path) -> Project:
    """Return the case study's project, copied into a folder."""
    for name in ("building.json", "cell.toml"):
        (folder / name).write_bytes((EXAMPLES / "wooden_frame" / name).read_bytes())
    return read_project(folder)


def write_run(project: Project, start: Started) -> RunFolder:
    """Write a run folder whose journal says that a step started."""
    run = RunFolder(project.folder / "runs" / "0001-test")
    run.create()
    fingerprint = run.save_proposal(start.proposal)
    run.keep_scene(start.scene)
    hashes = dict(start.proposal.context)
    with SqliteJournal(run.journal) as journal:
        log = EventLog(run, journal, clock=Clock(), ids=Ids(Boundaries()))
        log.append(RunStarted(run=RunId(run.run), project="test", hashes=hashes))
        log.append(EpochOpened(epoch=1))
        for event in differences(None, start.context.observation):
            log.append(event)
        log.append(_intent(start, fingerprint))
    return run


def _intent(start: Started, fingerprint: str) -> SkillIntent:
    told = start.told or start.motion.timed.trajectory
    return SkillIntent(
        command_id=CommandId("command-1"),
        approval_id="approval",
        step=start.step.number,
        fingerprint=fingerprint,
        target=start.proposal.target,
        call=start.step.call,
        params=start.step.params,
        effects=start.step.effects,
        epoch=1,
        trajectories=(told.sha256(),),
        certificates=1,
        proofs=(start.certificate,) if start.keeps_proofs else (),
    )
