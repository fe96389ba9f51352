"""What was decided before: a fold of the journal that outlives the server."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.app.serving.authors import Authors
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ApprovalRejected,
    ProposalSuperseded,
)
from sitewright.central_controller.fingerprint import check_code
from sitewright.foundation.canonical import Json
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.decisions import (
    DECIDED,
    DECIDED_OTHERWISE,
    Reply,
    Signed,
    not_asked,
    refusal,
    stale,
)
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.roles import Verb

_MS = 1_000_000


class Memory:
    """Remembers keys and decisions of a chain of runs, to answer those who come second."""

    def __init__(self) -> None:
        self._first: dict[str, tuple[str, Mapping[str, Json]]] = {}
        self._decided: dict[str, Mapping[str, Json]] = {}
        self._gone: dict[str, str] = {}
        self._authors = Authors()

    def note(self, run: str, stamped: Stamped) -> None:
        """Learn from an event that is on the disk."""
        event = stamped.event
        self._authors.note(event)
        if isinstance(event, ProposalSuperseded):
            self._gone[event.fingerprint] = event.reason
        record = decision_of(event)
        if record is None:
            return
        fingerprint = _fingerprint(event)
        body: dict[str, Json] = {
            "ok": True,
            "verb": record.verb,
            "who": _who(event),
            "at_ms": stamped.at_utc_ns // _MS,
            "run": run,
            "n": stamped.number,
            "code": check_code(fingerprint) if fingerprint else "",
        }
        if isinstance(event, ApprovalGiven):
            body["approval_id"] = event.approval.approval_id
        self._first.setdefault(record.key, (record.body_sha256, body))
        if fingerprint:
            self._decided[fingerprint] = body

    def authors_of(self, fingerprint: str) -> frozenset[str]:
        """Return who wished for what a plan carries out."""
        return self._authors.by_fingerprint.get(fingerprint, frozenset())

    def body_of(self, key: str) -> str:
        """Return the hash of what a key decided; empty if it decided nothing yet."""
        return self._first[key][0] if key in self._first else ""

    def first_answer(self, key: str) -> Mapping[str, Json]:
        """Return what the one who pressed with a key was told."""
        return self._first[key][1]

    def too_late(self, fingerprint: str, open_: str) -> Reply:
        """Return why a decision about a proposal that is not asked about cannot be taken."""
        if fingerprint in self._gone:
            return stale(fingerprint, open_, self._gone[fingerprint])
        if fingerprint in self._decided:
            first = self._decided[fingerprint]
            return _decided(str(first["who"]), str(first["verb"]), first["at_ms"], open_)
        if open_:
            return stale(fingerprint, open_, "")
        return not_asked(Sentence("No plan waits for a decision now."))

    def decided_first(self, signed: Signed) -> Reply:
        """Return that somebody else was quicker, by a decision that is being written down."""
        return _decided(signed.person.who, signed.decision.verb, None, signed.decision.fingerprint)


def decision_of(event: AnyEvent) -> DecisionRecord | None:
    """Return the record of the decision that an event carries out, if a person made it."""
    found = getattr(event, "decision", None)
    return found if isinstance(found, DecisionRecord) else None


def _decided(who: str, verb: str, at_ms: Json, open_: str) -> Reply:
    message = Sentence(DECIDED.get(Verb(verb), DECIDED_OTHERWISE), who=who)
    return refusal(409, "decided", message, who=who, verb=verb, at_ms=at_ms, open=open_ or None)


def _fingerprint(event: AnyEvent) -> str:
    match event:
        case ApprovalGiven(approval=approval):
            return approval.fingerprint
        case ApprovalRejected(rejection=rejection):
            return rejection.fingerprint
        case AlternativeChosen(fingerprint=fingerprint):
            return fingerprint
        case _:
            return ""


def _who(event: AnyEvent) -> str:
    if isinstance(event, ApprovalGiven):
        return event.approval.who
    return str(getattr(event, "who", ""))
