"""Planning commands: from the site as sensed to a proposal in the run folder."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from sitewright.app.runner import Run
from sitewright.app.runner_steps import observed
from sitewright.central_controller.events import (
    AlternativeRefused,
    AnyEvent,
    ProposalMade,
    RefusalMet,
    RunFinished,
    RunHeld,
    StepSummary,
    TargetRefused,
    TargetSelected,
    TargetWaits,
)
from sitewright.central_controller.fingerprint import fingerprint
from sitewright.central_controller.ports import (
    Escalation,
    NothingToDo,
    Planned,
    ProposalOutcome,
    SiteContext,
)
from sitewright.central_controller.proposal import Proposal
from sitewright.foundation.canonical import canonical_json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.journal.blobs import write_whole
from sitewright.robot_team.skill import Skill, SkillCall

_APPROVAL = 7
_MOST_AGAIN = 2
"""So often the planner is asked for other motions than those of a plan that was rejected."""
_MOST_FIGURES_BYTES = 32_768
_EFFECT_OF: Mapping[str, str] = {
    Skill.POSITION: "(in-place ",
    Skill.RELEASE: "(standing ",
    Skill.FASTEN: "(fastened ",
    Skill.APPLY_FINISH: "(finished ",
}


def plan_next(run: Run, exclude: frozenset[ComponentId]) -> Iterator[AnyEvent]:
    """Look at the site and ask the planner for the front target's proposal."""
    seen = yield from observed(run)
    if run.state.held is not None:
        return
    outcome = _other_than_rejected(run, run.context(seen), exclude)
    match outcome:
        case Planned():
            until = outcome.proposal.target
            yield from (TargetWaits(target=t, until=until) for t in outcome.waits)
            yield TargetSelected(target=outcome.proposal.target)
            yield from _proposed(run, outcome, is_single=False)
        case Escalation():
            run.folder.save_texts(outcome.target, outcome.attachments)
            yield from (RefusalMet(refusal=r) for r in outcome.refusals)
            yield TargetRefused(
                target=outcome.target,
                reason=outcome.reason,
                is_proven=outcome.is_proven,
                exit_code=outcome.exit_code,
                timing_s=outcome.timing_s,
                blockers=outcome.blockers,
                counter_proposals=outcome.counter_proposals,
            )
        case NothingToDo():
            yield finished(run)


def _other_than_rejected(
    run: Run, context: SiteContext, exclude: frozenset[ComponentId]
) -> ProposalOutcome:
    """Return a plan that nobody rejected; a target without one is for a person."""
    outcome = run.ports.planner.propose(context, exclude=exclude)
    for again in range(1, _MOST_AGAIN + 1):
        if not _is_rejected(run, outcome):
            return outcome
        outcome = run.ports.planner.propose(replace(context, again=again), exclude=exclude)
    if not isinstance(outcome, Planned) or not _is_rejected(run, outcome):
        return outcome
    target = outcome.proposal.target
    reason = Sentence("{target}: its plan was rejected, and no other one was found.", target=target)
    return Escalation(target=target, reason=reason, is_proven=False, exit_code=_APPROVAL)


def _is_rejected(run: Run, outcome: ProposalOutcome) -> bool:
    if not isinstance(outcome, Planned):
        return False
    return fingerprint(outcome.proposal) in run.state.rejected


def plan_single(run: Run, call: SkillCall) -> Iterator[AnyEvent]:
    """Plan the one action that a person chose."""
    seen = yield from observed(run)
    if run.state.held is not None:
        return
    outcome = run.ports.planner.propose_single(run.context(seen), call)
    match outcome:
        case Planned():
            yield from _proposed(run, outcome, is_single=True)
        case Escalation(reason=reason):
            yield from (RefusalMet(refusal=r) for r in outcome.refusals)
            yield AlternativeRefused(call=call, reason=reason)
        case NothingToDo():
            yield AlternativeRefused(call=call, reason=Sentence("This action is not feasible now."))


def finished(run: Run) -> RunFinished:
    """Return the last event of a run, with what the cell tells at its end."""
    figures = run.cell.ask(run.ports.final_figures)
    text = canonical_json(figures)
    if len(text.encode()) > _MOST_FIGURES_BYTES:
        write_whole(run.folder.path / "cell_figures.json", text.encode())
        figures = {"file": "cell_figures.json"}
    return RunFinished(is_complete=run.state.site.is_complete, extra=figures)


def _proposed(run: Run, planned: Planned, *, is_single: bool) -> Iterator[AnyEvent]:
    proposal = planned.proposal
    _check(run, proposal)
    yield from (RefusalMet(refusal=r) for r in planned.refusals)
    run.folder.save_texts(proposal.target, planned.attachments)
    digest = run.keep(proposal)
    if digest in run.state.rejected:
        reason = Sentence("The planner has no other plan than the one that was rejected.")
        yield RunHeld(reason=reason, exit_code=_APPROVAL)
        return
    yield ProposalMade(
        fingerprint=digest,
        target=proposal.target,
        site_serial=proposal.site_serial,
        is_single=is_single,
        timing_s=planned.timing_s,
        steps=tuple(
            StepSummary(
                number=step.number,
                call=step.call,
                duration_s=step.duration_s,
                trajectories=len(step.motions),
                closest_distance_m=step.closest_distance_m,
            )
            for step in proposal.steps
        ),
    )


def _check(run: Run, proposal: Proposal) -> None:
    """Refuse a proposal that the run could not follow; a planner that makes one has a bug."""
    numbers = [step.number for step in proposal.steps]
    if not numbers or numbers != list(range(1, len(numbers) + 1)):
        raise ValueError(f"proposal for {proposal.target} numbers its steps {numbers}")
    if (proposal.run, proposal.site_serial) != (run.state.run, run.state.site.serial):
        raise ValueError(f"proposal for {proposal.target} is not about the site as it is")
    for step in proposal.steps:
        effect = _EFFECT_OF.get(step.call.skill)
        if effect and not any(text.startswith(effect) for text in step.effects):
            raise ValueError(f"step {step.number} ({step.call.skill}) lacks the effect {effect}..)")
