"""What makes a decision acceptable, and what it is to the run: pure functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sitewright.central_controller.codec import to_json
from sitewright.central_controller.ports import (
    ApprovalAnswer,
    ApprovalRequest,
    Approve,
    ByHand,
    DrawZone,
    Mismatch,
    Reject,
    RemoveZone,
    ScopeKind,
)
from sitewright.central_controller.site_state import SiteState
from sitewright.central_controller.steering import hand_facts
from sitewright.foundation.canonical import canonical_json
from sitewright.foundation.ids import ComponentId, ZoneId
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.decisions import Decision, Reply, Signed, refusal
from sitewright.interaction_twin.policy import ApprovalPolicy
from sitewright.interaction_twin.roles import Role, Verb


@dataclass(frozen=True, slots=True, kw_only=True)
class Review:
    """What an approval is judged by.

    Attributes:
        policy: Rules of the project.
        authors: Who wished for what the open plan carries out.
        types: Type of each component of the design.
    """

    policy: ApprovalPolicy
    authors: frozenset[str] = frozenset()
    types: Mapping[ComponentId, str] = field(default_factory=dict)


def objection(signed: Signed, request: ApprovalRequest, review: Review) -> Reply | None:
    """Return why a decision about the open proposal cannot be taken; None if it can."""
    match signed.decision.verb:
        case Verb.APPROVE:
            return (
                _of_scope(signed, request)
                or _of_clearance(signed, request, review.policy)
                or _of_author(signed, review)
                or _of_first_ones(signed, request, review)
            )
        case Verb.REJECT | Verb.NEW_MOTION:
            return _of_step(signed.decision.step, request)
        case _:
            return site_objection(signed, request.site)


def site_objection(signed: Signed, site: SiteState) -> Reply | None:
    """Return why a decision about the site cannot be taken: no such zone, no such work."""
    if signed.decision.verb is Verb.MANUAL:
        return _of_hand_work(signed, site)
    name = signed.decision.remove_zone
    if name and name not in site.zones:
        message = Sentence("Nobody drew {zone}; it cannot be taken away.", zone=name)
        return refusal(422, "fields", message)
    return None


def sameness(decision: Decision) -> str:
    """Return what two people must agree on: all but keys, words and what was on the screen."""
    bare = replace(decision, key="", shown=(), language="", comment="", detail="", next_step=0)
    return canonical_json(to_json(bare))


def answer_of(signed: Signed, policy: ApprovalPolicy) -> ApprovalAnswer | None:
    """Return what a decision is to the run; None for another action, which is looked up first."""
    decision, who, record = signed.decision, signed.person.who, signed.record()
    match decision.verb:
        case Verb.APPROVE:
            return Approve(
                fingerprint=decision.fingerprint,
                who=who,
                scope=decision.scope,
                comment=decision.comment,
                decision=record,
                start_within_s=policy.max_unstarted_s,
            )
        case Verb.REJECT | Verb.NEW_MOTION:
            is_motion = decision.verb is Verb.NEW_MOTION
            return Reject(
                who=who,
                reason="path-unsafe" if is_motion else decision.reason,
                detail=decision.detail,
                step=decision.step,
                decision=record,
            )
        case Verb.MISMATCH:
            return Mismatch(
                who=who, component=decision.component, detail=decision.detail, decision=record
            )
        case Verb.MANUAL | Verb.ZONE:
            return site_wish(signed)
        case _:
            return None


def site_wish(signed: Signed) -> DrawZone | RemoveZone | ByHand:
    """Return what a decision about a zone or about work by hand wants."""
    decision, who, record = signed.decision, signed.person.who, signed.record()
    if decision.verb is Verb.MANUAL:
        target = ComponentId(decision.target)
        return ByHand(who=who, target=target, effects=decision.effects, decision=record)
    if decision.zone is None:
        return RemoveZone(who=who, zone=ZoneId(decision.remove_zone), decision=record)
    return DrawZone(
        who=who,
        size_m=decision.zone.size_m,
        world_T_zone=decision.zone.world_T_zone,
        decision=record,
    )


def _of_step(step: int, request: ApprovalRequest) -> Reply | None:
    last = len(request.proposal.steps)
    if step <= last:
        return None
    return refusal(
        422,
        "fields",
        Sentence("The plan has steps 1 to {last}; there is no step {step}.", last=last, step=step),
    )


def _of_scope(signed: Signed, request: ApprovalRequest) -> Reply | None:
    scope = signed.decision.scope
    unknown = _of_step(scope.step, request)
    if unknown is not None or scope.covers(request.next_step):
        return unknown
    message = Sentence(
        "That part of the plan is not open; step {step} is next, the ones before are done.",
        step=request.next_step,
    )
    return refusal(409, "decided", message, next_step=request.next_step)


def _of_clearance(signed: Signed, request: ApprovalRequest, policy: ApprovalPolicy) -> Reply | None:
    if signed.person.role.may(Role.SUPERVISOR):
        return None
    scope, limit_m = signed.decision.scope, policy.supervisor_below_m
    for step in request.proposal.steps:
        closest_m = step.closest_distance_m
        is_asked = step.number >= request.next_step and scope.covers(step.number)
        if is_asked and closest_m is not None and closest_m < limit_m:
            message = Sentence(
                "Only a supervisor may approve step {step}: clearance {gap_mm:.0f} mm is under the "
                "policy's {least_mm:.0f} mm.",
                step=step.number,
                gap_mm=closest_m * 1000.0,
                least_mm=limit_m * 1000.0,
            )
            return refusal(403, "role", message, needs=Role.SUPERVISOR.value, step=step.number)
    return None


def _of_author(signed: Signed, review: Review) -> Reply | None:
    who = signed.person.who
    if not review.policy.prevent_self_review or who not in review.authors:
        return None
    message = Sentence(
        "{who} asked for what this plan does; another person must approve it.", who=who
    )
    return refusal(403, "self-review", message, authors=sorted(review.authors))


def _of_first_ones(signed: Signed, request: ApprovalRequest, review: Review) -> Reply | None:
    """The first components of a type are approved one step at a time."""
    wanted = review.policy.step_by_step_first_n_of_type
    kind = review.types.get(request.proposal.target, "")
    built = sum(review.types.get(t) == kind for t in request.site.installed)
    if signed.decision.scope.kind is ScopeKind.STEP or built >= wanted:
        return None
    message = Sentence(
        "The first {wanted} of type {kind} are approved step by step ({built} are built); "
        "approve step {step} by itself.",
        wanted=wanted,
        kind=kind,
        built=built,
        step=request.next_step,
    )
    return refusal(403, "step-by-step", message, next_step=request.next_step)


def _of_hand_work(signed: Signed, site: SiteState) -> Reply | None:
    decision = signed.decision
    possible = hand_facts(site).get(ComponentId(decision.target), ())
    wrong = [e for e in decision.effects if e not in possible]
    if not wrong:
        return None
    message = Sentence(
        "{fact} cannot be vouched for: the piece of {target} must be sensed in place, and the "
        "work must be open.",
        fact=wrong[0],
        target=decision.target,
    )
    return refusal(422, "fields", message, possible=list(possible))
