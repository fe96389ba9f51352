"""Several people at several screens, and fingers that slip: each press counts once, or not."""

from __future__ import annotations

import json
import secrets
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import pytest
from playwright.sync_api import Browser, Route, expect

from builders_page import WAIT_MS, Seen, ServedProject, browser, look
from sitewright.app.project import SETTINGS, new_project
from sitewright.app.run_folder import run_folders
from sitewright.app.serving.users import new_user
from sitewright.interaction_twin.roles import Role
from sitewright.journal.sqlite import read_records

POLICY = '[approval]\ntwo_person = ["zone"]\nlook_below_mm = 0\n'
STEP = ".approve[data-scope=step]"
_WATCH = """selector => {
  window.__hints = [];
  new MutationObserver(() => {
    const hint = document.querySelector(selector + ' small')?.textContent;
    if (hint !== undefined && hint !== __hints.at(-1)) __hints.push(hint);
  }).observe(document.body, { subtree: true, childList: true, characterData: true });
}"""


@dataclass(frozen=True)
class Crew:
    """Two supervisors before the same plan, one of them with a tablet."""

    served: ServedProject
    ann: Seen
    ben: Seen

    def approvals(self) -> list[dict[str, Any]]:
        """Return all approvals from the journals' files."""
        return [
            dict(record.value())
            for folder in run_folders(self.served.folder / "runs")
            for record in read_records(folder.journal)
            if record.kind == "approval_given"
        ]

    def both_armed(self) -> dict[str, Any]:
        """Wait until both may approve the same step; return the plan."""
        self.ann.until(lambda s: s["phase"] in {"waiting", "idle", "held"})
        if self.ann.json("/api/state")["phase"] != "waiting":
            self.ann.page.click(".resume")
        self.ann.until(lambda s: s["phase"] == "waiting")
        plan = self.ann.json("/api/proposals/open")
        for seen in (self.ann, self.ben):
            note = f"{STEP} small >> text=step {plan['next_step']} only"
            seen.page.wait_for_selector(f"{STEP}[data-fingerprint='{plan['fingerprint']}']")
            seen.page.wait_for_selector(note)
            seen.armed()
        return plan


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as running:
        yield running


@pytest.fixture(scope="module")
def crew(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Crew]:
    place = tmp_path_factory.mktemp("people")
    folder, users = new_project(place / "frame"), place / "users.toml"
    (folder / SETTINGS).write_text(POLICY, encoding="utf-8")
    tokens = {name: new_user(users, name, Role.SUPERVISOR) for name in ("ann", "ben")}
    with ServedProject(folder, users=users) as served:
        ann, ben = look(chromium, served), look(chromium, served, width=820, has_touch=True)
        ann.sign_in("ann", tokens["ann"])
        ben.sign_in("ben", tokens["ben"])
        yield Crew(served, ann, ben)


def test_of_two_who_press_at_once_one_counts_and_the_other_reads_who_it_was(crew: Crew) -> None:
    crew.both_armed()
    before = crew.approvals()
    on_the_way: list[Route] = []

    def keep(route: Route) -> None:
        on_the_way.append(route)

    for seen in (crew.ann, crew.ben):
        seen.page.route("**/api/decisions", keep)
        with seen.page.expect_request("**/api/decisions"):
            seen.page.click(STEP)
    for route in on_the_way:
        route.continue_()
    for seen in (crew.ann, crew.ben):
        seen.page.unroute("**/api/decisions")
        seen.page.wait_for_selector(".result", timeout=WAIT_MS)
    (given,) = crew.approvals()[len(before) :]
    winner = given["approval"]["who"]
    won, lost = (crew.ann, crew.ben) if winner == "ann" else (crew.ben, crew.ann)
    expect(won.page.locator(".result.good")).to_have_text(f"Recorded: approved by {winner}")
    expect(lost.page.locator(".result.bad")).to_contain_text(f"{winner} approved this plan already")


def test_a_double_tap_is_one_approval_and_the_next_step_rests_first(crew: Crew) -> None:
    plan = crew.both_armed()
    before, sent, page = crew.approvals(), len(crew.ben.sent), crew.ben.page
    page.evaluate(_WATCH, STEP)
    page.evaluate("s => { const b = document.querySelector(s); b.click(); b.click() }", STEP)
    page.wait_for_selector(".result.good", timeout=WAIT_MS)
    crew.both_armed()
    assert len(crew.ben.sent) == sent + 1
    (given,) = crew.approvals()[len(before) :]
    assert given["approval"]["scope"]["step"] == plan["next_step"]
    assert given["approval"]["who"] == "ben"
    hints: list[str] = page.evaluate("() => __hints")
    is_next = f"step {plan['next_step'] + 1} only"  # a tap that comes late finds it at rest
    assert hints.index("Being recorded") < hints.index("Just changed") < hints.index(is_next)


