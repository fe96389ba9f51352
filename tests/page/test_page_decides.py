"""People decide on the page: bound to what they read, once, and told the truth about it."""

from __future__ import annotations

import secrets
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Route, expect

from builders_page import WAIT_MS, Seen, ServedProject, browser, look
from sitewright.app.run_folder import run_folders
from sitewright.app.serving.users import new_user
from sitewright.interaction_twin.roles import Role
from sitewright.journal.sqlite import read_records


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as running:
        yield running


@pytest.fixture
def served(tmp_path: Path) -> Iterator[ServedProject]:
    with ServedProject(tmp_path / "frame") as running:
        yield running


def opened(chromium: Browser, served: ServedProject) -> Seen:
    """Return a page of the local user that shows a plan."""
    seen = look(chromium, served)
    seen.open(dots=0.5)
    if seen.json("/api/state")["phase"] == "idle":
        seen.page.click(".resume")
    seen.waiting()
    return seen


def events(served: ServedProject, kind: str) -> list[dict[str, Any]]:
    """Return what the journals say of one kind, from their files."""
    return [
        dict(record.value())
        for folder in run_folders(served.folder / "runs")
        for record in read_records(folder.journal)
        if record.kind == kind
    ]


def test_the_frame_is_built_in_every_mode_and_what_was_previewed_is_what_runs(
    chromium: Browser, served: ServedProject
) -> None:
    seen = opened(chromium, served)
    page, previewed = seen.page, _previewed(seen)
    seen.press(".approve[data-scope=step]")
    seen.until(lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 2)
    page.wait_for_selector(".step.done[data-step='1']", timeout=WAIT_MS)
    page.click(".step[data-step='4'] .row")
    seen.press(".approve[data-scope=until]")
    seen.until(lambda s: s["phase"] == "waiting" and s["open"]["next_step"] == 5)
    page.wait_for_selector(".step.done[data-step='4']", timeout=WAIT_MS)
    seen.press(".approve.main", times=2)
    seen.until(lambda s: s["progress"]["installed"] == 1 and s["phase"] == "waiting")
    given = events(served, "approval_given")
    assert [g["approval"]["scope"]["kind"] for g in given] == ["step", "until", "plan"]
    assert given[0]["decision"]["shown"][0].startswith("Plan for ")
    run = [h for i in events(served, "skill_intent") for h in i["trajectories"]]
    assert run == previewed

    _reject_the_only_piece(seen)
    assert seen.complaints == []
    _open_the_report_from_the_disk(seen, served.folder.parent / "report.html")


def _reject_the_only_piece(seen: Seen) -> None:
    """Reject a plan so that no way is left, and read what is said about it."""
    page = seen.page
    plan = seen.waiting()
    grasp = next(s["number"] for s in plan["steps"] if s["skill"] == "grasp")
    page.click(f".step[data-step='{grasp}'] .row")
    page.click(".acts > button >> nth=0")
    page.check("dialog input[value=wrong-component]")
    page.select_option("dialog select", str(grasp))
    page.click("dialog button[type=submit]")
    page.wait_for_selector(".trouble", timeout=WAIT_MS)  # no other piece can be taken
    expect(page.locator(".trouble")).to_contain_text(plan["target_name"])
    expect(page.locator(".trouble")).to_contain_text("no piece that fits")
    expect(page.locator(".hold b")).to_have_text("Go on")
    (rejected,) = events(seen.served, "approval_rejected")
    assert rejected["rejection"]["reason"] == "wrong-component"
    assert rejected["rejection"]["step"] == grasp


def _open_the_report_from_the_disk(seen: Seen, file: Path) -> None:
    """Keep the report as a file and see that it needs nothing else."""
    file.write_bytes(seen.report(seen.json("/api/state")["run"]))
    page = seen.page.context.new_page()
    asked: list[str] = []
    page.on("request", lambda r: asked.append(r.url))
    page.goto(file.as_uri())
    expect(page.locator("svg").first).to_be_visible()
    for width in (390, 820, 1280):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("() => document.documentElement.scrollWidth") <= width
    assert page.pdf(prefer_css_page_size=True).startswith(b"%PDF")
    assert asked == [file.as_uri()]


def _previewed(seen: Seen) -> list[str]:
    seen.page.click(".modes button >> nth=1")
    seen.page.wait_for_selector(".transport .play", timeout=WAIT_MS)
    hashes: list[str] = seen.page.evaluate("() => __app.trajectories()")
    seen.page.click(".modes button >> nth=0")
    return hashes


