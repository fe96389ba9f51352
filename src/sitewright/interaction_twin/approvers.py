"""Who says yes or no: a person at a terminal, or the policy of a simulation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol

from sitewright.central_controller.ports import (
    Alternative,
    Answer,
    ApprovalAnswer,
    ApprovalRequest,
    Approve,
    DoInstead,
    Hold,
    Question,
    Reject,
    Scope,
    ScopeKind,
    Settled,
)
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_millimetres, in_seconds
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.proposal_view import (
    alternative_lines,
    plan_lines,
    proposal_view,
)


class ApprovalMode(StrEnum):
    """How often a person is asked."""

    PLAN = "plan"
    """Once for all steps of a target."""
    STEP = "step"
    """Before each step."""
    AUTO = "auto"
    """Never; for simulation only."""


class Terminal(Protocol):
    """Where lines are shown and typed."""

    def say(self, line: str) -> None:
        """Show a line."""
        ...

    def ask(self, prompt: str) -> str | None:
        """Return what was typed, without spaces around it; None if nobody types any more."""
        ...


REASONS = ("wrong-component", "wrong-robot", "path-unsafe", "site-differs", "later", "other")
"""Why a person may refuse; the planner takes them as constraints where it can."""

_REASON_WORDS = (
    "wrong component",
    "wrong robot",
    "the path looks unsafe",
    "the site differs from the model",
    "not now, later",
    "other",
)


@dataclass(frozen=True, slots=True)
class AutoApprover:
    """Approves every certified plan of a simulation; answers no question about the site."""

    who: str = "auto"

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        """Approve all steps."""
        return Approve(fingerprint=request.fingerprint, who=self.who)

    def answer(self, question: Question) -> Settled | None:
        """Return None: a policy cannot know what happened."""
        del question
        return None


@dataclass(slots=True)
class TerminalApprover:
    """Asks a person, once per plan or before each step.

    Attributes:
        mode: Plan or step; a person can switch to step by step.
        who: Name that the journal notes.
    """

    terminal: Terminal
    labels: Labels
    mode: ApprovalMode = ApprovalMode.PLAN
    who: str = "local"
    _shown: str = field(default="", init=False)

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        """Show the proposal and wait for a clear answer."""
        if self._shown != request.fingerprint or request.why:
            self._show(request)
        if request.is_single or self.mode is not ApprovalMode.STEP:
            return self._ask_plan(request)
        return self._ask_step(request)

    def answer(self, question: Question) -> Settled | None:
        """Ask what became of a skill; None leaves the question open."""
        self.terminal.say("")
        self.terminal.say(question.text)
        choices = {"d": Answer.DONE, "n": Answer.NOT_DONE, "p": Answer.PARTIAL, "l": None}
        key = self._choose("[d]one, [n]ot done, [p]artly done, [l]eave it open: ", choices)
        found = choices[key] if key else None
        return None if found is None else Settled(answer=found)

    def _show(self, request: ApprovalRequest) -> None:
        view = proposal_view(request, self.labels)
        self.terminal.say("")
        if view.why:
            self.terminal.say(f"Asked anew: {view.why}")
        for line in plan_lines(view):
            self.terminal.say(line)
        self._shown = request.fingerprint

    def _ask_plan(self, request: ApprovalRequest) -> ApprovalAnswer:
        prompt = f"{request.code}: [a]pprove all, [s]tep by step, [r]eject, [h]old: "
        if request.is_single:
            prompt = f"{request.code}: [a]pprove this step, [r]eject, [h]old: "
        match self._choose(prompt, "arh" if request.is_single else "asrh"):
            case "a":
                return Approve(fingerprint=request.fingerprint, who=self.who)
            case "s":
                self.mode = ApprovalMode.STEP
                return self._ask_step(request)
            case "r":
                return self._reject(step=0)
            case _:
                return self._hold()

    def _ask_step(self, request: ApprovalRequest) -> ApprovalAnswer:
        step = next(s for s in request.proposal.steps if s.number == request.next_step)
        words = narrate(step.call, self.labels)
        self.terminal.say("")
        self.terminal.say(
            f"Step {step.number} of {len(request.proposal.steps)}: {words} "
            f"({in_seconds(step.duration_s)}, closest {in_millimetres(step.closest_distance_m)})"
        )
        while True:
            prompt = f"{request.code}: [a]pprove, [o]ther action, [r]eject, [h]old: "
            match self._choose(prompt, "aorh"):
                case "a":
                    scope = Scope(ScopeKind.STEP, step.number)
                    return Approve(fingerprint=request.fingerprint, who=self.who, scope=scope)
                case "o":
                    other = self._other(request.alternatives(), request)
                    if other is not None:
                        return other
                case "r":
                    return self._reject(step=step.number)
                case _:
                    return self._hold()

    def _other(
        self, alternatives: Sequence[Alternative], request: ApprovalRequest
    ) -> DoInstead | None:
        planned = next(s.call for s in request.proposal.steps if s.number == request.next_step)
        ways = [a for a in alternatives if a.call != planned]
        if not ways:
            self.terminal.say("Nothing else can be done now.")
            return None
        self.terminal.say("Possible now instead (the plan is made anew afterwards):")
        for line in alternative_lines(ways, self.labels):
            self.terminal.say(line)
        keys = [str(n) for n in range(1, len(ways) + 1)]
        key = self._choose(f"Number 1-{len(ways)}, or [b]ack: ", [*keys, "b"])
        if key is None or key == "b":
            return None
        return DoInstead(who=self.who, call=ways[int(key) - 1].call)

    def _reject(self, *, step: int) -> ApprovalAnswer:
        for number, words in enumerate(_REASON_WORDS, start=1):
            self.terminal.say(f"  {number}. {words}")
        keys = [str(n) for n in range(1, len(REASONS) + 1)]
        key = self._choose(f"Why not? 1-{len(REASONS)}: ", keys)
        if key is None:
            return self._hold()
        detail = self.terminal.ask("In your own words (or Enter): ") or ""
        return Reject(who=self.who, reason=REASONS[int(key) - 1], detail=detail, step=step)

    def _hold(self) -> Hold:
        return Hold(who=self.who, reason="held at the terminal")

    def _choose(self, prompt: str, keys: Sequence[str] | dict[str, Answer | None]) -> str | None:
        """Ask until one of `keys` is typed; None if nobody types any more."""
        while True:
            typed = self.terminal.ask(prompt)
            if typed is None:
                return None
            if typed.lower() in tuple(keys):
                return typed.lower()
            self.terminal.say(f"{typed!r} is none of these; nothing was approved.")
