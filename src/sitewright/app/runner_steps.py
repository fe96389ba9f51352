"""Step commands: gate and intent, execution, and the look at what it did."""

from __future__ import annotations

from collections.abc import Generator, Iterator

from sitewright.app.runner import Run
from sitewright.central_controller.cycle_state import CycleState, Flight
from sitewright.central_controller.events import (
    AnyEvent,
    ApprovalRefused,
    DeviationSeen,
    ProposalSuperseded,
    RunHeld,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
)
from sitewright.central_controller.expectation import (
    contradictions,
    displaced,
    effects,
    unasked_changes,
)
from sitewright.central_controller.guard import Refused, may_start
from sitewright.central_controller.ports import FactsChanged, StillClear
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.sensed import differences
from sitewright.foundation.ids import CommandId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.motion import Certificate
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.robot_team.driver import Observation
from sitewright.robot_team.skill import SKILL_CLASS, SkillClass, SkillCommand

_NEEDS_PERSON = 3
_EXECUTION_FAILED = 8


def observed(run: Run) -> Generator[AnyEvent, None, Observation]:
    """Sense the site while nothing moves, and record what changed by itself."""
    now, site = run.cell.observe(), run.state.site
    deviations = changes(run, now)
    yield from deviations
    yield from displaced(site, now)
    if deviations or site.sensed is None:
        yield from differences(site.sensed, now)
    yield from held_if_grave(deviations)
    return now


def changes(
    run: Run, now: Observation, intent: SkillIntent | None = None
) -> tuple[DeviationSeen, ...]:
    """Return what nobody asked for, pieces that lie about left out."""
    before = run.state.site.sensed
    if before is None:
        return ()
    check = run.ports.check
    strays = check.strays(run.context(before)) & check.strays(run.context(now))
    return unasked_changes(run.state.site, now, intent=intent, strays=strays)


def start_step(run: Run, number: int) -> Iterator[AnyEvent]:
    """Check everything once more on the site as sensed, then write the intent."""
    if not run.has_room():
        reason = Sentence("The disk has too little space left to record what would happen.")
        yield RunHeld(reason=reason, exit_code=_EXECUTION_FAILED)
        return
    serial = run.state.site.serial
    now = yield from observed(run)
    if run.state.held is not None:
        return
    if run.state.site.serial != serial:
        yield superseded(run, Sentence("The site changed while nothing was to move."))
        return
    step = _step(run, number)
    granted = yield from gate(run, step, now)
    if granted is not None:
        approval_id, clear = granted
        keep_scenes(run, clear)
        yield _intent(run, step, approval_id, clear.certificates)


def gate(
    run: Run, step: ProposedStep, now: Observation, *, state: CycleState | None = None
) -> Generator[AnyEvent, None, tuple[str, StillClear] | None]:
    """Return approval and new certificates of a step that may start; record why it may not.

    Args:
        run: The open run.
        step: The step that wants to start.
        now: The site as sensed just now.
        state: What the guard looks at, if that is not the run's state.
    """
    ports, made = run.ports, run.state.proposal
    verdict = may_start(
        step,
        run.proposal(),
        state or run.state,
        now,
        key=ports.key,
        now_utc_ns=ports.clock.utc_ns(),
    )
    if isinstance(verdict, Refused):
        if verdict.needs_plan:
            yield superseded(run, verdict.reason)
            return None
        approval = run.state.approval
        yield ApprovalRefused(
            approval_id=approval.approval_id if approval is not None else "",
            fingerprint=made.fingerprint if made is not None else "",
            step=step.number,
            reason=verdict.reason,
        )
        return None
    match ports.check.check(step, run.context(now)):
        case StillClear() as clear:
            return verdict.approval.approval_id, clear
        case StaleCertificate(cause=cause):
            why = Sentence(
                "Step {step} is not clear any more: {pair:and} come too near.",
                step=step.number,
                pair=cause.pair,
            )
            yield superseded(run, why)
        case FactsChanged(facts=facts):
            why = Sentence(
                "Step {step} relies on what is not so: {fact}.", step=step.number, fact=facts[0]
            )
            yield superseded(run, why)
    return None


def keep_scenes(run: Run, clear: StillClear) -> None:
    """Write down the scenes of new certificates, before the journal names them."""
    for scene in clear.scenes:
        run.folder.keep_scene(scene)


