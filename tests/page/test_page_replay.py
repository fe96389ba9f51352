"""A run is looked at again in a real browser: all is where the journal says it was sensed."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from builders_page import WAIT_MS, Seen, ServedProject, browser, look
from builders_serving import approval
from sitewright.app.run_folder import RunFolder, event_of
from sitewright.central_controller.events import SiteObserved, SkillIntent
from sitewright.central_controller.sensed import merged
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.journal.sqlite import read_records
from sitewright.robot_team.driver import Observation

FROM_TEST = """([time_s]) => { const slider = document.querySelector('.transport input');
  slider.value = time_s; slider.dispatchEvent(new Event('input', { bubbles: true })); }"""


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Seen]:
    """Return a page of a run with two built components, the third one's plan waiting."""
    folder = tmp_path_factory.mktemp("again") / "frame"
    with browser() as chromium, ServedProject(folder) as served:
        seen = look(chromium, served)
        seen.open(dots=0.5)
        if seen.json("/api/state")["phase"] == "idle":
            seen.page.click(".resume")
        before = ""
        for _ in range(2):
            plan = seen.waiting(other_than=before)
            before = plan["fingerprint"]
            assert seen.post("/api/decisions", approval(plan))[0] == 200
        seen.waiting(other_than=before)
        yield seen


@pytest.fixture
def seen(opened: Seen) -> Seen:
    """Return the page with the run opened to be looked at again, at its start."""
    opened.page.click("nav button >> nth=0")
    opened.page.click("nav button >> nth=2")
    opened.page.click(".run-list li button >> nth=0")
    opened.page.wait_for_selector(".transport .play", timeout=WAIT_MS)
    return opened


@pytest.fixture(scope="module")
def journal(opened: Seen) -> list[tuple[int, Any]]:
    folder = RunFolder(Path(opened.served.folder) / "runs" / opened.json("/api/state")["run"])
    return [(r.seq, event_of(folder, r)) for r in read_records(folder.journal)]


def sensed_before(journal: list[tuple[int, Any]], number: int) -> dict[ComponentId, Pose]:
    sensed: Observation | None = None
    for n, event in journal:
        if n < number and isinstance(event, SiteObserved):
            sensed = merged(sensed, event)
    assert sensed is not None
    return dict(sensed.world_T_piece)


def intents(journal: list[tuple[int, Any]], skill: str) -> list[tuple[int, SkillIntent]]:
    return [(n, e) for n, e in journal if isinstance(e, SkillIntent) and e.call.skill == skill]


def shown(seen: Seen, component: str) -> list[float] | None:
    place: list[float] | None = seen.page.evaluate("c => __app.placeOf(c)", component)
    return place


def test_pieces_are_where_they_were_sensed_at_each_of_three_moments(
    seen: Seen, journal: list[tuple[int, Any]]
) -> None:
    first, second = intents(journal, "grasp")[0], intents(journal, "position")[1]
    last = max(n for n, e in journal if isinstance(e, SkillIntent))
    different = []
    for number in (first[0], second[0], last):
        seen.page.click(f".journal [data-event='{number}'] button")
        expect(seen.page.locator(".journal .selected")).to_have_attribute("data-event", str(number))
        poses = sensed_before(journal, number)
        places = {piece: shown(seen, piece) for piece in poses}
        assert places == {
            piece: pytest.approx(list(pose.position_m), abs=1e-3) for piece, pose in poses.items()
        }
        different.append(str(places))
    assert len(set(different)) == 3


def test_what_shall_be_is_shown_until_something_is_in_its_place(
    seen: Seen, journal: list[tuple[int, Any]]
) -> None:
    (first, intent), (later, _) = intents(journal, "position")[:2]
    seen.page.click(f".journal [data-event='{first}'] button")
    expect(seen.page.locator(f".journal [data-event='{first}'].selected")).to_have_count(1)
    assert shown(seen, intent.target) is not None
    seen.page.click(f".journal [data-event='{later}'] button")
    expect(seen.page.locator(f".journal [data-event='{later}'].selected")).to_have_count(1)
    assert shown(seen, intent.target) is None
    assert shown(seen, str(intent.params["piece"])) is not None


def test_a_piece_in_a_gripper_goes_with_it_between_two_moments(
    seen: Seen, journal: list[tuple[int, Any]]
) -> None:
    _, intent = intents(journal, "position")[0]
    piece = str(intent.params["piece"])
    replay = seen.json(f"/api/runs/{seen.json('/api/state')['run']}/replay")
    way = [s for s in replay["skills"] if s["fingerprint"] == intent.fingerprint]
    carry = next(s for s in way if s["step"] == intent.step - 1)
    sensed = [m["pieces"][piece]["p_m"] for m in replay["moments"] if piece in m["pieces"]]
    middle_s = carry["starts_s"] + carry["duration_s"] / 2.0
    seen.page.evaluate(FROM_TEST, [middle_s])
    seen.page.wait_for_function(
        "([piece, from]) => Math.hypot(...__app.placeOf(piece).map((v, i) => v - from[i])) > 0.1",
        arg=[piece, sensed[1]],  # as soon as the plan's trajectories have come
        timeout=WAIT_MS,
    )
    there = shown(seen, piece)
    assert there is not None
    assert there != pytest.approx(sensed[2], abs=0.1)


def test_the_schedule_beside_it_has_the_moment_and_chooses_another(seen: Seen) -> None:
    page = seen.page
    bars = page.locator(".gantt .actual")
    expect(bars).not_to_have_count(0)  # the picture comes from the server
    last = max(float(b.get_attribute("data-starts-s") or 0) for b in bars.all())
    page.locator(f".gantt .actual[data-starts-s='{last:.3f}']").last.click(force=True)
    expect(page.locator(".transport input")).to_have_value(f"{last:.2f}")
    moment = page.locator(".gantt .moment")
    expect(moment).to_have_count(1)
    line = moment.get_attribute("x1") or ""
    page.focus(".gantt")
    page.keyboard.press("ArrowLeft")
    expect(page.locator(".transport input")).not_to_have_value(f"{last:.2f}")
    expect(moment).not_to_have_attribute("x1", line)
    assert float(moment.get_attribute("x1") or 0) < float(line)
    assert seen.complaints == []


def test_leaving_the_screen_shows_the_cell_as_it_is(seen: Seen) -> None:
    page = seen.page
    page.click("nav button >> nth=0")
    expect(page.locator(".picture")).not_to_contain_class("replay")
    expect(page.locator(".transport")).to_have_count(0)
    page.wait_for_selector(".approve.main", timeout=WAIT_MS)
    live = {c["id"]: c["world_T"]["p_m"] for c in seen.json("/api/scene")["components"]}
    assert shown(seen, "thin.1") == pytest.approx(live["thin.1"], abs=1e-3)
