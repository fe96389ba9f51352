"""Rules of a project about who may approve what, when, and how much at once."""

from __future__ import annotations

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

BOX = {"center_m": [5.0, 0.0, 1.0], "size_m": [0.5, 0.5, 2.0], "yaw_rad": 0.3}


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


@pytest.mark.parametrize(
    ("table", "said"),
    [
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
