"""After a crash of controller or cell: what became of the command that has no outcome?"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sitewright.app.runner import Run
from sitewright.app.runner_steps import (
    changes,
    flight_of,
    gate,
    held_if_grave,
    keep_scenes,
    observed,
    superseded,
)
from sitewright.central_controller.cycle_state import CycleState, Flight
from sitewright.central_controller.events import (
    AnyEvent,
    QuestionAnswered,
    QuestionAsked,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
    SkillReissued,
)
from sitewright.central_controller.expectation import settled_by_sensors
from sitewright.central_controller.ports import Question
from sitewright.central_controller.sensed import differences
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.driver import CommandState, CommandStatus, SkillReport
from sitewright.robot_team.skill import SKILL_CLASS, SkillClass

_LOOK_AGAIN_S = 0.2


def reconcile(run: Run) -> Iterator[AnyEvent]:
    """Ask the ledger, then the sensors, and say honestly if neither knows.

    The connection has opened a new epoch before, so that a late start of the same command
    cannot come after the ledger said "never".
    """
    intent = flight_of(run).intent
    status = _ended_status(run, intent)
    match status.state, status.report:
        case CommandState.ENDED, SkillReport() as report:
            yield SkillOutcome(command_id=intent.command_id, report=report, source="ledger")
        case CommandState.NEVER, _:
            yield SkillReconciled(
                command_id=intent.command_id,
                verdict="never",
                evidence=Sentence("the cell's ledger does not know it"),
            )
        case _:
            yield from _by_class(run, intent)


def _ended_status(run: Run, intent: SkillIntent) -> CommandStatus:
    """Return what the ledger knows, after waiting for a command that is still under way."""
    while True:
        status = run.cell.status(intent.command_id)
        if status.state is not CommandState.RUNNING:
            return status
        run.ports.pause(_LOOK_AGAIN_S)


def _by_class(run: Run, intent: SkillIntent) -> Iterator[AnyEvent]:
    """Settle a command that was accepted and has no end, by what kind of skill it is."""
    match SKILL_CLASS.get(intent.call.skill, SkillClass.ONCE):
        case SkillClass.ONCE:
            yield from _seen_after(run, intent)
            yield SkillReconciled(
                command_id=intent.command_id,
                verdict="unknown",
                evidence=Sentence("accepted by the cell, its end is not recorded"),
            )
        case SkillClass.SENSABLE:
            yield from _by_sensors(run, intent)
        case SkillClass.ABSOLUTE:
            yield from _not_done(
                run, intent, Sentence("planned anew from where the robot is sensed")
            )


def _by_sensors(run: Run, intent: SkillIntent) -> Iterator[AnyEvent]:
    if settled_by_sensors(intent, run.cell.observe()):
        report = SkillReport(is_done=True, evidence={"by": "sensors after a restart"})
        yield SkillOutcome(command_id=intent.command_id, report=report, source="sensors")
    else:
        yield from _not_done(run, intent, Sentence("the sensors do not show its effect"))


def _not_done(run: Run, intent: SkillIntent, evidence: str) -> Iterator[AnyEvent]:
    """Record where things are now, then let the plan go: the next one starts from there."""
    yield superseded(
        run, Sentence("{skill} was interrupted.", skill=str(intent.call.skill)), is_replan=False
    )
    yield from _seen_after(run, intent)
    yield SkillReconciled(command_id=intent.command_id, verdict="not-done", evidence=evidence)


def _seen_after(run: Run, intent: SkillIntent) -> Iterator[AnyEvent]:
    """Record how the site is found after an interruption, and what nobody asked for."""
    now, before = run.cell.observe(), run.state.site.sensed
    deviations = changes(run, now, intent)
    yield from deviations
    yield from differences(before, now)
    yield from held_if_grave(deviations)


def reissue(run: Run) -> Iterator[AnyEvent]:
    """Let the same command go out again: the ledger knows for certain that it never started.

    The gate is passed anew, under the same approval if that has not expired.
    """
    flight = flight_of(run)
    intent = flight.intent
    now = yield from observed(run)
    granted = None
    if run.state.held is None and run.state.proposal is not None:
        step = run.proposal().steps[intent.step - 1]
        granted = yield from gate(run, step, now, state=_before(run.state, flight))
    if granted is not None:
        _, clear = granted
        keep_scenes(run, clear)
        yield SkillReissued(
            command_id=intent.command_id, epoch=run.state.epoch, proofs=clear.certificates
        )
    else:
        yield SkillReconciled(
            command_id=intent.command_id,
            verdict="not-done",
            evidence=Sentence("it never started and may not start now"),
        )


def _before(state: CycleState, flight: Flight) -> CycleState:
    """Return the state as it was when the command had not been started."""
    used = (flight.intent.approval_id, flight.intent.step)
    return replace(state, flight=None, started=state.started - {used})


def raise_question(run: Run) -> Iterator[AnyEvent]:
    """Put an unknown outcome to a person."""
    intent = flight_of(run).intent
    call = intent.call
    what = f"{call.skill} {' '.join(call.arguments)}".rstrip()
    text = (
        f"Step {intent.step} ({what} by {call.robot}) was started and its end is not recorded. "
        "Look at the piece: is it done, not-done or partial? Answer with "
        f"`sitewright resolve {run.state.run} {intent.step} done|not-done|partial`."
    )
    yield QuestionAsked(
        question=Question(
            question_id=run.ports.ids.new(),
            run=run.state.run,
            step=intent.step,
            command_id=intent.command_id,
            call=call,
            target=intent.target,
            text=text,
        )
    )


def ask_person(run: Run, question: Question) -> Iterator[AnyEvent]:
    """Ask whoever is there; without an answer the question stays open and the run stops."""
    settled = run.ports.approver.answer(question)
    if settled is not None:
        yield QuestionAnswered(
            question_id=question.question_id,
            answer=settled.answer,
            who=settled.who,
            decision=settled.decision,
        )


def held_before_start(run: Run) -> Iterator[AnyEvent]:
    """Let go of a skill that is written down but not told to the cell: somebody wants a hold."""
    yield from _not_done(run, flight_of(run).intent, Sentence("held before the cell was told"))
