"""What planning a target comes to, as a proposal for people or as a question to them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sitewright.central_controller.ports import Escalation, Planned, RefusalNote, SiteContext
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.target_planning import TargetPlan, TargetRefusal
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal
from sitewright.planning_twin.wording import in_words, is_proof
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.reasons import effects, relies_on

_NO_PLAN_PROVEN, _LIMIT, _NO_MOTION = 4, 5, 6


def proposal_of(
    context: SiteContext,
    target: ComponentId,
    problem: Problem,
    motions: PlannedSequence,
    identity: Mapping[str, str],
) -> Proposal:
    """Return the proposal of a sequence with its motions.

    Args:
        context: The site that it starts from.
        target: What it builds.
        problem: Says what each step relies on and changes.
        motions: The calls and their certified motions.
        identity: Hashes of team, cell, model and domain.
    """
    steps: list[ProposedStep] = []
    for call, skill in zip(motions.calls, motions.skills, strict=True):
        action = problem.action(call)
        contacts = skill.declared_contacts()
        steps.append(
            ProposedStep(
                number=len(steps) + 1,
                call=call,
                params={**skill.params, "contacts": [list(c) for c in contacts]},
                motions=skill.motions,
                duration_s=skill.act_s + sum(m.timed.trajectory.duration_s for m in skill.motions),
                relies_on=() if action is None else relies_on(problem, action),
                effects=() if action is None else effects(problem, action),
                contacts=contacts,
            )
        )
    return Proposal(
        run=context.run,
        target=target,
        steps=tuple(steps),
        site_serial=context.site.serial,
        context=dict(identity),
    )


def planned(
    proposal: Proposal,
    plan: TargetPlan,
    notes: Sequence[RefusalNote],
    timing_s: Mapping[str, float],
) -> Planned:
    """Return a proposal with the texts that it came from."""
    return Planned(
        proposal=proposal,
        attachments={
            "domain": plan.problem.domain.text,
            "problem": plan.problem.text,
            "plan": plan.sequence.text,
        },
        refusals=tuple(dict.fromkeys(notes)),
        timing_s=timing_s,
    )


def escalation(
    target: ComponentId,
    refused: TargetRefusal,
    notes: Sequence[RefusalNote],
    timing_s: Mapping[str, float],
) -> Escalation:
    """Return what a person is told when neither planner goes on."""
    code = _NO_PLAN_PROVEN if refused.is_proven else _NO_MOTION
    return Escalation(
        target=target,
        reason=refused.reason,
        is_proven=refused.is_proven,
        exit_code=_LIMIT if refused.is_limit else code,
        attachments={"domain": refused.problem.domain.text, "problem": refused.problem.text},
        refusals=tuple(dict.fromkeys(notes)),
        timing_s=timing_s,
    )


def single_refused(
    target: ComponentId, refused: SequenceRefusal, timing_s: Mapping[str, float]
) -> Escalation:
    """Return why a chosen action has no motion."""
    refusal = refused.cause.refusal
    note = RefusalNote(
        target=target,
        kind=type(refusal).__name__,
        reason=in_words(refusal),
        is_proven=is_proof(refusal),
    )
    return Escalation(
        target=target, reason=note.reason, is_proven=False, refusals=(note,), timing_s=timing_s
    )


def standing_on_nothing(target: ComponentId, reason: str) -> Escalation:
    """Return the refusal of a target that nothing would carry."""
    note = RefusalNote(target=target, kind="Unsupported", reason=reason, is_proven=True)
    return Escalation(target=target, reason=reason, is_proven=True, refusals=(note,))
