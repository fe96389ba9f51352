"""What the machine cannot know a person says on the page: an outcome, and work done by hand."""

from __future__ import annotations

import secrets
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, expect

from builders_page import WAIT_MS, Seen, ServedProject, browser, look
from builders_site import NAILS_PER_STUD, RealSite
from sitewright.central_controller.events import OperationDone, QuestionAnswered, SkillReconciled

SLOW = 1.0
"""Simulated seconds per second: a nail takes long enough to be killed in."""


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as running:
        yield running


@pytest.fixture
def site(tmp_path: Path) -> Iterator[RealSite]:
    made = RealSite.of(tmp_path, studs=1)
    yield made
    made.clean_up()


def approve(seen: Seen, scope: Callable[[dict[str, Any]], dict[str, Any]] | None = None) -> int:
    """Approve the open plan as another tablet would; return the last step that was approved."""
    while True:
        seen.until(lambda s: s["phase"] == "waiting")
        plan = seen.json("/api/proposals/open")
        wanted = {"kind": "plan"} if scope is None else scope(plan)
        body = {
            "verb": "approve",
            "fingerprint": plan["fingerprint"],
            "next_step": plan["next_step"],
            "scope": wanted,
            "key": secrets.token_hex(8),
        }
        status, told = seen.post("/api/decisions", body)
        if status == 200:
            return int(wanted.get("step", len(plan["steps"])))
        assert told["error"] in {"stale", "decided", "not-asked"}  # it was just being made anew


def built_until(seen: Seen, skill: str, off: int) -> None:
    """Build both supports, and the stud up to so many steps off its first skill of a kind."""
    for installed in (1, 2):
        approve(seen)
        seen.until(lambda s, n=installed: s["progress"]["installed"] == n)  # type: ignore[misc]

    def until(plan: dict[str, Any]) -> dict[str, Any]:
        first = next(s["number"] for s in plan["steps"] if s["skill"] == skill)
        return {"kind": "until", "step": first + off}

    last = approve(seen, until)
    seen.until(lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == last + 1)


def opened(chromium: Browser, served: ServedProject) -> Seen:
    seen = look(chromium, served)
    seen.open(dots=0.5)
    phase = seen.until(lambda s: s["phase"] in {"waiting", "idle", "held"})["phase"]
    if phase != "waiting":
        go = {"verb": "resume", "key": secrets.token_hex(8)}
        assert seen.post("/api/decisions", go)[0] == 200
    return seen


def test_a_nail_that_was_cut_off_is_asked_about_and_answered_on_the_page(
    chromium: Browser, site: RealSite
) -> None:
    with ServedProject(site.project) as served:
        seen = opened(chromium, served)
        built_until(seen, "fasten", -1)
        served.end(signal.SIGINT)
        served.speed = SLOW  # the cell starts again with it
        served.start()
        _kill_at_a_nail(chromium, served, site)
        seen = look(chromium, served)
        seen.open(dots=0.5)
        asked = seen.until(lambda s: s["phase"] == "question")["question"]
        is_driven = any(f" {e['operation']} " in asked["text"] for e in site.physical("fastener"))
        seen.page.wait_for_selector(".trouble button", timeout=WAIT_MS)
        expect(seen.page.locator(".trouble h2")).to_have_text("Did it happen?")
        expect(seen.page.locator(".trouble p")).to_contain_text("its end is not recorded")
        assert seen.page.locator(".approve").count() == 0
        truth = "Yes, it is done" if is_driven else "No, it is not done"
        seen.page.click(f".trouble button >> text={truth}")
        expect(seen.page.locator(".result.good")).to_have_text("Recorded: local")
        seen.waiting()
        approve(seen)
        seen.until(lambda s: s["progress"]["installed"] == 3)
    events = site.events()
    (answered,) = [e for e in events if isinstance(e, QuestionAnswered)]
    assert (answered.who, answered.answer) == ("local", "done" if is_driven else "not-done")
    verdicts = [e.verdict for e in events if isinstance(e, SkillReconciled)]
    assert verdicts.count("unknown") == 1
    nails = [e["operation"] for e in site.physical("fastener")]
    assert len(set(nails)) == len(nails) == NAILS_PER_STUD  # none twice, none missing


def _kill_at_a_nail(chromium: Browser, served: ServedProject, site: RealSite) -> None:
    """Kill the cell in the middle of a nail, and the server as soon as the question is asked."""
    seen = opened(chromium, served)
    approve(seen)
    killed_at = 0
    while seen.json("/api/state")["phase"] != "question":
        lines = site.cell_lines()
        if lines > killed_at and site.last_cell_record().get("skill") == "fasten":
            killed_at = lines  # should it have ended just before, the next one is cut off
            site.kill_cell()
        seen.page.wait_for_timeout(5)
    served.end(signal.SIGKILL)
    seen.page.wait_for_selector(".banner.lost", timeout=WAIT_MS)
    seen.page.context.close()
    served.start()


def test_work_by_hand_is_ticked_off_one_effect_at_a_time(chromium: Browser, site: RealSite) -> None:
    with ServedProject(site.project) as served:
        seen = opened(chromium, served)
        built_until(seen, "position", 0)
        page = seen.page
        page.click(".tabs button >> nth=1")
        page.click(".layer .name >> text=Transverse stud 1")
        page.click(".card button >> text=Does not match the site")
        page.click("dialog button[type=submit]")
        page.wait_for_selector(".headline.held", timeout=WAIT_MS)
        page.click(".tabs button >> nth=0")
        page.click(".trouble button >> text=Say which of its work was done by hand")
        ticks = page.locator("dialog .choices input")
        expect(ticks).to_have_count(1 + NAILS_PER_STUD)
        expect(page.locator("dialog button[type=submit]")).to_be_disabled()
        for label in page.locator("dialog .choices label").all():
            label.click()
        page.click("dialog button[type=submit]")
        expect(page.locator(".result.good")).to_have_text("Recorded: local")
        seen.until(lambda s: s["progress"]["installed"] == 3)
        assert seen.complaints == []
    done = [e for e in site.events() if isinstance(e, OperationDone)]
    assert {(e.target, e.by) for e in done} == {("stud-1", "person")}
    assert len(done) == NAILS_PER_STUD
    assert site.physical("fastener") == []
