"""What planning a target comes to, as a proposal for people or as a question to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.central_controller.ports import (
    CounterProposal,
    Escalation,
    Planned,
    RefusalNote,
    SiteContext,
)
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.target_outcome import TargetPlan, TargetRefusal
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.sequence import PlannedSequence, SequenceRefusal
from sitewright.planning_twin.wording import in_words, is_proof
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.reasons import effects, relies_on

WITH_HELPS = "{reason} Tried on a copy, and it works: {tried:or}."
"""Template of a reason that ends with what works."""
_NO_PLAN_PROVEN, _LIMIT, _NO_MOTION = 4, 5, 6


def proposal_of(
    context: SiteContext,
    target: ComponentId,
    steps: tuple[ProposedStep, ...],
    identity: Mapping[str, str],
) -> Proposal:
    """Return the proposal of some steps.

    Args:
        context: The site that it starts from.
        target: What it builds.
        steps: In order.
        identity: Hashes of team, cell, model and domain.
    """
    return Proposal(
        run=context.run,
        target=target,
        steps=steps,
        site_serial=context.site.serial,
        context=dict(identity),
    )


def steps_of(plan: TargetPlan) -> tuple[ProposedStep, ...]:
    """Return the steps of all parts of a plan, numbered from 1."""
    parts = (proposed_steps(p.problem, p.motions) for p in plan.parts)
    steps = (step for part in parts for step in part)
    return tuple(replace(s, number=n) for n, s in enumerate(steps, start=1))


def proposed_steps(problem: Problem, motions: PlannedSequence) -> tuple[ProposedStep, ...]:
    """Return calls with their certified motions as steps, numbered from 1.

    Args:
        problem: Says what each step relies on and changes.
        motions: The calls and their motions.
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
    return tuple(steps)


def planned(
    proposal: Proposal,
    plan: TargetPlan,
    timing_s: Mapping[str, float],
    wanted: ComponentId,
) -> Planned:
    """Return a proposal with the texts that it came from.

    Args:
        proposal: What is asked for.
        plan: What it was made of.
        timing_s: Where the time went.
        wanted: The target that came first; if the plan builds another one, it waits for that.
    """
    return Planned(
        waits=() if plan.target == wanted else (wanted,),
        proposal=proposal,
        attachments=_texts(plan),
        refusals=tuple(dict.fromkeys(plan.notes)),
        timing_s=timing_s,
    )


def _texts(plan: TargetPlan) -> dict[str, str]:
    """Return domain, problem and plan; the problems of errands are numbered before them."""
    *errands, last = plan.parts
    texts = {"domain": last.problem.domain.text}
    for number, part in enumerate(errands, start=1):
        texts[f"errand-{number}.problem"] = part.problem.text
        texts[f"errand-{number}.plan"] = part.sequence.text
    return {**texts, "problem": last.problem.text, "plan": last.sequence.text}


def escalation(
    target: ComponentId,
    refused: TargetRefusal,
    timing_s: Mapping[str, float],
    helps: tuple[CounterProposal, ...] = (),
) -> Escalation:
    """Return what a person is told when neither planner goes on.

    Args:
        target: What has no plan.
        refused: Why.
        timing_s: Where the time went.
        helps: Changes with which it has one.
    """
    tried = tuple(Sentence("{words} ({steps} steps)", words=h.words, steps=h.steps) for h in helps)
    code = _NO_PLAN_PROVEN if refused.is_proven else _NO_MOTION
    return Escalation(
        target=target,
        reason=Sentence(WITH_HELPS, reason=refused.reason, tried=tried)
        if tried
        else refused.reason,
        is_proven=refused.is_proven,
        exit_code=_LIMIT if refused.is_limit else code,
        attachments={"domain": refused.problem.domain.text, "problem": refused.problem.text},
        refusals=tuple(dict.fromkeys(refused.notes)),
        timing_s=timing_s,
        blockers=refused.blockers,
        counter_proposals=helps,
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
