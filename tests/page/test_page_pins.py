"""A tablet that several people share: who decides says so each time, with a PIN."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import expect

from builders_page import WAIT_MS, ServedProject, browser, look
from sitewright.app.project import SETTINGS, new_project
from sitewright.app.serving.users import new_user
from sitewright.interaction_twin.roles import Role

STEP = ".approve[data-scope=step]"


def test_a_press_asks_who_it_is_and_counts_as_theirs(tmp_path: Path) -> None:
    folder, users = new_project(tmp_path / "frame"), tmp_path / "users.toml"
    rules = "[approval]\npin = true\nlook_below_mm = 0\n"
    (folder / SETTINGS).write_text(rules, encoding="utf-8")
    tablet = new_user(users, "tablet", Role.VIEWER)
    new_user(users, "olga", Role.OPERATOR, pin="471100")
    with browser() as chromium, ServedProject(folder, users=users) as served:
        seen = look(chromium, served, width=820, has_touch=True)
        seen.sign_in("tablet", tablet)
        page = seen.page
        seen.until(lambda s: s["phase"] in {"idle", "waiting"})
        seen.waiting()
        seen.armed()
        page.click(STEP)
        page.click("dialog[open] footer button >> nth=0")  # nobody says who it is
        expect(page.locator("dialog[open]")).to_have_count(0)
        assert seen.sent == []
        for pin, result in (("0000", ".result.bad"), ("471100", ".result.good")):
            seen.armed()
            page.click(STEP)
            page.select_option("dialog[open] select", "olga")
            page.fill("dialog[open] input[type=password]", pin)
            page.click("dialog[open] button[type=submit]")
            page.wait_for_selector(result, timeout=WAIT_MS)
        expect(page.locator(".result.good")).to_have_text("Recorded: approved by olga")
        assert len(seen.sent) == 2
        (entry,) = [e for e in seen.json("/api/audit")["entries"] if e["verb"] == "approve"]
        assert entry["who"] == "olga"
