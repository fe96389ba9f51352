"""Rules of a project about who may approve what, when, and how much at once."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from builders_serving import Served, approval, wait_for, waiting
from sitewright.app.project import SETTINGS, ProjectError, new_project
from sitewright.app.serving.history import history_of
from sitewright.app.serving.policy_file import policy_of
from sitewright.app.serving.users import new_user
from sitewright.central_controller.events import ApprovalGiven
from sitewright.interaction_twin.roles import Role
from sitewright.interaction_twin.web.pins import MOST_WRONG

BOX = {"center_m": [5.0, 0.0, 1.0], "size_m": [0.5, 0.5, 2.0], "yaw_rad": 0.3}


FIRST = {"kind": "step", "step": 1}
PIN = "471100"


def served_with(rules: str, folder: Path) -> tuple[Served, dict[str, str]]:
    """Return a server of a project with rules, and the tokens of its two supervisors."""
    project, users = new_project(folder / "project"), folder / "users.toml"
    (project / SETTINGS).write_text(f"[approval]\n{rules}\n", encoding="utf-8")
    tokens = {name: new_user(users, name, Role.SUPERVISOR) for name in ("ann", "ben")}
    return Served(project, users=users), tokens


@pytest.fixture(autouse=True)
def state_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def press(client: Any, plan: dict[str, Any], **changes: Any) -> tuple[int, str]:
    answer = client.post("/api/decisions", json=approval(plan, **changes))
    return answer.status_code, answer.json().get("error", "")


def _asks_about(step: int, state: dict[str, Any]) -> bool:
    return bool(state["phase"] == "waiting" and state["open"]["next_step"] == step)


def test_who_chose_or_drew_something_does_not_approve_what_comes_of_it(tmp_path: Path) -> None:
    server, tokens = served_with("prevent_self_review = true", tmp_path)
    with server as served:
        ann, ben = (served.user(name, token) for name, token in tokens.items())
        plan = waiting(ann)
        ways = ann.get(f"/api/proposals/{plan['fingerprint']}/alternatives").json()
        call = {k: ways["feasible"][0][k] for k in ("skill", "robot", "arguments")}
        chosen = {"verb": "instead", "fingerprint": plan["fingerprint"], "key": "the-choice"}
        assert ann.post("/api/decisions", json={**chosen, "call": call}).status_code == 200
        single = waiting(ann, other_than=plan["fingerprint"])
        refused = ann.post("/api/decisions", json=approval(single))
        assert (refused.status_code, refused.json()["error"]) == (403, "self-review")
        assert refused.json()["message"].startswith("ann asked for what this plan does")
        assert press(ben, single) == (200, "")
        after = waiting(ben, other_than=single["fingerprint"])

        drawn = {"verb": "zone", "zone": BOX, "key": "the-drawing"}
        assert ben.post("/api/decisions", json=drawn).status_code == 200
        around = waiting(ben, other_than=after["fingerprint"])
        assert press(ben, around) == (403, "self-review")
        step = {"kind": "step", "step": 1}
        assert press(ann, around, scope=step) == (200, "")
        wait_for(ann, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 2)
        rest = ann.get("/api/proposals/open").json()
        assert press(ben, rest) == (403, "self-review")  # it is still his plan
        assert press(ann, rest) == (200, "")
        new = waiting(ben, other_than=around["fingerprint"])
        assert press(ben, new) == (200, "")  # nobody wished anything since


def test_the_first_of_each_type_are_approved_step_by_step_and_soon_started(tmp_path: Path) -> None:
    rules = "step_by_step_first_n_of_type = 1\nmax_unstarted_minutes = 0.5"
    server, tokens = served_with(rules, tmp_path)
    with server as served:
        ann = served.user("ann", tokens["ann"])
        plan = waiting(ann)
        refused = ann.post("/api/decisions", json=approval(plan))
        assert (refused.status_code, refused.json()["error"]) == (403, "step-by-step")
        assert "approve step 1 by itself" in refused.json()["message"]
        assert press(ann, plan, scope={"kind": "until", "step": 2})[0] == 403
        for number in range(1, len(plan["steps"]) + 1):
            if number > 1:
                wait_for(ann, partial(_asks_about, number))
            now = ann.get("/api/proposals/open").json()
            assert press(ann, now, scope={"kind": "step", "step": number}) == (200, "")
        for stud in ("stud-2", "stud-3"):  # others of the same type
            plan = waiting(ann, other_than=plan["fingerprint"])
            assert plan["target"] == stud
            assert press(ann, plan) == (200, "")
        plan = waiting(ann, other_than=plan["fingerprint"])
        assert plan["target"] == "support-1"
        assert press(ann, plan) == (403, "step-by-step")
    given = [
        r.stamped.event.approval
        for r in history_of(served.folder / "runs")
        if isinstance(r.stamped.event, ApprovalGiven)
    ]
    assert {a.start_before_utc_ns - a.given_utc_ns for a in given} == {30_000_000_000}


@pytest.fixture
def shared(tmp_path: Path) -> Iterator[tuple[Served, dict[str, str]]]:
    """Serve a project to a tablet that an operator and a viewer share; with their tokens."""
    project, users = new_project(tmp_path / "project"), tmp_path / "users.toml"
    (project / SETTINGS).write_text("[approval]\npin = true\n", encoding="utf-8")
    tokens = {
        "tablet": new_user(users, "tablet", Role.VIEWER),
        "vera": new_user(users, "vera", Role.VIEWER, pin="2222"),
        "olga": new_user(users, "olga", Role.OPERATOR, pin=PIN),
    }
    assert PIN not in users.read_text(encoding="utf-8")
    with Served(project, users=users) as served:
        yield served, tokens
    journals = b"".join(f.read_bytes() for f in project.rglob("journal.db*"))
    assert PIN.encode() not in journals


def test_at_a_shared_tablet_each_decision_carries_the_pin_of_who_makes_it(
    shared: tuple[Served, dict[str, str]],
) -> None:
    served, tokens = shared
    page = served.user("tablet", tokens["tablet"])
    about = page.get("/api/session").json()
    assert (about["asks_pin"], about["people"]) == (True, ["olga", "vera"])
    assert "approve" in about["can"]  # somebody with a PIN may
    plan = waiting(page)
    assert press(page, plan, scope=FIRST) == (403, "pin")
    assert press(page, plan, scope=FIRST, by="olga", pin="2222") == (403, "pin")
    assert press(page, plan, scope=FIRST, by="nobody", pin="2222") == (403, "pin")
    assert press(page, plan, scope=FIRST, by="vera", pin="2222") == (403, "role")
    assert press(page, plan, scope=FIRST, by="olga", pin="12") == (422, "fields")
    body = approval(plan, by="olga", pin=PIN, scope=FIRST)
    first, again = (page.post("/api/decisions", json=body) for _ in range(2))
    assert (first.status_code, first.json()["who"]) == (200, "olga")
    assert again.json() == {**first.json(), "repeated": True}
    (entry,) = page.get("/api/audit").json()["entries"]
    assert entry["who"] == "olga"


def test_wrong_pins_lock_a_name_but_neither_a_hold_nor_a_program(
    shared: tuple[Served, dict[str, str]],
) -> None:
    served, tokens = shared
    page = served.user("tablet", tokens["tablet"])
    plan = waiting(page)
    for _ in range(MOST_WRONG):
        assert press(page, plan, by="olga", pin="0000") == (403, "pin")
    assert press(page, plan, by="olga", pin=PIN) == (429, "pin-locked")
    assert press(page, plan, by="vera", pin="2222") == (403, "role")  # others are not locked
    assert page.post("/api/hold", json={"key": "hold-needs-no-pin"}).status_code == 200
    wait_for(page, lambda s: s["phase"] == "held")
    own = served.guest(origin="", authorization=f"Bearer {tokens['olga']}")
    go = {"verb": "resume", "key": "a-program-has-its-token"}
    assert own.post("/api/decisions", json=go).status_code == 200


def test_where_no_pin_is_asked_none_is_taken(tmp_path: Path) -> None:
    server, tokens = served_with("", tmp_path)
    with server as served:
        ann = served.user("ann", tokens["ann"])
        assert press(ann, waiting(ann), by="ben", pin="1234") == (422, "fields")
        assert ann.get("/api/session").json()["asks_pin"] is False


@pytest.mark.parametrize("pin", ["123", "1234567890123", "12a4", "١٢٣٤"])
def test_a_pin_is_digits(pin: str, tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="4 to 12 digits"):
        new_user(tmp_path / "users.toml", "ann", Role.OPERATOR, pin=pin)


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"pin": True}, "pin needs people"),
        ({"prevent_self_review": True}, "prevent_self_review needs people"),
        ({"max_unstarted_minutes": 0.0}, "max_unstarted_minutes"),
        ({"max_unstarted_minutes": 600.0}, "max_unstarted_minutes"),
        ({"step_by_step_first_n_of_type": -1}, "step_by_step_first_n_of_type"),
        ({"prevent_self_reviews": True}, "prevent_self_reviews"),
    ],
)
def test_a_rule_that_is_none_or_cannot_hold_is_named(table: dict[str, Any], said: str) -> None:
    with pytest.raises(ProjectError, match=said):
        policy_of({"approval": table}, has_users=False)
