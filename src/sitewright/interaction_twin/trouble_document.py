"""What a person must help with: reason in words, what is in the way, and what can be done."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    ApprovalRejected,
    DeviationSeen,
    RefusalMet,
    RunStarted,
    TargetRefused,
)
from sitewright.central_controller.outcomes import WITH_HELPS
from sitewright.central_controller.ports import RefusalNote
from sitewright.central_controller.steering import HELD_BY_PERSON, hand_facts
from sitewright.central_controller.wishes import LATER
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.retelling import retold
from sitewright.planning_twin.moment import Moment
from sitewright.planning_twin.scene import Attachment

_NEEDS_PERSON = 3


def trouble_document(
    state: CycleState,
    history: Sequence[Stamped],
    labels: Labels,
    book: Phrasebook = ENGLISH,
) -> list[Json]:
    """Return one entry per target that is set aside, and one for what made the run stand."""
    refused, telling = _refusals(history), _Telling(state, labels, book)
    site = state.site
    found: list[Json] = [
        telling.refused(target, reason, refused.get(target))
        for target, reason in site.refused.items()
    ]
    found += [
        telling.entry(target, reason, Verdict.PERSON)
        for target, reason in site.needs_rework.items()
    ]
    last = next((s.event for s in reversed(history) if isinstance(s.event, DeviationSeen)), None)
    if state.held is not None and last is not None and last.level >= _NEEDS_PERSON:
        subject = ComponentId(last.subject)
        what = Sentence("{what}: {detail}", what=subject, detail=last.what)
        found.append(telling.entry(subject, what, None, (subject,)))
    return found


class Verdict(StrEnum):
    """How sure a "no" is, for pages that explain it."""

    PROVEN = "proven"
    BLOCKED = "blocked"
    NOT_FOUND = "not-found"
    PERSON = "person"
    WISH = "wish"
    REJECTED = "rejected"


@dataclass(frozen=True, slots=True)
class _Refused:
    """A target that was set aside, with what was refused right before.

    Attributes:
        rejections: What people rejected about it in the same run.
    """

    event: TargetRefused
    notes: tuple[RefusalNote, ...]
    rejections: tuple[ApprovalRejected, ...] = ()

    @property
    def is_rejected(self) -> bool:
        """Whether a person's "no" is one of the reasons."""
        return any(r.rejection.reason != LATER for r in self.rejections)

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
    rejected: list[ApprovalRejected] = []
    for stamped in history:
        match stamped.event:
            case RefusalMet(refusal=note):
                notes.append(note)
            case TargetRefused() as event:
                mine = tuple(n for n in notes if n.target == event.target)
                no = tuple(r for r in rejected if r.rejection.target == event.target)
                found[event.target] = _Refused(event, mine, no)
                notes = []
            case ApprovalRejected() as event:
                rejected.append(event)
                notes = []
            case RunStarted():
                notes, rejected = [], []
            case _:
                notes = []
    return found


