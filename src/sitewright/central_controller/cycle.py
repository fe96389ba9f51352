"""The cycle as a pure step function: state and event in, new state and what to do next out.

Every decision is a function of the folded state, so that a restart decides exactly as the
controller that died would have.
"""

from __future__ import annotations

from dataclasses import replace

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
from sitewright.central_controller.cycle_state import CycleState, Flight, Phase
from sitewright.central_controller.decision import NEW_MOTION
from sitewright.central_controller.events import (
    AlternativeChosen,
    AlternativeRefused,
    AnyEvent,
    ApprovalGiven,
    ApprovalRefused,
    ApprovalRejected,
    DesignChanged,
    DeviationSeen,
    EpochOpened,
    LinkLost,
    ProposalMade,
    ProposalSuperseded,
    QuestionAnswered,
    QuestionAsked,
    RefusalMet,
    RunFinished,
    RunHeld,
    RunResumed,
    RunStarted,
    SiteObserved,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
    SkillReissued,
    TargetRefused,
    TargetSelected,
)
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.skill_fold import (
    after_skill_event,
    answered,
    closed,
    without_proposal,
)
from sitewright.central_controller.wishes import why_anew
from sitewright.foundation.sentence import Sentence

MAX_REPLANS_PER_TARGET = 3
MAX_REPLANS_IN_WINDOW = 5
REPLAN_WINDOW_NS = 600_000_000_000
MAX_LINK_LOSSES = 3


def advance(state: CycleState, event: AnyEvent) -> tuple[CycleState, tuple[Command, ...]]:
    """Return the state after an event, and what to do next; replay drops the commands."""
    after = folded(state, event)
    return after, (next_command(after),)


def next_command(state: CycleState) -> Command:  # noqa: PLR0911 -- one line per case
    """Return what a state asks for."""
    if state.finished is not None or state.held is not None:
        return Stop()
    if state.question is not None:
        return AskPerson(state.question)
    if state.link_losses > MAX_LINK_LOSSES:
        return HoldRun(
            Sentence("The cell was lost again and again: {why}", why=state.link_reason), 10
        )
    if state.epoch == 0:
        return Connect()
    if state.flight is not None:
        return _settle(state.flight)
    if state.wish is not None:
        return PlanSingle(state.wish)
    return _next_step(state) if state.proposal is not None else _next_plan(state)


def _settle(flight: Flight) -> Command:
    command_id = flight.intent.command_id
    match flight.phase:
        case Phase.STARTED:
            return Execute(command_id)
        case Phase.UNCERTAIN:
            return Reconcile(command_id)
        case Phase.NEVER:
            return Reissue(command_id)
        case Phase.UNKNOWN:
            return RaiseQuestion(command_id)
        case Phase.ENDED:
            return Sense(command_id)


def _next_step(state: CycleState) -> Command:
    step = state.done + 1
    if state.approval is not None and state.approval.scope.covers(step):
        return StartStep(step)
    return AskApproval(step)


def _next_plan(state: CycleState) -> Command:
    often = [t for t, n in state.replans.items() if n > MAX_REPLANS_PER_TARGET]
    if often:
        count = state.replans[often[0]]
        why = Sentence(
            "{target}: planned anew {count} times in vain.", target=often[0], count=count
        )
        return HoldRun(why, 8)
    times = state.replan_times_utc_ns[-MAX_REPLANS_IN_WINDOW - 1 :]
    if len(times) > MAX_REPLANS_IN_WINDOW and times[-1] - times[0] <= REPLAN_WINDOW_NS:
        return HoldRun(Sentence("Planned anew {count} times within 10 min.", count=len(times)), 8)
    if state.site.is_at_end:
        return FinishRun()
    return PlanNext(state.site.excluded)


def folded(  # noqa: PLR0911 -- one line per kind of event
    state: CycleState, event: AnyEvent
) -> CycleState:
    """Return the state after an event."""
    state = replace(state, site=site_after(state.site, event))
    match event:
        case RunStarted(run=run, hashes=hashes):
            known = state.model_sha256 or hashes.get("model", "")
            return CycleState(site=state.site, run=run, model_sha256=known)
        case RunResumed():
            return _uncertain(
                replace(state, held=None, replans={}, replan_times_utc_ns=(), link_losses=0)
            )
        case LinkLost(reason=reason):
            losses = state.link_losses + 1
            return _uncertain(replace(state, link_losses=losses, link_reason=reason))
        case EpochOpened(epoch=epoch):
            return replace(state, epoch=epoch)
        case RunHeld():
            return replace(state, held=event)
        case RunFinished():
            return replace(state, finished=event)
        case SkillIntent() | SkillOutcome() | SkillReconciled() | SkillReissued():
            return after_skill_event(state, event)
        case _:
            return _after_other_event(state, event)


def _uncertain(state: CycleState) -> CycleState:
    state = replace(state, epoch=0)
    if state.flight is not None and state.flight.phase is Phase.STARTED:
        return replace(state, flight=replace(state.flight, phase=Phase.UNCERTAIN))
    return state


def _after_other_event(  # noqa: C901, PLR0911, PLR0912 -- one line per kind of event
    state: CycleState, event: AnyEvent
) -> CycleState:
    match event:
        case ProposalMade():
            return replace(state, proposal=event, done=0, approval=None, wish=None)
        case ProposalSuperseded():
            return _superseded(state, event)
        case DesignChanged(model_sha256=digest):
            return _redesigned(state, digest)
        case ApprovalGiven(approval=approval):
            return replace(state, approval=approval, why="")
        case ApprovalRefused(reason=reason):
            return replace(state, approval=None, why=reason)
        case ApprovalRejected(who=who, rejection=rejection, decision=decision):
            rejected = state.rejected | {rejection.fingerprint}
            is_wish = decision is not None and decision.verb == NEW_MOTION
            why = why_anew(who, rejection, is_wish=is_wish)
            return replace(without_proposal(state), rejected=rejected, why=why)
        case AlternativeChosen(call=call):
            return replace(without_proposal(state), wish=call)
        case AlternativeRefused(reason=reason):
            return replace(state, wish=None, why=reason)
        case QuestionAsked(question=question):
            return replace(state, question=question)
        case QuestionAnswered(answer=answer):
            return answered(state, answer)
        case TargetSelected():
            return replace(state, refusals=())
        case RefusalMet(refusal=refusal):
            return replace(state, refusals=(*state.refusals, refusal))
        case TargetRefused(exit_code=code):
            return replace(state, refusal_codes=(*state.refusal_codes, code))
        case DeviationSeen(after=after) if state.flight is not None and after:
            return replace(state, flight=replace(state.flight, has_deviated=True))
        case SiteObserved(after=after) if after:
            return closed(state, after)
        case _:
            return state


def _superseded(state: CycleState, event: ProposalSuperseded) -> CycleState:
    if state.proposal is None or state.proposal.fingerprint != event.fingerprint:
        return state
    target = state.proposal.target
    state = replace(without_proposal(state), why=event.reason)
    if not event.is_replan:
        return state
    return replace(
        state,
        replans={**state.replans, target: state.replans.get(target, 0) + 1},
        replan_times_utc_ns=(*state.replan_times_utc_ns, event.at_utc_ns),
    )


def _redesigned(state: CycleState, digest: str) -> CycleState:
    """Let go of everything that was planned of the old design, whoever approved it."""
    state = replace(without_proposal(state), wish=None, refusals=(), refusal_codes=())
    return replace(state, model_sha256=digest, replans={}, why=Sentence("The design changed."))
