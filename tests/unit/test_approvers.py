"""The approval dialogue: what is typed, and what comes of it."""

from __future__ import annotations

import pytest

from builders_words import CALLS, LABELS, request
from sitewright.central_controller.ports import (
    Alternative,
    Answer,
    Approve,
    DoInstead,
    Hold,
    Question,
    Reject,
    Scope,
    ScopeKind,
)
from sitewright.foundation.ids import ComponentId, RunId
from sitewright.interaction_twin.approvers import (
    REASONS,
    ApprovalMode,
    AutoApprover,
    TerminalApprover,
)


class Typist:
    """Types a script; then the input has ended."""

    def __init__(self, *answers: str) -> None:
        self.answers, self.lines = list(answers), list[str]()

    def say(self, line: str) -> None:
        self.lines.append(line)

    def ask(self, prompt: str) -> str | None:
        self.lines.append(prompt)
        return self.answers.pop(0) if self.answers else None

    @property
    def text(self) -> str:
        return "\n".join(self.lines)


def approver(typist: Typist, mode: ApprovalMode = ApprovalMode.PLAN) -> TerminalApprover:
    return TerminalApprover(typist, LABELS, mode)


QUESTION = Question(
    question_id="q1",
    run=RunId("0001"),
    step=7,
    command_id="c7",
    call=CALLS[7],
    target=ComponentId("stud-1"),
    text="Was nail 1 of Transverse stud 1 driven?",
)


def test_auto_approves_the_whole_plan_and_knows_nothing_of_the_site() -> None:
    assert AutoApprover().ask(request()) == Approve(fingerprint="f" * 64, who="auto")
    assert AutoApprover().answer(QUESTION) is None


def test_a_plan_is_shown_once_and_asked_once() -> None:
    typist = Typist("a")
    assert approver(typist).ask(request()) == Approve(fingerprint="f" * 64, who="local")
    assert "12 steps" in typist.text
    assert "drives nail 2 of Transverse stud 1 with nailer" in typist.text


def test_only_a_clear_answer_approves() -> None:
    typist = Typist("", "yes", "ar", "asr", "A")
    answer = approver(typist).ask(request())
    assert isinstance(answer, Approve)
    assert typist.text.count("nothing was approved") == 4


@pytest.mark.parametrize("mode", [ApprovalMode.PLAN, ApprovalMode.STEP])
def test_the_end_of_the_input_holds_and_never_approves(mode: ApprovalMode) -> None:
    answer = approver(Typist(), mode).ask(request())
    assert isinstance(answer, Hold)


def test_step_mode_approves_one_step_at_a_time() -> None:
    asked = approver(Typist("a", "a"), ApprovalMode.STEP)
    first, second = asked.ask(request(next_step=1)), asked.ask(request(next_step=2))
    assert first == Approve(fingerprint="f" * 64, who="local", scope=Scope(ScopeKind.STEP, 1))
    assert second == Approve(fingerprint="f" * 64, who="local", scope=Scope(ScopeKind.STEP, 2))


def test_one_can_go_from_the_plan_to_step_by_step() -> None:
    typist = Typist("s", "a", "a")
    asked = approver(typist)
    answers = [asked.ask(request(next_step=n)) for n in (1, 2)]
    assert [a.scope.step for a in answers if isinstance(a, Approve)] == [1, 2]
    assert typist.text.count("12 steps") == 1, "the list is shown once"


def test_another_action_is_chosen_by_its_number() -> None:
    ways = [
        Alternative(call=CALLS[0]),
        Alternative(call=CALLS[7], price_s=3.0),
        Alternative(call=CALLS[11], leads_nowhere=True, note="it falls"),
    ]
    typist = Typist("o", "b", "o", "9", "1")
    answer = approver(typist, ApprovalMode.STEP).ask(request(alternatives=ways))
    assert answer == DoInstead(who="local", call=CALLS[7]), "the planned action is not listed"
    assert "leads nowhere: it falls" in typist.text


def test_without_another_action_one_is_asked_again() -> None:
    typist = Typist("o", "a")
    answer = approver(typist, ApprovalMode.STEP).ask(request())
    assert isinstance(answer, Approve)
    assert "Nothing else can be done now." in typist.text


def test_a_chosen_step_is_confirmed_once_even_in_step_mode() -> None:
    typist = Typist("o", "a")
    answer = approver(typist, ApprovalMode.STEP).ask(request(is_single=True))
    assert answer == Approve(fingerprint="f" * 64, who="local")
    assert "One chosen step for Transverse stud 1" in typist.text


@pytest.mark.parametrize(("number", "reason"), list(enumerate(REASONS, start=1)))
def test_a_rejection_has_a_reason_and_the_step(number: int, reason: str) -> None:
    typist = Typist("r", str(number), "too close to me")
    answer = approver(typist, ApprovalMode.STEP).ask(request(next_step=3))
    assert answer == Reject(who="local", reason=reason, detail="too close to me", step=3)


def test_a_rejection_in_plan_mode_is_about_the_whole_plan() -> None:
    answer = approver(Typist("r", "3", "")).ask(request())
    assert answer == Reject(who="local", reason="path-unsafe", detail="", step=0)


def test_why_it_is_asked_anew_is_said() -> None:
    typist = Typist("a", "a")
    asked = approver(typist)
    asked.ask(request())
    asked.ask(request(next_step=4, why="the approval was too old"))
    assert "Asked anew: the approval was too old" in typist.text


@pytest.mark.parametrize(
    ("typed", "answer"),
    [("d", Answer.DONE), ("n", Answer.NOT_DONE), ("p", Answer.PARTIAL), ("l", None)],
)
def test_a_question_is_settled_or_left_open(typed: str, answer: Answer | None) -> None:
    typist = Typist(typed)
    settled = approver(typist).answer(QUESTION)
    assert (None if settled is None else settled.answer) is answer
    assert QUESTION.text in typist.text
