"""Beside the plan: keep-out zones, work by hand, a model that does not match, two-person rules."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from builders_planning import SUPPORT_1, Rehearsal
from builders_serving import Served, approval, wait_for, waiting
from sitewright.app.project import new_project
from sitewright.app.serving.history import history_of
from sitewright.app.serving.users import new_user
from sitewright.central_controller.events import OperationDone
from sitewright.central_controller.ports import DrawZone, StillClear
from sitewright.central_controller.rehearsal import after_step
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.steering import steered
from sitewright.central_controller.zoned import ZonedProposals
from sitewright.foundation.pose import translation
from sitewright.interaction_twin.roles import Role
from sitewright.planning_twin.refusal import StaleCertificate

BOX = {"center_m": [5.0, 0.0, 1.0], "size_m": [0.5, 0.5, 2.0], "yaw_rad": 0.3}


@pytest.fixture
def served(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with Served(tmp_path / "project") as running:
        yield running


def kinds(served: Served) -> list[str]:
    return [r.stamped.event.kind for r in history_of(served.folder / "runs")]


def decide(page: Any, verb: str, **content: Any) -> Any:
    body = {"verb": verb, "key": f"key-of-{verb}-{content}"[:100], **content}
    return page.post("/api/decisions", json=body)


def test_a_drawn_zone_voids_the_plan_and_is_drawn_until_it_is_taken_away(served: Served) -> None:
    page = served.local()
    old = waiting(page)
    answer = decide(page, "zone", zone=BOX, fingerprint=old["fingerprint"])
    assert answer.status_code == 200, answer.text
    new = waiting(page, other_than=old["fingerprint"])
    late = page.post("/api/decisions", json=approval(old))
    assert (late.status_code, late.json()["error"]) == (409, "stale")
    assert late.json()["why"] == "local drew a keep-out zone."
    assert late.json()["open"]["fingerprint"] == new["fingerprint"]
    assert late.json()["changed"]
    zones = {z["id"]: z for z in page.get("/api/scene").json()["zones"]}
    assert zones["keep-out-1"]["by"] == "local"
    assert zones["keep-out-1"]["world_T"]["p_m"] == BOX["center_m"]
    assert decide(page, "zone", zone={"remove": "keep-out-7"}).status_code == 422
    assert decide(page, "zone", zone={"remove": "walkway"}).status_code == 422
    assert decide(page, "zone", zone={"remove": "keep-out-1"}).status_code == 200
    waiting(page, other_than=new["fingerprint"])
    zones = {z["id"]: z for z in page.get("/api/scene").json()["zones"]}
    assert set(zones) == {"walkway"}
    assert kinds(served).count("proposal_superseded") == 2


@pytest.mark.parametrize(
    "zone",
    [
        {},
        {"center_m": [0, 0, 0]},
        {"center_m": [0, 0, 0], "size_m": [1, 1, 0]},
        {"center_m": [0, 0], "size_m": [1, 1, 1]},
        {"center_m": [0, 0, 1e9], "size_m": [1, 1, 1]},
        {"center_m": [0, 0, 0], "size_m": [1, 1, 1], "remove": "keep-out-1"},
    ],
)
def test_a_zone_that_is_none_is_refused(served: Served, zone: dict[str, Any]) -> None:
    page = served.local()
    waiting(page)
    answer = decide(page, "zone", zone=zone)
    assert (answer.status_code, answer.json()["error"]) == (422, "fields")


def test_a_zone_may_be_drawn_while_the_run_stands_and_comes_first(served: Served) -> None:
    page = served.local()
    waiting(page)
    page.post("/api/hold", json={"key": "hold-for-zone"})
    wait_for(page, lambda s: s["phase"] == "held")
    assert decide(page, "zone", zone=BOX).status_code == 200
    waiting(page)
    after = kinds(served)
    assert after[after.index("run_resumed") + 1] == "zone_drawn"


def test_what_does_not_match_the_site_holds_the_run_for_a_look(served: Served) -> None:
    page = served.local()
    proposal = waiting(page)
    answer = decide(page, "mismatch", component="support-2", detail="it is 30 mm to the left")
    assert answer.status_code == 200, answer.text
    state = wait_for(page, lambda s: s["phase"] == "held")
    assert "does not match the site, says local: it is 30 mm to the left" in state["words"]
    (trouble,) = state["trouble"]
    assert (trouble["target"], trouble["blockers"]) == ("support-2", ["support-2"])
    assert [o["verb"] for o in trouble["options"]] == ["resume"]
    assert decide(page, "resume").status_code == 200
    assert waiting(page)["fingerprint"] != proposal["fingerprint"]


def test_work_by_hand_is_vouched_for_effect_by_effect(served: Served) -> None:
    page = served.local()
    support = waiting(page)
    page.post("/api/decisions", json=approval(support))
    second = waiting(page, other_than=support["fingerprint"])
    page.post("/api/decisions", json=approval(second))
    stud = waiting(page, other_than=second["fingerprint"])
    assert page.get(f"/api/manual/{stud['target']}").status_code == 404  # nothing is in place
    placing = next(s["number"] for s in stud["steps"] if s["skill"] == "position")
    until = approval(stud, scope={"kind": "until", "step": placing})
    assert page.post("/api/decisions", json=until).status_code == 200
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == placing + 1)
    checklist = page.get(f"/api/manual/{stud['target']}").json()
    assert checklist["effects"][0]["words"].endswith("stands by itself")
    facts = [e["fact"] for e in checklist["effects"]]
    wrong = decide(page, "manual", target=stud["target"], effects=["(done the-moon)"])
    assert (wrong.status_code, wrong.json()["possible"]) == (422, facts)
    answer = decide(page, "manual", target=stud["target"], effects=facts)
    assert answer.status_code == 200, answer.text
    state = wait_for(page, lambda s: s["progress"]["installed"] == 3)
    assert state["phase"] in {"planning", "waiting"}
    events = [r.stamped.event for r in history_of(served.folder / "runs")]
    done = [e for e in events if isinstance(e, OperationDone) and e.target == stud["target"]]
    assert {e.by for e in done} == {"person"}
    assert len(done) == len(facts) - 1


def test_work_by_hand_is_vouched_for_also_while_the_run_stands(served: Served) -> None:
    """A piece in place that does not match holds the run; what is said then comes first."""
    page = served.local()
    for _ in range(2):
        support = waiting(page)
        page.post("/api/decisions", json=approval(support))
        waiting(page, other_than=support["fingerprint"])
    stud = waiting(page)
    placing = next(s["number"] for s in stud["steps"] if s["skill"] == "position")
    until = approval(stud, scope={"kind": "until", "step": placing})
    assert page.post("/api/decisions", json=until).status_code == 200
    wait_for(page, lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == placing + 1)
    assert decide(page, "mismatch", component=stud["target"]).status_code == 200
    held = wait_for(page, lambda s: s["phase"] == "held")
    (trouble,) = held["trouble"]
    assert [o["verb"] for o in trouble["options"]] == ["resume", "manual"]
    facts = [e["fact"] for e in page.get(f"/api/manual/{stud['target']}").json()["effects"]]
    wrong = decide(page, "manual", target=stud["target"], effects=["(done the-moon)"])
    assert (wrong.status_code, wrong.json()["possible"]) == (422, facts)
    answer = decide(page, "manual", target=stud["target"], effects=facts)
    assert answer.status_code == 200, answer.text
    wait_for(page, lambda s: s["progress"]["installed"] == 3)
    after = kinds(served)
    assert after[after.index("run_resumed") + 1] == "done_by_hand"


def test_two_people_must_agree_where_the_policy_asks_for_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder, users = tmp_path / "project", tmp_path / "users.toml"
    new_project(folder)
    text = '[approval]\ntwo_person = ["zone"]\nsupervisor_below_mm = 50\n'
    (folder / "sitewright.toml").write_text(text, encoding="utf-8")
    tokens = {n: new_user(users, n, Role.SUPERVISOR) for n in ("ann", "ben")}
    tokens["op"] = new_user(users, "op", Role.OPERATOR)
    with Served(folder, users=users) as served:
        ann, ben, operator = (served.user(n, t) for n, t in tokens.items())
        proposal = waiting(ann)
        for _ in range(2):
            alone = decide(ann, "zone", zone=BOX)
            assert (alone.status_code, alone.json()["waiting_for"]) == (202, "second person")
        other = decide(ben, "zone", zone={**BOX, "yaw_rad": 0.4})
        assert other.status_code == 202  # not the same zone
        assert decide(ben, "zone", zone=BOX).status_code == 200
        proposal = waiting(ann, other_than=proposal["fingerprint"])
        (entry,) = [e for e in ann.get("/api/audit").json()["entries"] if e["verb"] == "zone"]
        assert (entry["who"], entry["second"]) == ("ben", "ann")
        low = operator.post("/api/decisions", json=approval(proposal))
        assert (low.status_code, low.json()["needs"]) == (403, "supervisor")
        assert "clearance 42 mm is under the policy's 50 mm" in low.json()["message"]
        _one_of_two_wins({"ann": ann, "ben": ben}, proposal)


def _one_of_two_wins(people: dict[str, Any], proposal: dict[str, Any]) -> None:
    """Let two people approve the same plan at once: the loser learns who was quicker."""

    def press(name: str) -> tuple[str, Any]:
        return name, people[name].post("/api/decisions", json=approval(proposal))

    with ThreadPoolExecutor(2) as pool:
        answers = dict(pool.map(press, people))
    (winner,) = [n for n, a in answers.items() if a.status_code == 200]
    (loser,) = [a for n, a in answers.items() if n != winner]
    assert (loser.status_code, loser.json()["error"]) == (409, "decided")
    assert loser.json()["who"] == winner


def test_a_drawn_zone_in_the_way_makes_a_certificate_stale(
    frame: Rehearsal,
) -> None:
    context, steps = frame.before[SUPPORT_1], frame.planned[SUPPORT_1].proposal.steps
    first = next(n for n, s in enumerate(steps) if s.motions)
    for done in steps[:first]:
        context = after_step(context, done, SUPPORT_1)
    step = steps[first]
    source = ZonedProposals(frame.proposals)
    assert isinstance(source.check(step, context), StillClear)
    base = frame.proposals.design.cell.robot_by_id[step.call.robot].world_T_base
    wish = DrawZone(who="ann", size_m=(0.4, 0.4, 0.4), world_T_zone=base @ translation(0, 0, 0.5))
    _, (drawn,) = steered(context.site, wish)
    zoned = type(context)(
        run=context.run,
        site=site_after(context.site, drawn),
        observation=context.observation,
    )
    assert zoned.site.serial == context.site.serial + 1
    answer = source.check(step, zoned)
    assert isinstance(answer, StaleCertificate)
    assert "keep-out-1" in answer.cause.pair
