"""The approval command: show the open proposal, seal the answer."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.app.runner import Run
from sitewright.central_controller.approval import Approval, sealed
from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ApprovalRefused,
    ApprovalRejected,
    ProposalSuperseded,
    RunHeld,
    TargetRefused,
)
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import (
    Alternative,
    ApprovalRequest,
    Approve,
    ByHand,
    DoInstead,
    DrawZone,
    Hold,
    Mismatch,
    Reject,
    RemoveZone,
)
from sitewright.central_controller.site_state import Rejection
from sitewright.central_controller.steering import HELD_BY_PERSON, Steering, steered
from sitewright.foundation.sentence import Sentence


def ask_approval(run: Run, step: int) -> Iterator[AnyEvent]:
    """Ask for an approval that covers `step` of the open proposal."""
    request = _request(run, step)
    answer = run.ports.approver.ask(request)
    match answer:
        case Approve():
            yield from _approved(run, request, answer)
        case Reject():
            yield from _rejected(request, answer)
        case DoInstead(who=who, call=call, decision=decision):
            yield AlternativeChosen(
                who=who, fingerprint=request.fingerprint, call=call, decision=decision
            )
        case Hold():
            yield held_by(answer)
        case Mismatch() | DrawZone() | RemoveZone() | ByHand():
            yield from _steered(run, answer)


def _steered(run: Run, wish: Steering) -> Iterator[AnyEvent]:
    """Record what a person changed beside the plan; the plan goes before anything moves."""
    why, events = steered(run.state.site, wish)
    made = run.state.proposal
    assert made is not None  # noqa: S101 -- the cycle asks only for an open proposal
    first, *rest = events
    yield first
    yield ProposalSuperseded(
        fingerprint=made.fingerprint,
        reason=why,
        is_replan=False,
        at_utc_ns=run.ports.clock.utc_ns(),
    )
    yield from rest


def held_by(hold: Hold) -> RunHeld:
    """Return the event by which a run stands because somebody wants it to."""
    return RunHeld(
        reason=Sentence("{who} holds the run: {why}", who=hold.who, why=hold.reason)
        if hold.reason
        else Sentence("{who} holds the run.", who=hold.who),
        exit_code=HELD_BY_PERSON,
        who=hold.who,
        decision=hold.decision,
    )


def _request(run: Run, step: int) -> ApprovalRequest:
    made, proposal = run.state.proposal, run.proposal()
    assert made is not None  # noqa: S101 -- the cycle asks only for an open proposal

    def alternatives() -> tuple[Alternative, ...]:
        return run.ports.planner.alternatives(run.context(run.cell.observe()))

    return ApprovalRequest(
        proposal=proposal,
        fingerprint=made.fingerprint,
        code=check_code(made.fingerprint),
        next_step=step,
        is_single=made.is_single,
        alternatives=alternatives,
        refusals=run.state.refusals,
        why=run.state.why,
        site=run.state.site,
    )


def _approved(run: Run, request: ApprovalRequest, answer: Approve) -> Iterator[AnyEvent]:
    approval_id, now = run.ports.ids.new(), run.ports.clock.utc_ns()
    problem = ""
    if answer.fingerprint != request.fingerprint:
        shown, open_ = check_code(answer.fingerprint), request.code
        problem = Sentence(
            "The answer is about plan {shown}; the open one is {open}.", shown=shown, open=open_
        )
    elif not answer.scope.covers(request.next_step):
        problem = Sentence("The answer does not cover step {step}.", step=request.next_step)
    if problem:
        yield ApprovalRefused(
            approval_id=approval_id,
            fingerprint=answer.fingerprint,
            step=request.next_step,
            reason=problem,
        )
        yield RunHeld(reason=problem, exit_code=HELD_BY_PERSON)
        return
    approval = Approval(
        approval_id=approval_id,
        fingerprint=request.fingerprint,
        scope=answer.scope,
        who=answer.who,
        given_utc_ns=now,
        start_before_utc_ns=now + round(answer.start_within_s * 1e9),
        nonce=run.ports.ids.new(),
        comment=answer.comment,
    )
    yield ApprovalGiven(approval=sealed(approval, run.ports.key), decision=answer.decision)


def _rejected(request: ApprovalRequest, answer: Reject) -> Iterator[AnyEvent]:
    proposal = request.proposal
    left = [s for s in proposal.steps if s.number >= request.next_step]
    calls = [s.call for s in left if answer.step in (0, s.number)]
    yield ApprovalRejected(
        who=answer.who,
        rejection=Rejection(
            fingerprint=request.fingerprint,
            target=proposal.target,
            reason=answer.reason,
            detail=answer.detail,
            step=answer.step,
            calls=tuple(calls),
        ),
        decision=answer.decision,
    )
    if answer.reason == "later":
        yield TargetRefused(
            target=proposal.target,
            reason=Sentence("{who} put it off: {why}", who=answer.who, why=answer.detail)
            if answer.detail
            else Sentence("{who} put it off", who=answer.who),
            is_proven=False,
            exit_code=HELD_BY_PERSON,
        )