def test_a_finger_on_a_tablet_approves_what_it_taps(crew: Crew) -> None:
    crew.both_armed()
    before = crew.approvals()
    box = crew.ben.page.locator(STEP).bounding_box()
    assert box is not None
    with crew.ben.page.expect_response("**/api/decisions"):
        crew.ben.page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(crew.ben.page.locator(".result.good")).to_have_text("Recorded: approved by ben")
    assert len(crew.approvals()) == len(before) + 1


def test_an_answer_that_got_lost_can_be_asked_for_again_and_counts_once(crew: Crew) -> None:
    crew.both_armed()
    page, before, sent = crew.ann.page, crew.approvals(), len(crew.ann.sent)

    def lose(route: Route) -> None:
        assert route.fetch().ok  # the server has decided; nobody hears of it
        route.abort()

    page.route("**/api/decisions", lose)
    page.click(STEP)
    expect(page.locator(".result.bad")).to_contain_text("Nobody knows yet")
    assert len(crew.approvals()) == len(before) + 1
    page.unroute("**/api/decisions")
    page.click(".result.bad button")
    expect(page.locator(".result.good")).to_have_text("Recorded: approved by ann")
    first, second = crew.ann.sent[sent:]
    assert json.loads(first) == json.loads(second)
    assert len(crew.approvals()) == len(before) + 1


def test_a_plan_that_is_swapped_under_the_finger_is_not_approved(crew: Crew) -> None:
    old = crew.both_armed()
    page, before, sent = crew.ann.page, crew.approvals(), len(crew.ann.sent)
    page.hover(STEP)
    page.mouse.down()
    rejected = {
        "verb": "reject",
        "fingerprint": old["fingerprint"],
        "reason": "path-unsafe",
        "key": secrets.token_hex(16),
    }
    assert crew.ben.post("/api/decisions", rejected)[0] == 200
    new = crew.ann.waiting(other_than=old["fingerprint"])
    crew.ann.armed()  # also when the finger rests until the new plan might be approved
    page.mouse.up()
    page.wait_for_function("() => new Promise((r) => setTimeout(() => r(true)))")
    asked = [json.loads(body)["fingerprint"] for body in crew.ann.sent[sent:]]
    assert new["fingerprint"] not in asked
    assert crew.approvals() == before
    crew.ann.press(STEP)
    expect(page.locator(".result.good")).to_have_text("Recorded: approved by ann")
    (given,) = crew.approvals()[len(before) :]
    assert given["approval"]["fingerprint"] == new["fingerprint"]


def test_where_two_must_agree_the_first_is_noted_and_the_second_decides(crew: Crew) -> None:
    plan = crew.both_armed()
    for seen in (crew.ann, crew.ben):
        seen.page.click(".acts > button >> nth=1")
        seen.page.click("dialog footer button >> text=Draw a keep-out zone")
        seen.page.fill("dialog.beside input >> nth=0", "5.5")
        with seen.page.expect_response("**/api/decisions") as answer:
            seen.page.click("dialog.beside button[type=submit]")
        if seen is crew.ann:
            assert answer.value.status == 202
            noted = "Noted. A second person must decide the same."
            expect(seen.page.locator(".result.good")).to_have_text(noted)
            assert crew.ann.json("/api/proposals/open")["fingerprint"] == plan["fingerprint"]
    assert answer.value.status == 200
    crew.ben.waiting(other_than=plan["fingerprint"])
    (entry,) = [e for e in crew.ann.json("/api/audit")["entries"] if e["verb"] == "zone"]
    assert (entry["who"], entry["second"]) == ("ben", "ann")
    (drawn,) = [z for z in crew.ann.json("/api/scene")["zones"] if z["id"] == "keep-out-1"]
    assert (drawn["by"], drawn["world_T"]["p_m"][0]) == ("ben", 5.5)


def test_a_hold_gets_through_while_the_preview_plays(crew: Crew) -> None:
    crew.both_armed()
    page = crew.ann.page
    page.click(".modes button >> nth=1")
    page.click(".transport .play")
    page.click(".hold")
    held = crew.ann.until(lambda s: s["phase"] == "held")
    assert held["held"]["reason"] == "ann holds the run."
    page.wait_for_selector(".headline.held", timeout=WAIT_MS)
    page.click(".modes button >> nth=0")
    crew.both_armed()


def test_a_hold_is_in_reach_while_a_dialog_is_open(crew: Crew) -> None:
    crew.both_armed()
    page = crew.ann.page
    page.click(".acts > button >> nth=0")
    page.click("dialog[open] .hold-here")
    crew.ann.until(lambda s: s["phase"] == "held")
    expect(page.locator("dialog[open]")).to_have_count(0)  # there is no plan to reject any more
    crew.both_armed()
