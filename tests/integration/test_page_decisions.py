"""People decide at a page: the first one wins, each press counts once, stale ones are refused."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest

from builders_serving import Served, approval, wait_for, waiting
from sitewright.app.run_folder import run_folders
from sitewright.journal.sqlite import read_records


@pytest.fixture
def served(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with Served(tmp_path / "project") as running:
        yield running


def journal(served: Served, kind: str) -> list[dict[str, Any]]:
    """Return what the journals of all runs say of one kind, from their files."""
    return [
        dict(record.value())
        for folder in run_folders(served.folder / "runs")
        for record in read_records(folder.journal)
        if record.kind == kind
    ]


def test_a_plan_is_seen_approved_and_built_and_the_journal_says_who_saw_what(
    served: Served,
) -> None:
    page = served.local()
    proposal = waiting(page)
    answer = page.post("/api/decisions", json=approval(proposal, comment="looks good"))
    assert answer.status_code == 200
    assert answer.json()["who"] == "local"
    wait_for(page, lambda s: s["progress"]["installed"] == 1)
    (given,) = journal(served, "approval_given")
    assert given["approval"]["fingerprint"] == proposal["fingerprint"]
    assert given["approval"]["comment"] == "looks good"
    assert given["decision"]["role"] == "admin"
    assert given["decision"]["shown"] == [s["words"] for s in proposal["steps"]]
    (entry,) = page.get("/api/audit").json()["entries"]
    assert (entry["who"], entry["verb"], entry["n"]) == ("local", "approve", answer.json()["n"])
    assert entry["shown"] == given["decision"]["shown"]


def test_what_is_previewed_is_what_runs(served: Served) -> None:
    page = served.local()
    proposal = waiting(page)
    shown = {s["number"]: [m["trajectory_sha256"] for m in s["motions"]] for s in proposal["steps"]}
    for digest in (d for digests in shown.values() for d in digests):
        blob = page.get(f"/api/blobs/{digest}")
        assert hashlib.sha256(blob.content).hexdigest() == digest
        assert "immutable" in blob.headers["cache-control"]
    page.post("/api/decisions", json=approval(proposal))
    waiting(page, other_than=proposal["fingerprint"])
    ran = {i["step"]: i["trajectories"] for i in journal(served, "skill_intent")}
    assert ran == shown
    assert sum(map(len, ran.values())) > 0


def test_a_double_tap_and_a_retry_are_one_decision(served: Served) -> None:
    page = served.local()
    body = approval(waiting(page))
    with ThreadPoolExecutor(4) as pool:
        answers = list(pool.map(lambda _: page.post("/api/decisions", json=body), range(4)))
    assert {a.status_code for a in answers} == {200}
    assert len({a.json()["n"] for a in answers}) == 1
    again = page.post("/api/decisions", json=body)
    assert (again.status_code, again.json()["repeated"]) == (200, True)
    assert len(journal(served, "approval_given")) == 1
    other = page.post("/api/decisions", json={**body, "scope": {"kind": "step", "step": 1}})
    assert (other.status_code, other.json()["error"]) == (422, "key-reused")
    assert len(journal(served, "approval_given")) == 1


def test_of_two_operators_at_once_one_wins_and_the_other_learns_who(served: Served) -> None:
    page = served.local()
    proposal = waiting(page)
    bodies = [approval(proposal), approval(proposal)]
    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(lambda b: page.post("/api/decisions", json=b), bodies))
    assert sorted(a.status_code for a in answers) == [200, 409]
    (loser,) = [a.json() for a in answers if a.status_code == 409]
    assert loser["error"] == "decided"
    assert loser["who"] == "local"
    assert loser["message"].startswith("local approved this plan")
    assert len(journal(served, "approval_given")) == 1


def test_a_stale_decision_is_refused_with_the_difference(served: Served) -> None:
    page = served.local()
    old = waiting(page)
    rejected = {
        "verb": "reject",
        "fingerprint": old["fingerprint"],
        "reason": "later",
        "key": "first-rejection",
    }
    assert page.post("/api/decisions", json=rejected).status_code == 200
    new = waiting(page, other_than=old["fingerprint"])
    late = page.post("/api/decisions", json=approval(old))
    assert late.status_code == 409
    assert late.json()["error"] == "decided"
    unknown = page.post("/api/decisions", json=approval({**old, "fingerprint": "0" * 64}))
    assert unknown.json()["error"] == "stale"
    assert unknown.json()["open"]["code"] == new["code"]
    assert journal(served, "approval_given") == []


def test_step_by_step_releases_one_step_each(served: Served) -> None:
    page = served.local()
    proposal = waiting(page)
    first = approval(proposal, scope={"kind": "step", "step": 1})
    assert page.post("/api/decisions", json=first).status_code == 200
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 2)
    assert len(journal(served, "skill_intent")) == 1
    again = page.post("/api/decisions", json={**first, "key": "another-key"})
    assert (again.status_code, again.json()["error"]) == (409, "decided")
    until = approval(page.get("/api/proposals/open").json(), scope={"kind": "until", "step": 3})
    assert page.post("/api/decisions", json=until).status_code == 200
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 4)
    assert [i["step"] for i in journal(served, "skill_intent")] == [1, 2, 3]


def test_another_action_becomes_a_proposal_of_one_step(served: Served) -> None:
    page = served.local()
    proposal = waiting(page)
    ways = page.get(f"/api/proposals/{proposal['fingerprint']}/alternatives").json()
    (way,) = ways["feasible"]
    call = {k: way[k] for k in ("skill", "robot", "arguments")}
    body = {"verb": "instead", "fingerprint": proposal["fingerprint"], "key": "instead-key"}
    wrong = page.post("/api/decisions", json={**body, "call": {**call, "arguments": ["moon"]}})
    assert (wrong.status_code, wrong.json()["error"]) == (409, "not-feasible")
    assert page.post("/api/decisions", json={**body, "call": call}).status_code == 200
    single = waiting(page, other_than=proposal["fingerprint"])
    assert single["is_single"]
    assert [s["arguments"] for s in single["steps"]] == [["lookout"]]


def test_a_hold_stops_the_run_and_resume_goes_on(served: Served) -> None:
    page = served.local()
    waiting(page)
    held = page.post("/api/hold", json={"key": "hold-key", "reason": "somebody is inside"})
    assert held.status_code == 200
    state = wait_for(page, lambda s: s["phase"] == "held")
    assert state["held"]["reason"] == "local holds the run: somebody is inside"
    assert page.post("/api/hold", json={"key": "hold-key-2"}).json()["error"] == "not-asked"
    go = {"verb": "resume", "key": "resume-key"}
    assert page.post("/api/decisions", json=go).status_code == 200
    assert waiting(page)["status"] == "waiting"
    (resumed,) = journal(served, "run_resumed")
    assert (resumed["who"], resumed["decision"]["verb"]) == ("local", "resume")


def test_nothing_is_decided_when_the_journal_cannot_be_written(
    served: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sitewright.journal.errors import JournalFullError
    from sitewright.journal.sqlite import SqliteJournal

    page = served.local()
    proposal = waiting(page)

    def full(journal: SqliteJournal, entry: object) -> None:
        del entry
        raise JournalFullError(journal.path, "no space left on device")

    monkeypatch.setattr(SqliteJournal, "append", full)
    answer: httpx.Response = page.post("/api/decisions", json=approval(proposal))
    assert (answer.status_code, answer.json()["error"]) == (503, "journal")
    assert "nothing decided" in answer.json()["message"]
    assert journal(served, "approval_given") == []
    assert wait_for(page, lambda s: s["phase"] == "broken")["words"]


def test_a_hold_is_taken_though_the_journal_cannot_be_written(
    served: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The robots come first, the record after; that it is missing is told as well."""
    from sitewright.journal.errors import JournalFullError
    from sitewright.journal.sqlite import SqliteJournal

    page = served.local()
    waiting(page)

    def full(journal: SqliteJournal, entry: object) -> None:
        del entry
        raise JournalFullError(journal.path, "no space left on device")

    monkeypatch.setattr(SqliteJournal, "append", full)
    assert page.post("/api/hold", json={"key": "hold-key"}).status_code == 200
    state = wait_for(page, lambda s: s["phase"] == "broken")
    assert "no space left on device" in state["words"]
    assert journal(served, "skill_intent") == []