def superseded(run: Run, reason: str, *, is_replan: bool = True) -> ProposalSuperseded:
    """Return the event that the open proposal has gone."""
    made = run.state.proposal
    return ProposalSuperseded(
        fingerprint=made.fingerprint if made is not None else "",
        reason=reason,
        is_replan=is_replan,
        at_utc_ns=run.ports.clock.utc_ns(),
    )


def execute(run: Run) -> Iterator[AnyEvent]:
    """Tell the driver, wait for the end, record the outcome."""
    intent = flight_of(run).intent
    step = _step(run, intent.step)
    command = SkillCommand(
        command_id=intent.command_id,
        epoch=run.state.epoch,
        skill=step.call.skill,
        robot=step.call.robot,
        trajectories=tuple(m.timed.trajectory for m in step.motions),
        params=step.params,
    )
    yield SkillOutcome(command_id=intent.command_id, report=run.cell.execute(command))


def sense(run: Run) -> Iterator[AnyEvent]:
    """Look at what an ended skill did; its step is closed by the last event."""
    flight, now = flight_of(run), run.cell.observe()
    intent, site = flight.intent, run.state.site
    is_done = flight.report is not None and flight.report.is_done
    by = "person" if flight.source == "person" else "sensed"
    denied = contradictions(intent, now) if is_done and by == "sensed" else ()
    if denied and SKILL_CLASS.get(intent.call.skill, SkillClass.ONCE) is SkillClass.ONCE:
        evidence = Sentence("reported as done, but {what}", what=denied[0].what)
        yield SkillReconciled(command_id=intent.command_id, verdict="unknown", evidence=evidence)
        return
    deviations = (*changes(run, now, intent), *denied)
    if is_done and not denied:
        yield from effects(intent, site, now, by=by)
    yield from displaced(run.state.site, now)
    if not flight.has_deviated:
        yield from deviations
    if deviations or not is_done:
        yield superseded(run, _why(flight, deviations))
    yield from differences(site.sensed, now, after=intent.command_id)
    yield from held_if_grave(deviations)


def flight_of(run: Run) -> Flight:
    """Return the skill that is under way."""
    if run.state.flight is None:
        raise LookupError("no skill is under way")
    return run.state.flight


def _why(flight: Flight, deviations: tuple[DeviationSeen, ...]) -> str:
    call = flight.intent.call
    if flight.report is not None and not flight.report.is_done:
        return Sentence(
            "{robot} could not {skill}: {why}.",
            robot=call.robot,
            skill=str(call.skill),
            why=flight.report.reason,
        )
    return Sentence(
        "After {skill} by {robot}: {subject} {what}.",
        skill=str(call.skill),
        robot=call.robot,
        subject=deviations[0].subject,
        what=deviations[0].what,
    )


def held_if_grave(deviations: tuple[DeviationSeen, ...]) -> Iterator[AnyEvent]:
    """Stop for a person if one of the deviations asks for it."""
    for deviation in deviations:
        if deviation.level >= _NEEDS_PERSON:
            reason = Sentence(
                "{subject} {what}. Look at the cell, then run again.",
                subject=deviation.subject,
                what=deviation.what,
            )
            yield RunHeld(reason=reason, exit_code=_EXECUTION_FAILED)
            return


def _step(run: Run, number: int) -> ProposedStep:
    return run.proposal().steps[number - 1]


def _intent(
    run: Run, step: ProposedStep, approval_id: str, certificates: tuple[Certificate, ...]
) -> SkillIntent:
    proposal, made = run.proposal(), run.state.proposal
    assert made is not None  # noqa: S101 -- the gate looked
    distances = [c.closest_distance_m for c in certificates]
    return SkillIntent(
        command_id=CommandId(run.ports.ids.new()),
        approval_id=approval_id,
        step=step.number,
        fingerprint=made.fingerprint,
        target=proposal.target,
        call=step.call,
        params=step.params,
        effects=step.effects,
        epoch=run.state.epoch,
        trajectories=tuple(m.timed.trajectory.sha256() for m in step.motions),
        certificates=len(certificates),
        confirmed=len([m for m in step.motions if m.agreement.samples > 0]),
        closest_distance_m=min(distances) if distances else None,
        scene_revision=certificates[-1].scene_revision if certificates else "",
        proofs=certificates,
    )
