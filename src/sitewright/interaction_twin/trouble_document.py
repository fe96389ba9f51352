"""What a person must help with: reason in words, what is in the way, and what can be done."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import DeviationSeen, RefusalMet, TargetRefused
from sitewright.central_controller.ports import RefusalNote, verdict_of
from sitewright.central_controller.steering import hand_facts
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.report.content import Stamped
from sitewright.planning_twin.moment import Moment
from sitewright.planning_twin.scene import Attachment

_NEEDS_PERSON = 3


def trouble_document(state: CycleState, history: Sequence[Stamped], labels: Labels) -> list[Json]:
    """Return one entry per target that is set aside, and one for what made the run stand."""
    refused = _refusals(history)
    site = state.site
    found: list[Json] = [
        _refused(target, reason, refused.get(target), state, labels)
        for target, reason in site.refused.items()
    ]
    found += [
        _entry(target, reason, "a person must put it right", (), state, labels)
        for target, reason in site.needs_rework.items()
    ]
    last = next((s.event for s in reversed(history) if isinstance(s.event, DeviationSeen)), None)
    if state.held is not None and last is not None and last.level >= _NEEDS_PERSON:
        subject = ComponentId(last.subject)
        what = f"{labels.name(subject)} {last.what}"
        found.append(_entry(subject, what, "", (subject,), state, labels))
    return found


@dataclass(frozen=True, slots=True)
class _Refused:
    """A target that was set aside, with what was refused right before."""

    event: TargetRefused
    notes: tuple[RefusalNote, ...]

    @property
    def telling(self) -> RefusalNote | None:
        """The note with a pair that the reason is made of; else the last one with a pair."""
        paired = [n for n in self.notes if n.pair]
        named = (n for n in paired if n.reason and n.reason in self.event.reason)
        return next(named, paired[-1] if paired else None)


def _refusals(history: Sequence[Stamped]) -> dict[ComponentId, _Refused]:
    """Return the last refusal of each target; its notes stand right before it in the journal."""
    found: dict[ComponentId, _Refused] = {}
    notes: list[RefusalNote] = []
    for stamped in history:
        match stamped.event:
            case RefusalMet(refusal=note):
                notes.append(note)
            case TargetRefused() as event:
                mine = tuple(n for n in notes if n.target == event.target)
                found[event.target] = _Refused(event, mine)
                notes = []
            case _:
                notes = []
    return found


def _refused(
    target: ComponentId,
    reason: str,
    refused: _Refused | None,
    state: CycleState,
    labels: Labels,
) -> dict[str, Json]:
    if refused is None:
        return _entry(target, reason, "", (), state, labels)
    event, note = refused.event, refused.telling
    verdict = verdict_of([labels.body(b) for b in event.blockers], is_proven=event.is_proven)
    entry = _entry(target, reason, verdict, event.blockers, state, labels)
    helps: list[Json] = [
        {"words": labels.told(c.words), "steps": c.steps, "duration_s": c.duration_s}
        for c in event.counter_proposals
    ]
    entry["counter_proposals"] = helps
    if note is not None:
        entry["pair"] = list(note.pair)
        entry["posture"] = None if note.moment is None else _posture(note.moment)
    return entry


def _posture(moment: Moment) -> Json:
    """Return where robots and bodies were; fingers go with their gripper."""
    bodies = [_placed(n, p) for n, p in moment.bodies.items() if "/" not in n]
    return {"q_rad": {r: list(q) for r, q in moment.q_rad.items()}, "bodies": bodies}


def _placed(name: str, placement: Pose | Attachment) -> Json:
    match placement:
        case Attachment(robot=robot, tip_T_body=pose):
            on: str | None = robot
        case pose:
            on = None
    at = {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)}
    return {"body": name, "on": on, "pose": at}


def _entry(
    target: ComponentId,
    reason: str,
    verdict: str,
    blockers: Sequence[str],
    state: CycleState,
    labels: Labels,
) -> dict[str, Json]:
    return {
        "target": target,
        "name": labels.name(target),
        "reason": labels.told(reason),
        "verdict": verdict,
        "pair": None,
        "posture": None,
        "blockers": list(blockers),
        "blocker_names": [labels.body(b) for b in blockers],
        "counter_proposals": [],
        "options": _options(target, state),
    }


def _options(target: ComponentId, state: CycleState) -> list[Json]:
    """Return what a person can decide now; each is checked again when it is decided."""
    found: list[Json] = []
    if state.held is not None or state.finished is not None:
        words = "Plan it again, after the cell was looked at"
        found.append({"id": "again", "verb": "resume", "words": words})
    if hand_facts(state.site).get(target):
        words = "Say which of its work was done by hand"
        found.append({"id": "by-hand", "verb": "manual", "words": words})
    found += [
        {
            "id": f"remove-{zone}",
            "verb": "zone",
            "zone": {"remove": zone},
            "words": f"Take the keep-out zone {zone} away",
        }
        for zone in state.site.zones
    ]
    return found
