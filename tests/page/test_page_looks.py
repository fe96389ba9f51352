"""The page as a person sees it, in a real browser before a real server; nothing is decided here."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Route, expect

from builders_page import READY, SIZES, WAIT_MS, Seen, ServedProject, browser, filled_up, look

ROOT = Path(__file__).parents[2]
AXE = ROOT / "src/sitewright/interaction_twin/page/node_modules/axe-core/axe.min.js"
HOLD = {"en": "Hold", "de": "Anhalten", "es": "Detener", "zh": "暂停"}
SCREENS = ("Cell", "Building", "Runs", "Audit", "Health")
_STYLE = "element => ({ ...getComputedStyle(element) })"
_WHERE = "() => __app.project('stud-2')"
PICTURES = os.environ.get("SITEWRIGHT_PICTURES", "")


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    with browser() as running:
        yield running


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ServedProject]:
    with ServedProject(tmp_path_factory.mktemp("looks") / "frame") as running:
        yield running


@pytest.fixture(scope="module")
def opened(chromium: Browser, served: ServedProject) -> Seen:
    """Return the one page that these tests share; it signs in once."""
    seen = look(chromium, served)
    seen.open()
    if seen.json("/api/state")["phase"] == "idle":
        seen.page.click(".resume")
    seen.waiting()
    return seen


@pytest.fixture
def seen(opened: Seen) -> Iterator[Seen]:
    """Give the page back as it was at the start, and see that it complained of nothing."""
    opened.page.set_viewport_size({"width": 1280, "height": 800})
    opened.page.emulate_media(forced_colors="none")
    yield opened
    complaints, opened.complaints[:] = list(opened.complaints), []
    assert complaints == []
    opened.page.keyboard.press("Escape")
    opened.page.click("nav button >> nth=0")
    opened.page.click(".modes button >> nth=0")
    opened.page.click(".tabs button >> nth=0")
    if opened.page.locator(".step.selected").count():
        opened.page.click(".step.selected .row")


def test_nothing_is_asked_of_any_other_server(seen: Seen) -> None:
    assert seen.requests
    assert [
        r for r in seen.requests if not r.startswith((seen.served.origin, "data:", "blob:"))
    ] == []


def test_the_token_does_not_stay_in_the_address(seen: Seen) -> None:
    assert "token" not in seen.page.url


def test_a_frozen_picture_is_the_same_to_the_pixel(seen: Seen) -> None:
    pictures = []
    for _ in range(2):
        again = seen.page.context.new_page()
        again.set_viewport_size({"width": 640, "height": 480})
        again.goto(f"{seen.served.origin}/?dpr=1&freeze=1")
        again.wait_for_function(READY, timeout=WAIT_MS)
        again.wait_for_selector(".approve.main")
        pictures.append(again.evaluate("() => __app.pixels()"))
        again.close()
    assert pictures[0] == pictures[1]
    assert len(pictures[0]) > 10_000


def test_a_tap_in_the_picture_names_what_was_tapped(seen: Seen) -> None:
    page = seen.page
    page.click(".views .opener")
    page.click(".views .menu button >> nth=1")  # from above nothing hides the frame
    place = page.evaluate("() => __app.project('stud-2')")
    page.locator("canvas").click(position={"x": place["x"], "y": place["y"]})
    expect(page.locator(".card h2")).to_have_text("Transverse stud 2")
    expect(page.locator(".card dl")).to_contain_text("Supporting stud 1")
    page.click(".card header button")
    page.click(".views .opener")
    page.click(".views .menu button >> nth=0")


def test_the_joints_that_are_shown_are_those_that_are_sensed(seen: Seen) -> None:
    shown = seen.page.evaluate("() => __app.postures()")
    sensed = [robot["q_rad"] for robot in seen.json("/api/scene")["robots"]]
    assert [pytest.approx(q, abs=1e-4) for q in sensed] == shown


def test_the_preview_plays_the_trajectories_that_the_plan_names(seen: Seen) -> None:
    page = seen.page
    plan = seen.json("/api/proposals/open")
    page.click(".modes button >> nth=1")
    page.wait_for_selector(".transport .play")
    named = [m["trajectory_sha256"] for s in plan["steps"] for m in s["motions"]]
    assert page.evaluate("() => __app.trajectories()") == named
    expect(page.locator(".transport .play")).to_have_attribute("aria-label", "Play")  # it stands
    starts = sorted({s["starts_s"] for s in plan["steps"]})
    page.click(".transport button >> nth=0")  # to the start
    for start_s in starts[:4]:
        step = max(s["number"] for s in plan["steps"] if s["starts_s"] == start_s)
        expect(page.locator(".step.selected")).to_have_attribute("data-step", str(step))
        assert float(page.input_value(".transport input")) == pytest.approx(start_s, abs=0.02)
        page.click(".transport button >> nth=3")


def test_list_schedule_and_picture_select_the_same_step(seen: Seen) -> None:
    page = seen.page
    page.click(".step >> nth=1 >> .row")
    expect(page.locator(".step.selected")).to_have_attribute("data-step", "2")
    expect(page.locator(".gantt .planned.selected[data-step='2']")).to_have_count(1)
    page.focus(".gantt")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".step.selected")).to_have_attribute("data-step", "3")
    page.click(".step.selected .row")
    expect(page.locator(".step.selected")).to_have_count(0)


def test_graph_list_and_picture_of_the_building_select_the_same_component(seen: Seen) -> None:
    page = seen.page
    page.click("nav button >> nth=1")
    page.click(".graph [data-component=stud-2]")
    expect(page.locator(".order button[aria-pressed=true]")).to_contain_text("Transverse stud 2")
    page.click(".views .opener")
    page.click(".views .menu button >> nth=1")  # from above nothing hides the frame
    place = page.evaluate("() => __app.project('stud-1')")
    page.locator("canvas").click(position={"x": place["x"], "y": place["y"]})
    expect(page.locator(".graph .selected")).to_have_attribute("data-component", "stud-1")
    page.focus(".graph")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".graph .selected")).to_have_attribute("data-component", "stud-2")
    expect(page.locator(".card h2")).to_have_text("Transverse stud 2")
    page.click(".card header button")
    expect(page.locator(".graph .selected")).to_have_count(0)


def test_the_slider_of_the_building_takes_components_away_in_their_order(seen: Seen) -> None:
    page = seen.page
    page.click("nav button >> nth=1")
    page.fill(".scroll input[type=range]", "2")
    expect(page.locator(".order .later")).to_have_count(3)
    page.click(".views .opener")
    page.click(".views .menu button >> nth=1")
    middle = page.evaluate("() => __app.project('stud-2')")
    page.locator("canvas").click(position=middle)
    expect(page.locator(".card h2")).to_have_count(0)  # it does not stand yet
    page.fill(".scroll input[type=range]", "5")
    page.locator("canvas").click(position=middle)
    expect(page.locator(".card h2")).to_have_text("Transverse stud 2")
    page.click(".card header button")


def test_a_picture_that_carries_more_than_a_picture_is_not_put_in(seen: Seen) -> None:
    page = seen.page
    image = '<svg xmlns="http://www.w3.org/2000/svg"><g {}/>{}</svg>'
    for attribute, inside in (('onclick="x()"', ""), ("", "<script>x()</script>"), ("", "<a/>")):
        evil = image.format(attribute, inside)
        page.route("**/graph.svg*", partial(_answer, evil))
        with page.expect_event("pageerror"):
            page.click("nav button >> nth=1")
        assert page.locator(".graph svg").count() == 0
        page.click("nav button >> nth=0")
        page.unroute("**/graph.svg*")
    assert all("a picture has no" in c for c in seen.complaints)
    seen.complaints.clear()


def _answer(picture: str, route: Route) -> None:
    route.fulfill(body=picture, content_type="image/svg+xml")


def test_hold_comes_first_for_keys_and_approve_never_has_the_focus_by_itself(seen: Seen) -> None:
    page = seen.page
    page.reload()
    page.wait_for_function(READY, timeout=WAIT_MS)
    seen.armed()
    assert page.evaluate("() => document.activeElement.tagName") == "BODY"
    page.keyboard.press("Tab")
    assert "hold" in (page.evaluate("() => document.activeElement.className"))
    order = []
    for _ in range(90):
        page.keyboard.press("Tab")
        order.append(page.evaluate("() => document.activeElement.className"))
        if "main" in order[-1]:
            break
    assert "approve main" in order[-1]
    page.keyboard.press("Shift+Tab")
    assert seen.json("/api/state")["phase"] == "waiting"


@pytest.mark.parametrize("language", HOLD)
def test_the_page_speaks_the_language_that_is_chosen(seen: Seen, language: str) -> None:
    page = seen.page
    page.select_option(".language select", language)
    expect(page.locator(".hold b")).to_have_text(HOLD[language])
    expect(page.locator("html")).to_have_attribute("lang", language)
    words = page.inner_text("#page")
    assert [w for w in ("act.", "phase.", "plan.", "{") if w in words] == []
    page.select_option(".language select", "en")


@pytest.mark.parametrize("width", SIZES)
@pytest.mark.parametrize(("language", "way"), [("en", "ltr"), ("de", "ltr"), ("en", "rtl")])
def test_decisions_are_in_view_and_nothing_is_clipped(
    seen: Seen, width: int, language: str, way: str
) -> None:
    page = seen.page
    page.set_viewport_size({"width": width, "height": SIZES[width]})
    page.select_option(".language select", language)
    page.evaluate("way => { document.documentElement.dir = way }", way)
    expect(page.locator(".hold b")).to_have_text(HOLD[language])
    hold, main = (page.locator(s).bounding_box() for s in (".hold", ".approve.main"))
    assert hold is not None
    assert main is not None
    assert (hold["x"] < main["x"]) == (way == "ltr")
    for selector in (".hold", *(f".acts > button >> nth={n}" for n in range(5))):
        box = page.locator(selector).bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        assert box["y"] + box["height"] <= SIZES[width]
        assert min(box["width"], box["height"]) >= 48
    wider = "() => document.documentElement.scrollWidth > innerWidth"
    assert not page.evaluate(wider)
    overlap = """() => {
      const boxes = [...document.querySelectorAll('.hold, .acts > button')].map((b) =>
        b.getBoundingClientRect());
      return boxes.some((a, i) => boxes.some((b, j) => i < j && a.left < b.right - 1 &&
        b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1));
    }"""
    assert not page.evaluate(overlap)
    cut = """() => [...document.querySelectorAll('.acts > button, .hold')]
      .filter((b) => b.scrollWidth > b.clientWidth + 1 || b.scrollHeight > b.clientHeight + 1)
      .map((b) => b.textContent)"""
    assert page.evaluate(cut) == []
    page.select_option(".language select", "en")
    page.evaluate("() => { document.documentElement.dir = 'ltr' }")


def test_what_is_chosen_and_what_may_be_pressed_is_seen_in_forced_colours(seen: Seen) -> None:
    page = seen.page
    page.click(".step >> nth=1 >> .row")
    page.emulate_media(forced_colors="active")
    for marked in (".step.selected", "nav button[aria-current]", ".modes [aria-pressed=true]"):
        assert page.eval_on_selector(marked, _STYLE)["outlineStyle"] == "solid", marked
        assert page.eval_on_selector(marked, _STYLE)["outlineWidth"] == "2px", marked
    assert page.eval_on_selector(".step:not(.selected)", _STYLE)["outlineStyle"] == "none"
    for pressed in (".hold", ".approve.main", ".acts > button >> nth=0"):
        style = page.locator(pressed).evaluate(_STYLE)
        assert style["borderTopStyle"] == "solid", pressed
        assert style["color"] != style["backgroundColor"], pressed
    rgb = page.eval_on_selector(".chip .dot", _STYLE)["backgroundColor"]
    assert rgb == "rgb(53, 147, 90)"  # live is still told by its green


def test_fingers_turn_zoom_and_name_what_they_tap(chromium: Browser, opened: Seen) -> None:
    tablet = look(chromium, opened.served, width=820, has_touch=True)
    page = tablet.page
    page.context.add_cookies(opened.page.context.cookies())  # type: ignore[arg-type]
    page.goto(f"{opened.served.origin}/?dpr=0.5")
    page.wait_for_function(READY, timeout=WAIT_MS)
    page.click(".views .opener")
    page.click(".views .menu button >> nth=1")
    box = page.locator("canvas").bounding_box()
    assert box is not None
    place = page.evaluate(_WHERE)
    page.touchscreen.tap(box["x"] + place["x"], box["y"] + place["y"])
    expect(page.locator(".card h2")).to_have_text("Transverse stud 2")
    page.locator(".card header button").tap()
    expect(page.locator(".card")).to_have_count(0)
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    for fingers in (1, 2):
        before = page.evaluate(_WHERE)
        _drag(page, middle, fingers)
        page.wait_for_function(f"old => Math.abs(({_WHERE})().x - old.x) > 2", arg=before)
    expect(page.locator(".card")).to_have_count(0)  # a drag is no tap
    assert tablet.complaints == []
    page.context.close()


def _drag(page: Any, start: tuple[float, float], fingers: int) -> None:
    """Draw one finger along, or two apart, as a touch screen reports it."""
    screen = page.context.new_cdp_session(page)

    def touches(way: float) -> list[dict[str, float]]:
        x, y = start
        both = [{"x": x + way, "y": y, "id": 0}, {"x": x - 40 - way, "y": y, "id": 1}]
        return both[:fingers]

    screen.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": touches(0)})
    for way in (10, 30, 60, 90):
        moved = {"type": "touchMove", "touchPoints": touches(way)}
        screen.send("Input.dispatchTouchEvent", moved)
    screen.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    screen.detach()


def test_a_thousand_components_take_few_draw_calls(seen: Seen) -> None:
    page = seen.page.context.new_page()
    page.set_viewport_size({"width": 640, "height": 480})
    page.route("**/api/scene", filled_up(1_000))
    page.goto(f"{seen.served.origin}/?dpr=0.5&freeze=1")
    page.wait_for_function(READY, timeout=WAIT_MS)
    assert page.evaluate("() => __m.cost.calls") < 150
    place = page.evaluate("() => __app.project('copy-999')")
    assert place is not None  # they are there
    page.close()


@pytest.mark.parametrize("width", [1280, 390])
def test_no_screen_has_a_barrier_that_axe_finds(seen: Seen, width: int) -> None:
    if not AXE.is_file():
        pytest.skip("needs axe-core: run `make page`, which installs it")
    page = seen.page
    page.set_viewport_size({"width": width, "height": SIZES[width]})
    page.evaluate(AXE.read_text(encoding="utf-8"))
    for number, screen in enumerate(SCREENS):
        page.click(f"nav button >> nth={number}")
        page.wait_for_selector(f"nav button[aria-current] >> text={screen}")
        assert _barriers(page) == [], screen
    page.click("nav button >> nth=0")
    page.click(".tabs button >> nth=1")
    page.wait_for_selector(".layer .name")
    assert _barriers(page) == [], "components"
    page.click(".tabs button >> nth=0")
    page.click(".acts button >> nth=0")
    page.wait_for_selector("dialog[open]")
    assert _barriers(page) == [], "reject"
    page.keyboard.press("Escape")


def _barriers(page: Any) -> list[str]:
    found = page.evaluate("() => axe.run().then((r) => r.violations)")
    return [f"{v['id']}: {n['html'][:160]}" for v in found for n in v["nodes"]]


def test_the_picture_of_the_readme_is_taken_here(seen: Seen, tmp_path: Path) -> None:
    page = seen.page
    page.click(".step >> nth=4 >> .row")
    page.click(".step.selected .details button >> nth=0")
    page.wait_for_selector(".transport .play")
    folder = Path(PICTURES) if PICTURES else tmp_path
    picture = folder / "page.png"
    page.screenshot(path=picture)
    assert picture.stat().st_size > 50_000
