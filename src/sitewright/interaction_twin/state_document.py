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
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted
from sitewright.interaction_twin.narration import narrate


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


def state_document(state: CycleState, standing: Standing, labels: Labels) -> dict[str, Json]:
    """Return the document without what only the server knows (scene epoch, cell, last event)."""
    phase = phase_of(state, standing)
    site = state.site
    return {
        "type": "state",
        "phase": phase.value,
        "words": _words(phase, state, standing, labels),
        "run": state.run,
        "open": _open(state),
        "running": _running(state, standing, labels),
        "question": _question(state, labels),
        "held": None
        if state.held is None
        else {"reason": labels.told(state.held.reason), "exit_code": state.held.exit_code},
        "progress": {"installed": len(site.installed), "targets": len(site.targets)},
        "is_over": state.finished is not None and site.is_complete,
    }


def _words(phase: Phase, state: CycleState, standing: Standing, labels: Labels) -> str:
    match phase:
        case Phase.BROKEN:
            return standing.trouble or "The process of the run is not there."
        case Phase.WAITING if state.proposal is not None:
            steps = counted(len(state.proposal.steps) - state.done, "step")
            return f"Waiting for you: {steps} for {labels.name(state.proposal.target)}"
        case Phase.RUNNING if state.flight is not None:
            return narrate(state.flight.intent.call, labels)
        case Phase.HELD if state.held is not None:
            return labels.told(state.held.reason)
        case Phase.QUESTION if state.question is not None:
            return labels.told(state.question.text)
        case _:
            return _WORDS[phase]


_WORDS = {
    Phase.IDLE: "The run stands. Resume to go on.",
    Phase.PLANNING: "Planning the next target.",
    Phase.WAITING: "Waiting for you.",
    Phase.RUNNING: "Under way.",
    Phase.HOLDING: "A hold was asked for; the robots are coming to rest.",
    Phase.HELD: "Held.",
    Phase.QUESTION: "Only a person can say what happened.",
    Phase.NEEDS_HELP: "Some targets cannot be built now; a person is needed.",
    Phase.FINISHED: "Every component is installed.",
    Phase.BROKEN: "The run broke off.",
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


def _running(state: CycleState, standing: Standing, labels: Labels) -> Json:
    if state.flight is None:
        return None
    intent, made = state.flight.intent, state.proposal
    steps = () if made is None else made.steps
    planned = next((s.duration_s for s in steps if s.number == intent.step), 0.0)
    return {
        "step": intent.step,
        "fingerprint": intent.fingerprint,
        "robot": intent.call.robot,
        "words": narrate(intent.call, labels),
        "started_at_ms": standing.started_at_ms,
        "duration_s": planned,
    }


def _question(state: CycleState, labels: Labels) -> Json:
    question = state.question
    if question is None:
        return None
    return {
        "question_id": question.question_id,
        "step": question.step,
        "target": question.target,
        "text": labels.told(question.text),
        "answers": ["done", "not-done", "partial"],
    }
