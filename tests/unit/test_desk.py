"""The desk: who is in time, who waits, and what is kept when a run stops."""

from __future__ import annotations

import pytest

from sitewright.app.serving.desk import Desk
from sitewright.app.serving.memory import Memory
from sitewright.central_controller.events import AnyEvent, RunFinished, RunHeld, RunResumed
from sitewright.errors import JournalError
from sitewright.interaction_twin.decisions import Decision, Reply, Signed
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.roles import Person, Role, Verb

ANN = Person(who="ann", role=Role.OPERATOR, session="s-1")


def signed(verb: Verb = Verb.RESUME, key: str = "key-1") -> Signed:
    return Signed(decision=Decision(verb=verb, key=key), person=ANN, body_sha256=f"{verb}{key}")


def stamped(event: AnyEvent) -> Stamped:
    return Stamped(at_utc_ns=1_000_000, event=event, number=7)


@pytest.mark.parametrize(
    "last", [RunHeld(reason="held", exit_code=7), RunFinished(is_complete=False)]
)
def test_a_resume_that_comes_while_a_stopped_run_tidies_up_counts(last: AnyEvent) -> None:
    desk, told = Desk(Memory(), waits_to_go=False), list[Reply]()
    desk.decide(signed(key="too-soon"), told.append)
    assert [r.status for r in told] == [409]
    desk.on_record("run-1", stamped(last))
    desk.decide(signed(), told.append)
    desk.run_ended(None, "The run is over.")
    assert len(told) == 1  # it waits for the next run
    assert desk.wait_to_go() == signed()
    desk.on_record("run-1", stamped(RunResumed(who="ann", decision=signed().record())))
    assert (told[-1].status, told[-1].body["who"], told[-1].body["n"]) == (200, "ann", 7)


@pytest.mark.parametrize(
    ("error", "status", "word"),
    [
        (None, 409, "not-asked"),
        (JournalError("disk full"), 503, "journal"),
        (OSError("gone"), 503, "run"),
    ],
)
def test_a_resume_of_a_run_that_did_not_begin_is_told(
    error: Exception | None, status: int, word: str
) -> None:
    desk, told = Desk(Memory()), list[Reply]()
    desk.decide(signed(), told.append)
    assert desk.wait_to_go() is not None
    desk.run_ended(error, "Every component is installed; nothing to do.")
    assert [(r.status, r.body["error"]) for r in told] == [(status, word)]
    desk.decide(signed(key="key-2"), told.append)  # and the desk waits again
    assert desk.wait_to_go() == signed(key="key-2")


def test_the_hold_of_a_run_that_stands_is_not_asked() -> None:
    desk = Desk(Memory())
    assert desk.hold(signed(Verb.HOLD)).body["error"] == "not-asked"
    assert desk.hold_asked() is None


def test_a_server_that_is_gone_holds_and_ends_the_waiting() -> None:
    desk = Desk(Memory())
    desk.quit()
    hold = desk.hold_asked()
    assert hold is not None
    assert hold.who == "the page's server"
    assert desk.wait_to_go() is None