@dataclass(frozen=True, slots=True)
class _Telling:
    """Says what a person must help with, in one language."""

    state: CycleState
    labels: Labels
    book: Phrasebook

    def __call__(self, text: str) -> str:
        return retold(text, self.labels, self.book)

    def refused(
        self, target: ComponentId, reason: str, refused: _Refused | None
    ) -> dict[str, Json]:
        """Return the entry of a target that was set aside."""
        if refused is None:
            return self.entry(target, reason, None)
        event, note = refused.event, refused.telling
        verdict = Verdict.REJECTED if refused.is_rejected else _verdict(event)
        entry = self.entry(target, _without_helps(reason), verdict, event.blockers)
        entry["rejected"] = [self.rejected(r) for r in refused.rejections]
        entry["counter_proposals"] = [
            {"words": self(c.words), "steps": c.steps, "duration_s": c.duration_s}
            for c in event.counter_proposals
        ]
        if note is not None:
            entry["pair"] = list(note.pair)
            entry["pair_names"] = [self(Sentence("{text}", text=name)) for name in note.pair]
            entry["posture"] = None if note.moment is None else _posture(note.moment)
        return entry

    def entry(
        self,
        target: ComponentId,
        reason: str,
        verdict: Verdict | None,
        blockers: Sequence[str] = (),
    ) -> dict[str, Json]:
        """Return an entry without what only a refusal knows."""
        words = "" if verdict is None else self(_words_of(verdict, tuple(blockers)))
        return {
            "target": target,
            "name": self.labels.name(target),
            "reason": self(reason),
            "verdict": words,
            "verdict_kind": "" if verdict is None else verdict.value,
            "pair": None,
            "pair_names": [],
            "posture": None,
            "blockers": list(blockers),
            "blocker_names": [self(Sentence("{text}", text=b)) for b in blockers],
            "counter_proposals": [],
            "rejected": [],
            "options": self.options(target, blockers, is_rejected=verdict is Verdict.REJECTED),
        }

    def rejected(self, event: ApprovalRejected) -> str:
        """Return who rejected what, and why."""
        rejection = event.rejection
        why: str = REASONS.get(rejection.reason, Sentence("something else"))
        if rejection.detail:
            why = Sentence("{what}: {detail}", what=why, detail=rejection.detail)
        if not rejection.step or not rejection.calls:
            return self(Sentence("{who} rejected the plan: {why}", who=event.who, why=why))
        call = narrate(rejection.calls[0], self.labels, self.book)
        return self(
            Sentence(
                "{who} rejected step {step} ({call}): {why}",
                who=event.who,
                step=rejection.step,
                call=call,
                why=why,
            )
        )

    def options(
        self, target: ComponentId, blockers: Sequence[str], *, is_rejected: bool
    ) -> list[Json]:
        """Return what a person can decide now; each is checked again when it is decided.

        Where it is known what is in the way, only the zones among that can be taken away.
        """
        state, found = self.state, list[Json]()
        if state.held is not None or state.finished is not None:
            again = (
                Sentence("Ask for the same plan again, after a look at the cell")
                if is_rejected
                else Sentence("Plan it again, after the cell was looked at")
            )
            found.append({"id": "again", "verb": "resume", "words": self(again)})
        if is_rejected:
            draw = Sentence("Draw a keep-out zone, so that the robots go another way")
            found.append({"id": "draw", "verb": "zone", "words": self(draw)})
        if hand_facts(state.site).get(target):
            words = self(Sentence("Say which of its work was done by hand"))
            found.append({"id": "by-hand", "verb": "manual", "words": words})
        for zone in (z for z in state.site.zones if z in blockers or not blockers):
            words = self(Sentence("Take {zone} away", zone=zone))
            remove: Json = {"remove": zone}
            found.append({"id": f"remove-{zone}", "verb": "zone", "zone": remove, "words": words})
        return found


REASONS: Mapping[str, Sentence] = {
    "wrong-component": Sentence("wrong component"),
    "wrong-robot": Sentence("wrong robot"),
    "path-unsafe": Sentence("the path looks unsafe"),
    "site-differs": Sentence("the site is different"),
    LATER: Sentence("later"),
}


def _without_helps(reason: str) -> str:
    """Return a reason without what works, which is listed beside it."""
    if isinstance(reason, Sentence) and reason.template == WITH_HELPS:
        inner = reason.places["reason"]
        return inner if isinstance(inner, str) else reason
    return reason


def _verdict(event: TargetRefused) -> Verdict:
    if event.exit_code == HELD_BY_PERSON:
        return Verdict.WISH
    if event.is_proven:
        return Verdict.PROVEN
    return Verdict.BLOCKED if event.blockers else Verdict.NOT_FOUND


def _words_of(verdict: Verdict, blockers: tuple[str, ...]) -> Sentence:
    match verdict:
        case Verdict.PROVEN:
            return Sentence("proven impossible")
        case Verdict.BLOCKED:
            return Sentence("blocked by {things:and}", things=blockers)
        case Verdict.NOT_FOUND:
            return Sentence("not found within budget")
        case Verdict.PERSON:
            return Sentence("a person must put it right")
        case Verdict.WISH:
            return Sentence("a person's wish")
        case Verdict.REJECTED:
            return Sentence("rejected, and nothing else was found")


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
