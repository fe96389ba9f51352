"""Proves the certificates of a run again from its folder, without planner and prover."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from sitewright.app.audited_motion import Evidence, Findings, findings_of
from sitewright.app.expected_scenes import ExpectedScenes
from sitewright.app.project import Project
from sitewright.app.run_folder import RunFolder, chain_events, chain_of
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import AnyEvent, SkillIntent, SkillReissued
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import site_of
from sitewright.foundation.ids import RobotId
from sitewright.journal.errors import JournalCorruptError
from sitewright.planning_twin.audit import CertificateAudit, Fault, Objection
from sitewright.planning_twin.motion import Certificate


@dataclass(frozen=True, slots=True, kw_only=True)
class AuditedMotion:
    """One motion of a started step.

    Attributes:
        number: 1 for the first motion of the step.
    """

    target: str
    step: int
    skill: str
    robot: RobotId
    number: int
    findings: Findings


@dataclass(frozen=True, slots=True, kw_only=True)
class AuditReport:
    """What an audit of one run found.

    Attributes:
        not_kept: Motions of an older version, which kept no certificates.
        is_scene_compared: Whether the scenes were compared with cell file and journal; they are
            not if the cell file is another one by now.
    """

    run: str
    motions: tuple[AuditedMotion, ...]
    not_kept: int
    is_scene_compared: bool

    @property
    def is_proven(self) -> bool:
        """Whether every motion was proven again."""
        return not self.not_kept and not any(m.findings.objections for m in self.motions)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Start:
    """A step that started, with the state of the run right before."""

    intent: SkillIntent
    proofs: tuple[Certificate, ...]
    state: CycleState


def audit_certificates(
    project: Project,
    folder: RunFolder,
    *,
    on_motion: Callable[[AuditedMotion], None] = lambda _motion: None,
) -> AuditReport:
    """Prove every certificate of a run again.

    Raises:
        JournalError: The journal cannot be trusted at all.
    """
    from sitewright.planning_twin.backends.audit.reproof import SeparatingPlanes

    scenes = ExpectedScenes(project, folder)
    load = cache(folder.load_proposal)
    motions: list[AuditedMotion] = []
    not_kept = 0
    for start in _starts(project, folder):
        if start.intent.trajectories and not start.proofs:
            not_kept += len(start.intent.trajectories)
            continue
        for motion in _audited_step(load, start, scenes, SeparatingPlanes()):
            motions.append(motion)
            on_motion(motion)
    return AuditReport(
        run=folder.run,
        motions=tuple(motions),
        not_kept=not_kept,
        is_scene_compared=scenes.is_known,
    )


def _starts(project: Project, folder: RunFolder) -> Iterator[_Start]:
    """Yield all starts of a run, those of the runs before it left out."""
    chain = chain_of(folder)
    earlier = len(chain_events(chain[:-1])[0])
    state = CycleState(site=site_of(project.model))
    for number, event in enumerate(chain_events(chain)[0]):
        if number >= earlier and (start := _start(state, event)) is not None:
            yield start
        state = folded(state, event)


def _start(state: CycleState, event: AnyEvent) -> _Start | None:
    match event:
        case SkillIntent():
            return _Start(intent=event, proofs=event.proofs, state=state)
        case SkillReissued() if state.flight is not None:
            return _Start(intent=state.flight.intent, proofs=event.proofs, state=state)
        case _:
            return None


def _audited_step(
    load: Callable[[str], Proposal],
    start: _Start,
    scenes: ExpectedScenes,
    audit: CertificateAudit,
) -> Iterator[AuditedMotion]:
    intent = start.intent
    try:
        step = _stored_step(load, intent)
        evidence = _evidence(start, step, scenes)
    except JournalCorruptError as error:
        objection = Objection(fault=Fault.RECORD, what=str(error))
        yield _audited(intent, 1, Findings(objections=(objection,)))
        return
    for number, each in enumerate(evidence, start=1):
        yield _audited(intent, number, findings_of(each, scenes.folder, audit))


def _audited(intent: SkillIntent, number: int, findings: Findings) -> AuditedMotion:
    return AuditedMotion(
        target=intent.target,
        step=intent.step,
        skill=intent.call.skill,
        robot=intent.call.robot,
        number=number,
        findings=findings,
    )


def _stored_step(load: Callable[[str], Proposal], intent: SkillIntent) -> ProposedStep:
    """Return the step that was started, from its proposal; the fingerprint is checked."""
    proposal = load(intent.fingerprint)
    steps = [s for s in proposal.steps if s.number == intent.step]
    if len(steps) != 1 or steps[0].call != intent.call:
        what = f"its step {intent.step} is not what was started"
        raise JournalCorruptError(Path(f"{intent.fingerprint}.json"), what)
    return steps[0]


def _evidence(start: _Start, step: ProposedStep, scenes: ExpectedScenes) -> tuple[Evidence, ...]:
    started, planned, proven = start.intent.trajectories, step.motions, start.proofs
    if not len(started) == len(planned) == len(proven):
        what = (
            f"step {step.number} started {len(started)} motions, {len(planned)} were planned and "
            f"{len(proven)} have certificates"
        )
        raise JournalCorruptError(scenes.folder.journal, what)
    expected = scenes.of(start.state, step)
    rows = zip(planned, proven, started, expected, strict=True)
    return tuple(
        Evidence(
            motion=motion,
            claimed=claimed,
            trajectory_sha256=digest,
            expected_scene=scene,
            pieces=scenes.pieces,
        )
        for motion, claimed, digest, scene in rows
    )
