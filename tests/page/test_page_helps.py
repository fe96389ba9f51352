"""Needs help: what is in the way is told and shown, and a person takes a way out; all real."""

from __future__ import annotations

import json
import secrets
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, expect

from builders_page import SIZES, WAIT_MS, Seen, ServedProject, browser, look
from sitewright.app.project import new_project

_BOX = """
[[fixture]]
id = "crate"
name = "crate of screws"
geometry = { box = { size_m = [0.3, 0.3, 0.4] } }
world_T_fixture = { p_m = [0.6, 0.9, 0.3] }
"""
pytestmark = pytest.mark.timeout(300)
_ZONE = {"center_m": [-0.6, 0.9, 0.5], "size_m": [0.5, 0.5, 0.9], "yaw_rad": 0.0}


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as running:
        yield running


def only(folder: Path, *components: str) -> Path:
    """Write the frame with some of its components only."""
    new_project(folder)
    building = json.loads((folder / "building.json").read_text())
    building["components"] = [c for c in building["components"] if c["id"] in components]
    building["relations"] = []
    (folder / "building.json").write_text(json.dumps(building))
    return folder


@pytest.fixture
def served(tmp_path: Path) -> Iterator[ServedProject]:
    """Serve two supports; a crate stands where the second one belongs."""
    folder = only(tmp_path / "frame", "support-1", "support-2")
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text() + _BOX)
    with ServedProject(folder) as running:
        yield running


def test_who_is_in_the_way_is_told_and_shown_and_a_way_out_goes_on(
    chromium: Browser, served: ServedProject
) -> None:
    seen = look(chromium, served)
    seen.open(dots=0.5)
    page = seen.page
    if seen.json("/api/state")["phase"] == "idle":
        page.click(".resume")
    assert seen.waiting()["target"] == "support-1"
    body = {"verb": "zone", "key": secrets.token_hex(16), "zone": _ZONE}
    assert seen.post("/api/decisions", body)[0] == 200
    state = seen.until(lambda s: s["phase"] == "needs-help" and len(s["trouble"]) == 2)
    of_zone, of_crate = sorted(state["trouble"], key=lambda t: str(t["target"]))

    expect(page.locator(".trouble")).to_have_count(2)  # it opened by itself
    _told_and_shown(seen, of_zone, "keep-out-1")
    _told_and_shown(seen, of_crate, "crate")
    for width, height in SIZES.items():
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
    page.set_viewport_size({"width": 1280, "height": SIZES[1280]})

    (option,) = [o for o in of_zone["options"] if o["verb"] == "zone"]
    assert [o for o in of_crate["options"] if o["verb"] == "zone"] == [], "it would not help"
    _trouble(seen, of_zone).get_by_role("button", name=option["words"]).click()
    plan = seen.waiting()
    assert plan["target"] == "support-1"
    expect(page.locator(".trouble", has_text=of_zone["name"])).to_have_count(0)
    assert seen.json("/api/scene")["zones"] == [
        z for z in seen.json("/api/scene")["zones"] if z["by"] == "cell"
    ]
    assert _of_scripts(seen) == []


def _trouble(seen: Seen, trouble: dict[str, Any]) -> Any:
    return seen.page.locator(".trouble").filter(
        has=seen.page.locator("h2", has_text=trouble["name"])
    )


def _told_and_shown(seen: Seen, trouble: dict[str, Any], blocker: str) -> None:
    """Read one trouble, look at the moment in which it was refused, and come back."""
    page, told = seen.page, _trouble(seen, trouble)
    assert trouble["blockers"] == [blocker]
    assert trouble["pair"][1] == blocker
    expect(told).to_contain_text(trouble["reason"])
    told.locator(".show").click()
    page.wait_for_function("() => __app.tried().lit.length === 2", timeout=WAIT_MS)
    tried = page.evaluate("() => __app.tried()")
    assert sorted(tried["lit"]) == sorted(trouble["pair"])
    assert tried["q_rad"] == trouble["posture"]["q_rad"]
    carried = [b["body"] for b in trouble["posture"]["bodies"] if b["on"] in tried["q_rad"]]
    assert trouble["pair"][0] in carried
    page.click(".tried-then button")  # one tap
    page.wait_for_function("() => __app.tried().lit.length === 0", timeout=WAIT_MS)


def test_a_no_leads_to_another_way_and_then_to_options_never_to_a_dead_end(
    chromium: Browser, tmp_path: Path
) -> None:
    with ServedProject(only(tmp_path / "frame", "support-1")) as served:
        seen = look(chromium, served)
        seen.open(dots=0.5)
        if seen.json("/api/state")["phase"] == "idle":
            seen.page.click(".resume")
        first = seen.waiting()
        moved = next(s for s in first["steps"] if s["motions"])
        _reject(seen, first, moved["number"], "path-unsafe")
        second = seen.waiting(other_than=first["fingerprint"])
        again = next(s for s in second["steps"] if s["words"] == moved["words"])
        assert [m["trajectory_sha256"] for m in again["motions"]] != [
            m["trajectory_sha256"] for m in moved["motions"]
        ]

        grasp = next(s for s in second["steps"] if s["skill"] == "grasp")
        _reject(seen, second, grasp["number"], "wrong-component")
        state = seen.until(lambda s: s["phase"] == "needs-help")
        (trouble,) = state["trouble"]
        assert trouble["verdict_kind"] == "rejected"
        told = _trouble(seen, trouble)
        for words in trouble["rejected"]:
            expect(told).to_contain_text(words)
        expect(told).to_contain_text("local rejected step")
        draw, ask = (
            next(o for o in trouble["options"] if o["id"] == name) for name in ("draw", "again")
        )
        told.get_by_role("button", name=draw["words"]).click()
        seen.page.click("dialog[open] footer button >> nth=0")
        told.get_by_role("button", name=ask["words"]).click()
        third = seen.waiting(other_than=second["fingerprint"])
        assert [s["words"] for s in third["steps"]] == [s["words"] for s in first["steps"]]
        assert _of_scripts(seen) == []


def _reject(seen: Seen, plan: dict[str, Any], step: int, reason: str) -> None:
    body = {"verb": "reject", "fingerprint": plan["fingerprint"], "reason": reason, "step": step}
    assert seen.post("/api/decisions", {**body, "key": secrets.token_hex(16)})[0] == 200


def _of_scripts(seen: Seen) -> list[str]:
    """Return what the page complained of, but for an answer that came late on a busy machine."""
    return [c for c in seen.complaints if "Failed to load resource" not in c]
