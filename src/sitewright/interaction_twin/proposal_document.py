"""A proposal as a page shows it: steps in words, with times, distances and exact trajectories."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher

from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import RefusalNote
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.because import reasons
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_millimetres
from sitewright.interaction_twin.narration import folded
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.proposal_story import ProposalStory
from sitewright.interaction_twin.proposal_view import StepView, note_in_words, step_views
from sitewright.interaction_twin.retelling import retold
from sitewright.interaction_twin.scene_document import pose_json
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.robot_team.skill import Skill


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposalSource:
    """What the document is made of.

    Attributes:
        next_step: The first step that is not done.
        why: Why it is asked anew.
        previous: The plan approved before it, to tell what is different; None if there is none.
        previous_done: Numbers of its steps that were done.
        look_below_m: Steps that come nearer than this demand a look.
    """

    run: str
    fingerprint: str
    proposal: Proposal
    story: ProposalStory
    next_step: int
    labels: Labels
    why: str = ""
    refusals: Sequence[RefusalNote] = ()
    previous: tuple[str, Proposal] | None = None
    previous_done: frozenset[int] = frozenset()
    look_below_m: float = 0.020
    book: Phrasebook = ENGLISH


def proposal_document(source: ProposalSource, *, is_open: bool) -> dict[str, Json]:
    """Return everything that a person sees of a proposal before (and after) saying yes."""
    proposal, labels = source.proposal, source.labels
    views = step_views(proposal.steps, labels, source.book, next_step=source.next_step)
    left = [s for s in proposal.steps if s.number >= source.next_step]
    runs = folded([(s.number, s.call) for s in left], labels, source.book)
    whys = reasons(proposal.steps, labels, source.book)
    steps = [_step(source, i, replace(v, why=whys[i])) for i, v in enumerate(views)]
    closest = min(
        (m.certificate for s in left for m in s.motions if m.certificate.closest_pair),
        key=lambda c: c.closest_distance_m,
        default=None,
    )
    previous = source.previous
    target = labels.name(proposal.target)
    is_single = source.story.made.is_single
    return {
        "open": is_open,
        "fingerprint": source.fingerprint,
        "code": check_code(source.fingerprint),
        "run": source.run,
        "target": proposal.target,
        "target_name": target,
        "title": source.book.page["single" if is_single else "plan"].format(target=target),
        "is_single": is_single,
        "next_step": source.next_step,
        "status": source.story.status,
        "why": retold(source.why, labels, source.book),
        "notes": [note_in_words(n, labels, source.book) for n in source.refusals],
        "asked_at_ms": source.story.asked_at_ms,
        "decided": source.story.decided,
        "duration_s": round(sum(s.duration_s for s in left), 3),
        "closest_distance_m": closest.closest_distance_m if closest else None,
        "closest_pair": list(closest.closest_pair or ()) if closest else [],
        "closest_names": [labels.body(b) for b in closest.closest_pair or ()] if closest else [],
        "before": [
            [a.number, b.number] for a, b in zip(proposal.steps, proposal.steps[1:], strict=False)
        ],
        "summary": [f"{run.robot} {run.words}" for run in runs],
        "previous_code": check_code(previous[0]) if previous else "",
        "differences": _differences(source),
        "flagged": [s["number"] for s in steps if s["flags"]],
        "steps": steps,
    }


def _differences(source: ProposalSource) -> list[Json]:
    if source.previous is None:
        return []
    fingerprint, old = source.previous
    if source.story.made.is_single:
        words = source.book.page["instead"].format(code=check_code(fingerprint))
        return [{"kind": "target", "words": words}]
    return differences(
        old, source.proposal, source.labels, source.book, old_done=source.previous_done
    )


def differences(
    old: Proposal,
    new: Proposal,
    labels: Labels,
    book: Phrasebook = ENGLISH,
    *,
    old_done: Container[int] = (),
) -> list[Json]:
    """Return what one plan says and the other does not, in the order of the new one.

    Plans for different targets differ in everything: then only that is said. Steps of the old
    plan that were done are not missing from the new one.
    """
    if old.target != new.target:
        names = {"target": labels.name(new.target), "other": labels.name(old.target)}
        return [{"kind": "target", "words": book.page["about"].format(**names)}]
    left = [s for s in old.steps if s.number not in old_done]
    before = [f"{v.robot} {v.words}" for v in step_views(left, labels, book)]
    after = [f"{v.robot} {v.words}" for v in step_views(new.steps, labels, book)]
    found: list[Json] = []
    matcher = SequenceMatcher(None, before, after, autojunk=False)
    for kind, i1, i2, j1, j2 in matcher.get_opcodes():
        if kind == "equal":
            continue
        found += [{"kind": "removed", "words": w} for w in before[i1:i2]]
        found += [
            {"kind": "added", "words": w, "step": n + 1}
            for n, w in enumerate(after[j1:j2], start=j1)
        ]
    if not found and old != new:
        found.append({"kind": "motion", "words": book.page["same"]})
    return found


def _step(source: ProposalSource, index: int, view: StepView) -> dict[str, Json]:
    step, labels = source.proposal.steps[index], source.labels
    closest = min(
        (m.certificate for m in step.motions if m.certificate.closest_pair),
        key=lambda c: c.closest_distance_m,
        default=None,
    )
    moving_s = sum(m.timed.trajectory.duration_s for m in step.motions)
    holds = _holds(source.proposal.steps, index)
    return {
        "number": step.number,
        "skill": step.call.skill,
        "robot": step.call.robot,
        "robot_name": view.robot,
        "arguments": list(step.call.arguments),
        "words": view.words,
        "why": view.why,
        "is_done": view.is_done,
        "status": source.story.step_status.get(step.number, "open"),
        "starts_s": round(view.starts_s, 3),
        "duration_s": round(step.duration_s, 3),
        "act_s": round(max(0.0, step.duration_s - moving_s), 3),
        "closest_distance_m": closest.closest_distance_m if closest else None,
        "closest_pair": list(closest.closest_pair or ()) if closest else [],
        "closest_names": [labels.body(b) for b in closest.closest_pair or ()] if closest else [],
        "flags": _flags(source, step),
        "touches": list(step.call.arguments),
        "may_touch": [list(pair) for pair in step.contacts],
        "holds_before": holds[0],
        "holds_after": holds[1],
        "motions": _motions(step, view.starts_s),
    }


def _motions(step: ProposedStep, starts_s: float) -> list[Json]:
    found: list[Json] = []
    for motion in step.motions:
        found.append(_motion(motion, starts_s))
        starts_s += motion.timed.trajectory.duration_s
    return found


def _motion(motion: PlannedMotion, starts_s: float) -> Json:
    trajectory, proof = motion.timed.trajectory, motion.certificate
    return {
        "trajectory_sha256": trajectory.sha256(),
        "robot": trajectory.robot,
        "starts_s": round(starts_s, 3),
        "duration_s": round(trajectory.duration_s, 6),
        "closest_distance_m": proof.closest_distance_m if proof.closest_pair else None,
        "closest_pair": list(proof.closest_pair or ()),
        "after": [
            {"body": body, "on": None, "pose": pose_json(placement)}
            if isinstance(placement, Pose)
            else {"body": body, "on": placement.robot, "pose": pose_json(placement.tip_T_body)}
            for body, placement in motion.scene_edits.items()
        ],
    }


def _flags(source: ProposalSource, step: ProposedStep) -> list[str]:
    """Return why a step demands a look."""
    closest_m = step.closest_distance_m
    if closest_m is None or closest_m >= source.look_below_m:
        return []
    limit = in_millimetres(source.look_below_m)
    return [source.book.page["near"].format(near=in_millimetres(closest_m), limit=limit)]


def _holds(steps: Sequence[ProposedStep], index: int) -> tuple[Json, Json]:
    """Return what hangs on the robot's tip before and after a step, as far as the plan says."""
    robot = steps[index].call.robot
    before: str | None = None
    is_known = False
    for step in steps[:index]:
        if step.call.robot == robot:
            is_known, before = True, _after(step, before)
    if not is_known:
        before = _held_at_start(steps, robot)
    after = _after(steps[index], before)
    return (
        None if before is None else {"piece": before},
        None if after is None else {"piece": after},
    )


def _after(step: ProposedStep, before: str | None) -> str | None:
    match step.call.skill:
        case Skill.GRASP:
            return step.call.arguments[0]
        case Skill.RELEASE | Skill.SET_DOWN:
            return None
        case _:
            return before


def _held_at_start(steps: Sequence[ProposedStep], robot: str) -> str | None:
    """Return the piece of the first thing that a robot does with one, unless it is to take it."""
    for step in steps:
        if step.call.robot != robot:
            continue
        match step.call.skill:
            case Skill.GRASP:
                return None
            case Skill.POSITION | Skill.SET_DOWN:
                return step.call.arguments[0]
            case Skill.RELEASE:
                return str(step.params.get("piece")) if "piece" in step.params else None
            case _:
                continue
    return None
