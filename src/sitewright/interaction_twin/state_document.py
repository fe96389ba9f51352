"""How a run stands now, as one small document for every page."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from sitewright.central_controller.commands import (
    AskApproval,
    AskPerson,
    PlanNext,
    PlanSingle,
    Stop,
)
from sitewright.central_controller.cycle import next_command
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import Question
from sitewright.foundation.canonical import Json
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.retelling import Telling, retold


class Phase(StrEnum):
    """What the run does, as people see it."""

    IDLE = "idle"
    PLANNING = "planning"
    WAITING = "waiting"
    RUNNING = "running"
    HOLDING = "holding"
    HELD = "held"
    QUESTION = "question"
    NEEDS_HELP = "needs-help"
    FINISHED = "finished"
    BROKEN = "broken"


@dataclass(frozen=True, slots=True, kw_only=True)
class Standing:
    """What the journal does not say: the process of the run.

    Attributes:
        is_active: It is inside a run; else it waits to be told to go.
        is_alive: The process is there.
        trouble: Why it broke off; empty if it did not.
        is_hold_asked: Somebody wants a hold that is not in the journal yet.
        started_at_ms: When the skill under way was started.
        asks: The plan with its next step, or the question, that it takes an answer to now.
    """

    is_active: bool
    is_alive: bool = True
    trouble: str = ""
    is_hold_asked: bool = False
    started_at_ms: int = 0
    asks: str = ""


def asked_plan(fingerprint: str, next_step: int) -> str:
    """Return what `Standing.asks` is while a plan waits for a decision about a step."""
    return f"{fingerprint} {next_step}"


def phase_of(state: CycleState, standing: Standing) -> Phase:  # noqa: C901, PLR0911 -- one line per case
    """Return the phase of a run."""
    if standing.trouble or not standing.is_alive:
        return Phase.BROKEN
    if not standing.is_active:
        return _resting(state)
    if standing.is_hold_asked:
        return Phase.HOLDING
    match next_command(state):
        case AskApproval() | AskPerson() if not _is_asked(state, standing):
            return Phase.PLANNING
        case AskApproval():
            return Phase.WAITING
        case AskPerson():
            return Phase.QUESTION
        case PlanNext() | PlanSingle():
            return Phase.PLANNING
        case Stop():
            return _resting(state)
        case _:
            return Phase.RUNNING if state.flight is not None or state.approval else Phase.PLANNING


def _is_asked(state: CycleState, standing: Standing) -> bool:
    """Tell whether an answer would be heard: the journal is written before anybody is asked."""
    if state.question is not None:
        return standing.asks == state.question.question_id
    made = state.proposal
    return made is not None and standing.asks == asked_plan(made.fingerprint, state.done + 1)


def _resting(state: CycleState) -> Phase:
    if state.question is not None:
        return Phase.QUESTION
    if state.site.is_complete and state.site.targets:
        return Phase.FINISHED
    if state.held is not None:
        return Phase.HELD
    if state.finished is not None or state.site.refused or state.site.needs_rework:
        return Phase.NEEDS_HELP
    return Phase.IDLE


def state_document(
    state: CycleState, standing: Standing, labels: Labels, book: Phrasebook = ENGLISH
) -> dict[str, Json]:
    """Return the document without what only the server knows (scene epoch, cell, last event)."""
    phase = phase_of(state, standing)
    site = state.site
    return {
        "type": "state",
        "phase": phase.value,
        "words": _words(phase, state, standing, Telling(labels, book)),
        "run": state.run,
        "open": _open(state),
        "running": _running(state, standing, labels, book),
        "question": _question(state, labels, book),
        "held": None
        if state.held is None
        else {"reason": retold(state.held.reason, labels, book), "exit_code": state.held.exit_code},
        "progress": {"installed": len(site.installed), "targets": len(site.targets)},
        "is_over": state.finished is not None and site.is_complete,
    }


def _words(  # noqa: PLR0911 -- one line per case
    phase: Phase, state: CycleState, standing: Standing, tell: Telling
) -> str:
    match phase:
        case Phase.BROKEN:
            return standing.trouble or tell(Sentence("The process of the run is not there."))
        case Phase.WAITING if state.proposal is not None:
            target, left = state.proposal.target, len(state.proposal.steps) - state.done
            if left == 1:
                return tell(Sentence("Waiting for you: 1 step for {target}", target=target))
            return tell(
                Sentence("Waiting for you: {steps} steps for {target}", steps=left, target=target)
            )
        case Phase.RUNNING if state.flight is not None:
            return narrate(state.flight.intent.call, tell.labels, tell.book)
        case Phase.HELD if state.held is not None:
            return tell(state.held.reason)
        case Phase.QUESTION if state.question is not None:
            return _question_text(state.question, tell.labels, tell.book)
        case _:
            return tell(_WORDS[phase])


_WORDS = {
    Phase.IDLE: Sentence("The run stands. Resume to go on."),
    Phase.PLANNING: Sentence("Planning the next target."),
    Phase.WAITING: Sentence("Waiting for you."),
    Phase.RUNNING: Sentence("Under way."),
    Phase.HOLDING: Sentence("A hold was asked for; the robots are coming to rest."),
    Phase.HELD: Sentence("Held."),
    Phase.QUESTION: Sentence("Only a person can say what happened."),
    Phase.NEEDS_HELP: Sentence("Some targets cannot be built now; a person is needed."),
    Phase.FINISHED: Sentence("Every component is installed."),
    Phase.BROKEN: Sentence("The run broke off."),
}


def _open(state: CycleState) -> Json:
    made = state.proposal
    if made is None:
        return None
    return {
        "fingerprint": made.fingerprint,
        "code": check_code(made.fingerprint),
        "target": made.target,
        "next_step": state.done + 1,
        "steps": len(made.steps),
        "is_single": made.is_single,
    }


def _running(state: CycleState, standing: Standing, labels: Labels, book: Phrasebook) -> Json:
    if state.flight is None:
        return None
    intent, made = state.flight.intent, state.proposal
    steps = () if made is None else made.steps
    planned = next((s.duration_s for s in steps if s.number == intent.step), 0.0)
    return {
        "step": intent.step,
        "fingerprint": intent.fingerprint,
        "robot": intent.call.robot,
        "words": narrate(intent.call, labels, book),
        "started_at_ms": standing.started_at_ms,
        "duration_s": planned,
    }


def _question(state: CycleState, labels: Labels, book: Phrasebook) -> Json:
    question = state.question
    if question is None:
        return None
    return {
        "question_id": question.question_id,
        "step": question.step,
        "target": question.target,
        "text": _question_text(question, labels, book),
        "answers": ["done", "not-done", "partial"],
    }


def _question_text(question: Question, labels: Labels, book: Phrasebook) -> str:
    text = Sentence(
        "Step {step} ({what}) was started and its end is not recorded. Look at the piece: is it "
        "done, not done, or done in part?",
        step=question.step,
        what=narrate(question.call, labels, book),
    )
    return retold(text, labels, book)
