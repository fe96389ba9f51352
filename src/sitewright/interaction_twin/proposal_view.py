"""A proposal as it is shown: numbered steps in plain words, with robot, times and distances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sitewright.central_controller.fingerprint import check_code, fingerprint
from sitewright.central_controller.ports import Alternative, ApprovalRequest, RefusalNote
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted, in_millimetres, in_seconds
from sitewright.interaction_twin.narration import act_of, folded, narrate, reason
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.retelling import retold


@dataclass(frozen=True, slots=True, kw_only=True)
class StepView:
    """One line of the list.

    Attributes:
        starts_s: Planned start, counted from the first step.
        why: Reason, if another robot waits for this step.
        is_done: It ran already.
    """

    number: int
    robot: str
    words: str
    starts_s: float
    duration_s: float
    closest_distance_m: float | None
    why: str = ""
    is_done: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposalView:
    """Everything that a person sees before saying yes.

    Attributes:
        code: Check code of the fingerprint; the same wherever the proposal is shown.
        summary: The plan with its runs folded, one sentence per run.
        notes: What was refused on the way to this plan.
        why: Why it is asked anew.
    """

    title: str
    code: str
    steps: tuple[StepView, ...]
    summary: tuple[str, ...]
    duration_s: float
    closest_distance_m: float | None
    notes: tuple[str, ...] = ()
    why: str = ""


def proposal_view(
    request: ApprovalRequest, labels: Labels, book: Phrasebook = ENGLISH
) -> ProposalView:
    """Return what is shown of a request; done steps are marked, times are of what is left."""
    steps = request.proposal.steps
    left = [s for s in steps if s.number >= request.next_step]
    whole = view_of(request.proposal, labels, book, refusals=request.refusals)
    runs = folded([(s.number, s.call) for s in left], labels, book)
    target = labels.name(request.proposal.target)
    return replace(
        whole,
        title=f"One chosen step for {target}" if request.is_single else whole.title,
        code=request.code,
        steps=step_views(steps, labels, book, next_step=request.next_step),
        summary=tuple(f"{run.robot} {run.words}" for run in runs),
        duration_s=sum(s.duration_s for s in left),
        closest_distance_m=_closest(left),
        why=request.why,
    )


def view_of(
    proposal: Proposal,
    labels: Labels,
    book: Phrasebook = ENGLISH,
    *,
    refusals: Sequence[RefusalNote] = (),
) -> ProposalView:
    """Return what is shown of a proposal by itself."""
    runs = folded([(s.number, s.call) for s in proposal.steps], labels, book)
    return ProposalView(
        title=f"Plan for {labels.name(proposal.target)}",
        code=check_code(fingerprint(proposal)),
        steps=step_views(proposal.steps, labels, book),
        summary=tuple(f"{run.robot} {run.words}" for run in runs),
        duration_s=sum(s.duration_s for s in proposal.steps),
        closest_distance_m=_closest(proposal.steps),
        notes=tuple(note_in_words(n, labels, book) for n in refusals),
    )


def note_in_words(note: RefusalNote, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return a refusal in words: what cannot be, how sure that is, and what is done instead."""
    what = {"target": note.target, "reason": note.reason, "kind": note.kind}
    what["verdict"] = note.verdict
    if not note.then:
        told = Sentence("{target}: {reason} ({kind}, {verdict})", **what)
    else:
        told = Sentence(
            "{target}: {reason} ({kind}, {verdict}); instead: {then}", then=note.then, **what
        )
    return retold(told, labels, book)


def _closest(steps: Sequence[ProposedStep]) -> float | None:
    return min((d for s in steps if (d := s.closest_distance_m) is not None), default=None)


def step_views(
    steps: Sequence[ProposedStep], labels: Labels, book: Phrasebook = ENGLISH, *, next_step: int = 1
) -> tuple[StepView, ...]:
    """Return one line per step."""
    views: list[StepView] = []
    time_s = 0.0
    for index, step in enumerate(steps):
        views.append(
            StepView(
                number=step.number,
                robot=labels.name(step.call.robot),
                words=act_of(step.call, labels, book),
                starts_s=time_s,
                duration_s=step.duration_s,
                closest_distance_m=step.closest_distance_m,
                why=reason(steps, index, labels, book),
                is_done=step.number < next_step,
            )
        )
        time_s += step.duration_s
    return tuple(views)


def plan_lines(view: ProposalView) -> tuple[str, ...]:
    """Return the whole proposal as lines of text, columns aligned."""
    head = (
        f"{view.title}: {counted(len(view.steps), 'step')}, {in_seconds(view.duration_s)}, "
        f"closest distance {in_millimetres(view.closest_distance_m)}"
    )
    rows = [_cells(step) for step in view.steps]
    widths = [max((len(row[c]) for row in rows), default=0) for c in range(5)]
    in_short = [f"In short: {'; '.join(view.summary)}."] if view.summary else []
    lines = [head, f"Check code {view.code}", *in_short, ""]
    for row, step in zip(rows, view.steps, strict=True):
        number, robot, words, time, distance = (
            cell.rjust(w) if c in {0, 3, 4} else cell.ljust(w)
            for c, (cell, w) in enumerate(zip(row, widths, strict=True))
        )
        lines.append(f"  {number}  {robot}  {words}  {time}  {distance}".rstrip())
        if step.why:
            lines.append(f"  {' ' * widths[0]}  {' ' * widths[1]}  ({step.why})")
    lines += [""] + [f"Refused on the way: {note}" for note in view.notes]
    return tuple(lines if view.notes else lines[:-1])


def _cells(step: StepView) -> tuple[str, str, str, str, str]:
    number = f"{step.number}{'*' if step.is_done else ''}"
    distance = in_millimetres(step.closest_distance_m)
    return number, step.robot, step.words, in_seconds(step.duration_s), distance


def alternative_lines(
    alternatives: Sequence[Alternative], labels: Labels, book: Phrasebook = ENGLISH
) -> tuple[str, ...]:
    """Return the other feasible actions, numbered, with price and notes."""
    lines = []
    for number, other in enumerate(alternatives, start=1):
        lines.append(f"  {number}. {narrate(other.call, labels, book)}{_price(other)}")
    return tuple(lines)


def _price(other: Alternative) -> str:
    if other.leads_nowhere:
        return f"  -- leads nowhere: {other.note}" if other.note else "  -- leads nowhere"
    price = "" if other.price_s is None else f"  {other.price_s:+.0f} s"
    return f"{price}  ({other.note})" if other.note else price
