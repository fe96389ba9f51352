"""A tablet that several people share: who decides says so each time, with a PIN."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from builders_page import WAIT_MS, Seen, ServedProject, browser, look
from sitewright.app.project import SETTINGS, new_project
from sitewright.app.serving.users import new_user
from sitewright.interaction_twin.roles import Role

STEP = ".approve[data-scope=step]"
PIN = "471100"


@pytest.fixture
def tablet(tmp_path: Path) -> Iterator[Seen]:
    """Return a tablet that is signed in as itself and shows a plan."""
    folder, users = new_project(tmp_path / "frame"), tmp_path / "users.toml"
    rules = "[approval]\npin = true\nlook_below_mm = 0\n"
    (folder / SETTINGS).write_text(rules, encoding="utf-8")
    token = new_user(users, "tablet", Role.VIEWER)
    new_user(users, "olga", Role.OPERATOR, pin=PIN)
    with browser() as chromium, ServedProject(folder, users=users) as served:
        seen = look(chromium, served, width=820, has_touch=True)
        seen.sign_in("tablet", token)
        seen.waiting()
        yield seen


def test_a_press_asks_who_it_is_and_counts_as_theirs(tablet: Seen) -> None:
    page = tablet.page
    tablet.armed()
    page.click(STEP)
    page.wait_for_selector("dialog[open] input[type=password]")
    page.click(".hold")  # in reach while the question stands, and nobody's name is asked
    tablet.until(lambda s: s["phase"] == "held")
    page.click("dialog[open] footer button >> nth=0")  # nobody says who it is
    expect(page.locator("dialog[open]")).to_have_count(0)
    assert tablet.sent == []
    page.click(".resume")
    _sign(page, PIN)
    tablet.waiting()
    for pin, result in (("0000", ".result.bad"), (PIN, ".result.good")):
        tablet.armed()
        page.click(STEP)
        _sign(page, pin)
        page.wait_for_selector(result, timeout=WAIT_MS)
    expect(page.locator(".result.good")).to_have_text("Recorded: approved by olga")
    assert len(tablet.sent) == 3
    entries = tablet.json("/api/audit")["entries"]
    by_verb = {entry["verb"]: entry["who"] for entry in entries}
    assert (by_verb["approve"], by_verb["hold"]) == ("olga", "tablet")


def _sign(page: Page, pin: str) -> None:
    """Say that olga decides."""
    page.select_option("dialog[open] select", "olga")
    page.fill("dialog[open] input[type=password]", pin)
    page.click("dialog[open] button[type=submit]")