def test_only_a_person_settles_an_unknown_outcome_and_the_journal_says_who(
    served: Served,
) -> None:
    """A nail that is reported as driven and is not sensed is a question, never a guess."""
    page = served.local()
    support = waiting(page)
    page.post("/api/decisions", json=approval(support))
    second = waiting(page, other_than=support["fingerprint"])
    page.post("/api/decisions", json=approval(second))
    stud = waiting(page, other_than=second["fingerprint"])
    served.site.pretend.add("fasten")
    page.post("/api/decisions", json=approval(stud))
    state = wait_for(page, lambda s: s["phase"] == "question")
    question = state["question"]
    answer = {"verb": "answer", "key": "the-answer", "question_id": question["question_id"]}
    wrong = page.post("/api/decisions", json={**answer, "question_id": "x", "answer": "done"})
    assert (wrong.status_code, wrong.json()["error"]) == (409, "not-asked")
    assert page.post("/api/decisions", json={**answer, "answer": "done"}).status_code == 200
    (answered,) = journal(served, "question_answered")
    assert (answered["who"], answered["answer"]) == ("local", "done")
    assert answered["decision"]["role"] == "admin"


def test_a_question_outlives_the_server_and_is_answered_while_the_run_stands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with Served(tmp_path / "project") as served:
        page = served.local()
        for _ in range(2):
            support = waiting(page)
            page.post("/api/decisions", json=approval(support))
            stud = waiting(page, other_than=support["fingerprint"])
        served.site.pretend.add("fasten")
        page.post("/api/decisions", json=approval(stud))
        asked = wait_for(page, lambda s: s["phase"] == "question")["question"]
    lives = served.site.lives
    with Served(tmp_path / "project") as served:
        served.site.lives = lives  # ids go on where they were
        page = served.local()
        again = wait_for(page, lambda s: s["phase"] == "question")
        assert again["question"] == asked
        answer = {"verb": "answer", "key": "the-answer", "answer": "not-done"}
        other = page.post("/api/decisions", json={**answer, "question_id": "x"})
        assert (other.status_code, other.json()["error"]) == (409, "not-asked")
        told = page.post("/api/decisions", json={**answer, "question_id": asked["question_id"]})
        assert told.status_code == 200, told.text
        assert waiting(page)["fingerprint"] != stud["fingerprint"]
    (answered,) = journal(served, "question_answered")
    assert (answered["answer"], answered["decision"]["key"]) == ("not-done", "the-answer")