def test_a_plan_that_changed_after_it_was_read_is_refused_and_the_change_is_shown(
    chromium: Browser, served: ServedProject
) -> None:
    seen = opened(chromium, served)
    page, first = seen.page, seen.waiting()
    seen.armed()

    on_the_way: list[Route] = []

    def keep(route: Route) -> None:
        on_the_way.append(route)

    page.route("**/api/decisions", keep)
    seen.press(".approve.main")
    rejected = {
        "verb": "reject",
        "fingerprint": first["fingerprint"],
        "reason": "path-unsafe",
        "key": secrets.token_hex(16),
    }
    assert seen.post("/api/decisions", rejected)[0] == 200  # another person is quicker
    on_the_way[0].continue_()
    page.unroute("**/api/decisions")
    page.wait_for_selector(".result.bad", timeout=WAIT_MS)
    second = seen.waiting(other_than=first["fingerprint"])
    expect(page.locator(".plan .code")).to_have_text(second["code"])
    assert events(served, "approval_given") == []

    page.focus(".hold")
    page.keyboard.press("Enter")
    seen.until(lambda s: s["phase"] == "held")
    page.wait_for_selector(".headline.held")
    expect(page.locator(".approve.main")).to_have_count(0)
    page.click(".resume")
    second = seen.waiting()

    # the second of two operators hears who was first
    body = {
        "verb": "approve",
        "fingerprint": second["fingerprint"],
        "next_step": second["next_step"],
        "scope": {"kind": "step", "step": 1},
        "shown": ["as on another tablet"],
    }
    status, told = seen.post("/api/decisions", {**body, "key": secrets.token_hex(16)})
    assert status == 200, told
    status, told = seen.post("/api/decisions", {**body, "key": secrets.token_hex(16)})
    assert (status, told["error"]) in {(409, "decided"), (409, "stale"), (409, "not-asked")}
    assert len(events(served, "approval_given")) == 1


def test_a_lost_server_is_told_at_once_and_nothing_waits_to_be_sent(
    chromium: Browser, served: ServedProject
) -> None:
    seen = opened(chromium, served)
    page, port = seen.page, served.port
    seen.armed()
    served.end(signal.SIGKILL)
    page.wait_for_selector(".banner.lost", timeout=WAIT_MS)
    expect(page.locator(".banner.lost")).to_contain_text("Use the stop on the cell.")
    expect(page.locator(".hold.unreachable")).to_contain_text("No connection")
    expect(page.locator(".headline")).to_have_text("")
    expect(page.locator(".chip")).to_have_attribute("data-link", "lost")
    main = page.locator(".approve.main")
    if main.count():
        main.click(force=True)
    seen.requests.clear()
    served.start(port)
    page.wait_for_selector("[data-link=live]", timeout=WAIT_MS)
    page.wait_for_selector(".banner.lost", state="detached")
    assert [r for r in seen.requests if r.endswith("/api/decisions")] == []
    assert events(served, "approval_given") == []


def test_a_viewer_looks_and_may_only_ask_for_a_hold(chromium: Browser, tmp_path: Path) -> None:
    users = tmp_path / "users.toml"
    token = new_user(users, "vera", Role.VIEWER)
    with ServedProject(tmp_path / "frame", users=users) as served:
        seen = look(chromium, served)
        page = seen.page
        page.goto(f"{served.origin}/?dpr=0.5")  # without a link: the page asks who it is
        page.fill("input[name=user]", "vera")
        page.fill("input[name=token]", token)
        page.click(".sign-in button")
        page.wait_for_selector("[data-link=live]", timeout=WAIT_MS)
        seen.until(lambda s: s["phase"] in {"waiting", "idle"})
        expect(page.locator(".who")).to_have_text("vera viewer")
        status, told = seen.post("/api/decisions", {"verb": "resume", "key": "k" * 16})
        assert (status, told["error"]) == (403, "role")
        if seen.json("/api/state")["phase"] == "waiting":
            plan = seen.waiting()
            expect(page.locator(".approve.main")).to_contain_text("viewer")
            expect(page.locator(".approve.main")).to_have_attribute("aria-disabled", "true")
            page.click(".approve.main", force=True)
            body = {"verb": "approve", "fingerprint": plan["fingerprint"], "key": "k" * 16}
            body |= {"scope": {"kind": "plan"}, "next_step": 1, "shown": []}
            assert seen.post("/api/decisions", body)[0] == 403
        assert page.is_enabled(".hold")
        assert events(served, "approval_given") == []
