"""A decision as it comes from a page, and the answers that it can get."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.ports import Answer, Scope
from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.pose import Pose, Vector, from_axis_angle
from sitewright.foundation.sentence import Sentence, parts_of
from sitewright.interaction_twin.roles import Person, Verb
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoneWish:
    """A box that stands upright.

    Attributes:
        yaw_rad: Turn about the world's z.
    """

    centre_m: Vector
    size_m: Vector
    yaw_rad: float = 0.0

    @property
    def world_T_zone(self) -> Pose:
        """Pose of its middle."""
        return Pose(self.centre_m, from_axis_angle((0.0, 0.0, 1.0), self.yaw_rad))


@dataclass(frozen=True, slots=True, kw_only=True)
class Decision:
    """What a person pressed.

    Attributes:
        fingerprint: Of the proposal that was on the screen when it was pressed; empty for verbs
            that are about no proposal.
        key: Chosen by the client for each press; sent again with the same key, it is the same.
        next_step: The next step that was on the screen; 0 if the client does not say.
        shown: The sentences that were on the screen.
        reason: Of a rejection, one of `REASONS`; of a hold, the person's words.
        step: Step that a rejection or a new motion is about; 0 is the whole plan.
        call: The other action that was chosen.
        question_id: The question that `answer` is about.
        component: What does not match the site.
        zone: A box to keep out of; `remove_zone` names one to take away.
        target: What was worked on by hand, and which `effects` the person vouches for.
    """

    verb: Verb
    key: str
    fingerprint: str = ""
    next_step: int = 0
    shown: tuple[str, ...] = ()
    language: str = "en"
    scope: Scope = field(default_factory=Scope)
    comment: str = ""
    reason: str = ""
    detail: str = ""
    step: int = 0
    call: SkillCall | None = None
    question_id: str = ""
    answer: Answer | None = None
    component: str = ""
    zone: ZoneWish | None = None
    remove_zone: str = ""
    target: str = ""
    effects: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Signed:
    """A decision with the person who made it.

    Attributes:
        body_sha256: Of the request's content, to tell a repeated press from a reused key.
        second: The other person, where a policy asks for two.
    """

    decision: Decision
    person: Person
    body_sha256: str
    second: str = ""

    def record(self) -> DecisionRecord:
        """Return what the journal keeps of it."""
        decision = self.decision
        return DecisionRecord(
            key=decision.key,
            body_sha256=self.body_sha256,
            verb=decision.verb,
            role=self.person.role,
            session=self.person.session,
            language=decision.language,
            shown=decision.shown,
            second=self.second,
        )


def body_hash(body: Mapping[str, Json], who: str) -> str:
    """Return the hash by which a repeated request is known: same content, same person."""
    return sha256_hex(canonical_json([who, body]))


@dataclass(frozen=True, slots=True, kw_only=True)
class Reply:
    """An answer: HTTP status and body."""

    status: int
    body: Mapping[str, Json]

    @property
    def is_ok(self) -> bool:
        """Whether the decision was taken."""
        return self.status == 200  # noqa: PLR2004 -- HTTP


def refusal(status: int, error: str, message: str, **facts: Json) -> Reply:
    """Return a "no" in the form that all of them have; ``message~`` says what it is made of."""
    told = {"message~": parts_of(message)} if isinstance(message, Sentence) else {}
    return Reply(status=status, body={"error": error, "message": message, **told, **facts})


def stale(shown: str, open_: str, why: str) -> Reply:
    """Return that the plan that was shown is not the open one; the server adds the difference."""
    return refusal(
        409,
        "stale",
        Sentence(
            "The site or the plan changed after this plan was shown. Look at the new plan first."
        ),
        shown=shown,
        open=open_ or None,
        why=why,
    )


def key_reused() -> Reply:
    """Return that a key came again with other content."""
    return refusal(
        422,
        "key-reused",
        Sentence("This key was used for another decision; nothing was done."),
    )


def not_asked(message: str, **facts: Json) -> Reply:
    """Return that nothing waits for this decision."""
    return refusal(409, "not-asked", message, **facts)


def one_of_two(signed: Signed) -> Reply:
    """Return that one person is not enough for this."""
    verb = signed.decision.verb.value
    message = Sentence("Noted. A second person must decide the same.")
    body: dict[str, Json] = {
        "ok": False,
        "verb": verb,
        "waiting_for": "second person",
        "message": message,
        "message~": parts_of(message),
    }
    return Reply(status=202, body=body)


def no_run(message: str) -> Reply:
    """Return that the process of the run is not there."""
    return refusal(503, "run", message)


def not_recorded(why: str) -> Reply:
    """Return that the journal could not be written, so nothing was decided."""
    return refusal(
        503,
        "journal",
        Sentence("Not recorded, nothing decided: the journal cannot be written ({why}).", why=why),
    )


DECIDED: Mapping[Verb, str] = {
    Verb.APPROVE: "{who} approved this plan already; nothing was done.",
    Verb.REJECT: "{who} rejected this plan already; nothing was done.",
    Verb.INSTEAD: "{who} chose another action instead of this plan already; nothing was done.",
    Verb.NEW_MOTION: "{who} asked for a new motion in this plan already; nothing was done.",
    Verb.HOLD: "{who} held this plan already; nothing was done.",
    Verb.MISMATCH: "{who} reported a mismatch in this plan already; nothing was done.",
    Verb.ZONE: "{who} changed the keep-out zones of this plan already; nothing was done.",
    Verb.MANUAL: "{who} completed by hand a part of this plan already; nothing was done.",
}
"""Templates of who was quicker."""
DECIDED_OTHERWISE = "{who} decided about this plan already; nothing was done."


def shown_as(sentences: Sequence[str], most: int = 200) -> tuple[str, ...]:
    """Return the sentences that are kept of what was shown; the journal's records are bounded."""
    return tuple(s[:500] for s in sentences[:most])
