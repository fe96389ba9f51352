"""What the runner does for each command of the cycle; every outcome is an event."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.app.recovery import (
    ask_person,
    held_before_start,
    raise_question,
    reconcile,
    reissue,
)
from sitewright.app.runner import Run
from sitewright.app.runner_approval import ask_approval, held_by
from sitewright.app.runner_planning import finished, plan_next, plan_single
from sitewright.app.runner_steps import execute, sense, start_step
from sitewright.central_controller.commands import (
    AskApproval,
    AskPerson,
    Command,
    Connect,
    Execute,
    FinishRun,
    HoldRun,
    PlanNext,
    PlanSingle,
    RaiseQuestion,
    Reconcile,
    Reissue,
    Sense,
    StartStep,
    Stop,
)
from sitewright.central_controller.events import (
    AnyEvent,
    EpochOpened,
    RunHeld,
)


def perform(  # noqa: C901, PLR0912, PLR0915 -- one line per command
    run: Run, command: Command
) -> Iterator[AnyEvent]:
    """Do one command and return what happened; the caller records each event at once.

    Somebody who wants the run held comes first, unless a skill is under way: that one is stopped
    by the cell itself and ends before.
    """
    hold = run.ports.hold_asked()
    match command:
        case Execute() if hold is not None:
            yield from held_before_start(run)
        case _ if hold is not None and run.state.flight is None:
            yield held_by(hold)
        case Connect():
            yield EpochOpened(epoch=run.connect().new_epoch())
        case PlanNext(exclude=exclude):
            yield from plan_next(run, exclude)
        case PlanSingle(call=call):
            yield from plan_single(run, call)
        case AskApproval(step=step):
            yield from ask_approval(run, step)
        case StartStep(step=step):
            yield from start_step(run, step)
        case Execute():
            yield from execute(run)
        case Sense():
            yield from sense(run)
        case Reconcile():
            yield from reconcile(run)
        case Reissue():
            yield from reissue(run)
        case RaiseQuestion():
            yield from raise_question(run)
        case AskPerson(question=question):
            yield from ask_person(run, question)
        case HoldRun(reason=reason, exit_code=code):
            if run.is_connected:
                run.cell.hold()
            yield RunHeld(reason=reason, exit_code=code)
        case FinishRun():
            yield finished(run)
        case Stop():
            return
