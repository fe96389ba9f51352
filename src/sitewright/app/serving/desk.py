"""The desk: where a run waits for people, and where the first valid decision wins.

The run's own thread waits here (`ask`, `answer`, `wait_to_go`); decisions come in from another
thread and are judged at once, so that a "no" is quick also while the run plans or moves. A "yes"
is told only when the journal has its event on the disk.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from threading import Condition

from sitewright.app.serving.memory import Memory, decision_of
from sitewright.app.serving.rules import Review, answer_of, objection, sameness, site_objection
from sitewright.app.serving.telling import way_document
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import RunFinished, RunHeld
from sitewright.central_controller.ports import (
    Alternative,
    ApprovalAnswer,
    ApprovalRequest,
    DoInstead,
    Hold,
    Question,
    Settled,
)
from sitewright.central_controller.site_state import SiteState
from sitewright.errors import JournalError, SitewrightError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.decisions import (
    Reply,
    Signed,
    key_reused,
    no_run,
    not_asked,
    not_recorded,
    one_of_two,
    refusal,
    stale,
)
from sitewright.interaction_twin.policy import ApprovalPolicy
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.roles import Verb
from sitewright.interaction_twin.state_document import asked_plan

Respond = Callable[[Reply], None]
"""Sends the answer to the one who decided."""
_SERVER = "the page's server"
ABOUT_THE_SITE = (Verb.ZONE, Verb.MISMATCH, Verb.MANUAL)
"""Verbs that change what plans are made of; they need no fingerprint."""


@dataclass
class _Taken:
    """The decision that was taken and is not on the disk yet, with all who wait for that.

    Attributes:
        is_for_next: It begins the next run, or goes on with this one after it stopped.
    """

    signed: Signed
    respond: list[Respond] = field(default_factory=list)
    is_for_next: bool = False


@dataclass
class _Errand:
    """Somebody wants to know the other ways of the open proposal."""

    fingerprint: str
    respond: Respond


def _nowhere() -> CycleState:
    return CycleState(site=SiteState())


class Desk:
    """Port `Approver` for people at a page."""

    def __init__(  # noqa: PLR0913 -- all that decisions are judged by
        self,
        memory: Memory,
        *,
        policy: ApprovalPolicy | None = None,
        at_rest: Callable[[], CycleState] = _nowhere,
        types: Mapping[ComponentId, str] | None = None,
        waits_to_go: bool = True,
        now_s: Callable[[], float] = time.monotonic,
        on_asking: Callable[[str], None] = lambda _: None,
    ) -> None:
        """Open the desk.

        Args:
            memory: What was decided before.
            policy: Rules of the project.
            at_rest: The state of the run while it stands.
            types: Type of each component of the design.
            waits_to_go: The run stands until somebody wants it to go on.
            now_s: Clock for those who wait for a second person.
            on_asking: Gets what an answer is taken to from now on (`Standing.asks`).
        """
        self._on_asking = on_asking
        self._memory, self._policy = memory, policy or ApprovalPolicy()
        self._types = types or {}
        self._at_rest, self._now_s = at_rest, now_s
        self._firsts: dict[str, tuple[Signed, float]] = {}
        self._changed = Condition()
        self._request: ApprovalRequest | None = None
        self._question: Question | None = None
        self._waits_to_go = waits_to_go
        self._taken: _Taken | None = None
        self._hold: Hold | None = None
        self._errands: list[_Errand] = []
        self._ways: tuple[Alternative, ...] | None = None
        self._has_quit = False

    # ---- the run's thread ------------------------------------------------------------------

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        """Wait for a decision about a proposal; blocks until there is one."""
        with self._changed:
            self._request, self._ways = request, None
        self._on_asking(asked_plan(request.fingerprint, request.next_step))
        try:
            while True:
                taken, errand, hold = self._next()
                if hold is not None:
                    return hold
                if errand is not None:
                    errand.respond(self._other_ways(errand.fingerprint, request))
                elif taken is not None and (answer := self._answer_of(taken, request)) is not None:
                    return answer
        finally:
            with self._changed:
                self._request = None
                self._refuse_errands()

    def answer(self, question: Question) -> Settled | None:
        """Wait for what a person says about an unknown outcome; None if the run is to stop."""
        with self._changed:
            self._question = question
        self._on_asking(question.question_id)
        with self._changed:
            self._changed.wait_for(lambda: self._taken is not None or self._hold is not None)
            self._question = None
            taken = self._taken
        if taken is None or taken.signed.decision.answer is None:
            return None
        return Settled(
            answer=taken.signed.decision.answer,
            who=taken.signed.person.who,
            decision=taken.signed.record(),
        )

    def wait_to_go(self) -> Signed | None:
        """Wait until somebody wants the run to go on; None if the server is gone."""
        with self._changed:
            self._changed.wait_for(lambda: self._taken is not None or self._has_quit)
            self._waits_to_go = False
            if self._taken is None:
                return None
            self._taken.is_for_next = False
            return self._taken.signed

    def hold_asked(self) -> Hold | None:
        """Return the hold that somebody asked for and that is not in the journal yet."""
        return self._hold

    def on_record(self, run: str, stamped: Stamped) -> None:
        """Note an event that is on the disk; whoever waited for it is told."""
        with self._changed:
            self._memory.note(run, stamped)
            record = decision_of(stamped.event)
            if isinstance(stamped.event, RunHeld | RunFinished):  # what is left is tidying up
                self._waits_to_go, self._hold = True, None
            taken = self._taken
            if taken is None or record is None or record.key != taken.signed.decision.key:
                return
            self._taken = None
        reply = Reply(status=200, body=self._memory.first_answer(record.key))
        for respond in taken.respond:
            respond(reply)

    def run_ended(self, error: BaseException | None, message: str) -> None:
        """Tell those who still wait that the run stopped before their decision was recorded."""
        with self._changed:
            taken = self._taken
            self._waits_to_go, self._hold = True, None
            if taken is None or taken.is_for_next:
                return
            self._taken = None
        reply = not_asked(message)
        if isinstance(error, JournalError):
            reply = not_recorded(str(error))
        elif error is not None:
            reply = no_run(Sentence("The run broke off: {why}", why=str(error)))
        for respond in taken.respond:
            respond(reply)

    # ---- the thread that listens -------------------------------------------------------------

    def decide(self, signed: Signed, respond: Respond) -> None:
        """Judge a decision; a "no" is told at once, a "yes" when it is recorded."""
        with self._changed:
            reply = self._judged(signed, respond)
            self._changed.notify_all()
        if reply is not None:
            respond(reply)

    def hold(self, signed: Signed) -> Reply:
        """Ask for a hold; it is recorded when the robots are at rest."""
        with self._changed:
            if self._waits_to_go:
                return not_asked(Sentence("The run stands already."))
            if self._hold is None:
                self._hold = Hold(
                    who=signed.person.who,
                    reason=signed.decision.reason,
                    decision=signed.record(),
                )
            self._changed.notify_all()
        return Reply(status=200, body={"ok": True})

    def other_ways(self, fingerprint: str, respond: Respond) -> None:
        """Ask what else could be done instead of the next step of the open proposal."""
        with self._changed:
            if self._request is None:
                respond(not_asked(Sentence("No plan waits for a decision now.")))
                return
            self._errands.append(_Errand(fingerprint, respond))
            self._changed.notify_all()

    def quit(self) -> None:
        """The server is gone: hold, and go home."""
        with self._changed:
            self._has_quit = True
            self._hold = self._hold or Hold(who=_SERVER, reason="it ended or was lost")
            self._changed.notify_all()

    @property
    def has_quit(self) -> bool:
        """Whether the server is gone."""
        return self._has_quit

    # ---- judging ---------------------------------------------------------------------------

    def _judged(self, signed: Signed, respond: Respond) -> Reply | None:
        """Return the refusal or the first answer again; None if the decision was taken."""
        repeated = self._repeated(signed, respond)
        if repeated is not None:
            return repeated
        if self._taken is not None and respond in self._taken.respond:
            return None
        reply = self._not_acceptable(signed)
        if reply is not None:
            return reply
        if signed.decision.verb in self._policy.two_person:
            other = self._first_of_two(signed)
            if other is None:
                return one_of_two(signed)
            signed = replace(signed, second=other.person.who)
        self._taken = _Taken(signed, [respond], is_for_next=self._waits_to_go)
        return None

    def _repeated(self, signed: Signed, respond: Respond) -> Reply | None:
        """Return what a known key gets; one that is being written down waits with the first."""
        key, taken = signed.decision.key, self._taken
        known = self._memory.body_of(key)
        is_pending = taken is not None and taken.signed.decision.key == key
        if taken is not None and is_pending:
            known = taken.signed.body_sha256
        if known and known != signed.body_sha256:
            return key_reused()
        if taken is not None and is_pending:
            taken.respond.append(respond)
            return None
        if known:
            return Reply(status=200, body={**self._memory.first_answer(key), "repeated": True})
        return None

    def _first_of_two(self, signed: Signed) -> Signed | None:
        """Return who decided the same before; without that, remember this one."""
        what, now_s = sameness(signed.decision), self._now_s()
        first, at_s = self._firsts.get(what, (signed, now_s))
        is_in_time = now_s - at_s <= self._policy.second_within_s
        if first.person.who != signed.person.who and is_in_time:
            del self._firsts[what]
            return first
        self._firsts[what] = (signed, now_s)
        return None

    def _not_acceptable(self, signed: Signed) -> Reply | None:
        match signed.decision.verb:
            case Verb.RESUME:
                free = self._waits_to_go and self._taken is None
                return None if free else not_asked(Sentence("The run is under way already."))
            case Verb.ANSWER:
                return self._about_question(signed)
            case Verb.ZONE | Verb.MANUAL if self._waits_to_go and self._taken is None:
                return site_objection(signed, self._at_rest().site)
            case _:
                return self._about_proposal(signed)

    def _about_question(self, signed: Signed) -> Reply | None:
        question, taken = self._question, self._taken
        if self._waits_to_go and taken is None:
            question = self._at_rest().question
        if taken is not None and taken.signed.decision.question_id == signed.decision.question_id:
            return self._memory.decided_first(taken.signed)
        if question is None or question.question_id != signed.decision.question_id:
            return not_asked(Sentence("This question is not open any more."))
        return None

    def _about_proposal(self, signed: Signed) -> Reply | None:
        decision, request = signed.decision, self._request
        taken = self._taken
        if taken is not None and taken.signed.decision.fingerprint == decision.fingerprint:
            return self._memory.decided_first(taken.signed)
        if request is None and not decision.fingerprint:
            return not_asked(
                Sentence("The run plans or moves now; hold it, or wait until it asks.")
            )
        wanted = decision.fingerprint
        if not wanted and request is not None and decision.verb in ABOUT_THE_SITE:
            wanted = request.fingerprint
        if request is None or wanted != request.fingerprint:
            open_ = "" if request is None else request.fingerprint
            return self._memory.too_late(decision.fingerprint, open_)
        if decision.next_step not in (0, request.next_step):
            return self._memory.too_late(decision.fingerprint, "")
        authors = self._memory.authors_of(request.fingerprint)
        review = Review(policy=self._policy, authors=authors, types=self._types)
        return objection(signed, request, review)

    # ---- answers ---------------------------------------------------------------------------

    def _next(self) -> tuple[_Taken | None, _Errand | None, Hold | None]:
        with self._changed:
            self._changed.wait_for(lambda: self._taken or self._errands or self._hold)
            errand = self._errands.pop(0) if self._errands and self._taken is None else None
            return self._taken, errand, None if self._taken else self._hold

    def _answer_of(self, taken: _Taken, request: ApprovalRequest) -> ApprovalAnswer | None:
        return answer_of(taken.signed, self._policy) or self._instead(
            taken, request, taken.signed.record()
        )

    def _instead(
        self, taken: _Taken, request: ApprovalRequest, record: DecisionRecord
    ) -> DoInstead | None:
        call = taken.signed.decision.call
        ways = [] if request.is_single else self._computed(request)
        if call is not None and any(w.call == call and not w.leads_nowhere for w in ways):
            return DoInstead(who=taken.signed.person.who, call=call, decision=record)
        with self._changed:
            self._taken = None
        reply = refusal(
            409, "not-feasible", Sentence("This action is not possible now; look again.")
        )
        for respond in taken.respond:
            respond(reply)
        return None

    def _other_ways(self, fingerprint: str, request: ApprovalRequest) -> Reply:
        if fingerprint != request.fingerprint:
            return stale(fingerprint, request.fingerprint, "")
        try:
            ways = [] if request.is_single else self._computed(request)
        except SitewrightError as error:
            return no_run(Sentence("The other ways could not be worked out: {why}", why=str(error)))
        return Reply(
            status=200, body={"step": request.next_step, "ways": [way_document(w) for w in ways]}
        )

    def _computed(self, request: ApprovalRequest) -> list[Alternative]:
        if self._ways is None:
            self._ways = request.alternatives()
        step = request.proposal.steps[request.next_step - 1]
        return [w for w in self._ways if w.call != step.call]

    def _refuse_errands(self) -> None:
        errands, self._errands = self._errands, []
        for errand in errands:
            errand.respond(not_asked(Sentence("No plan waits for a decision any more.")))
