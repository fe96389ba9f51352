"""The reach picture: outlines, colours, and names that do not cover each other."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull, QhullError

from builders_planning import EXAMPLES
from builders_reach import checked
from sitewright.app.project import read_project
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import rotation, translation
from sitewright.foundation.shapes import Box
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.reach.outline import hull, outline_of
from sitewright.interaction_twin.reach.palette import AMPLE, EASY, NARROW, TEAM, look_of
from sitewright.interaction_twin.reach.picture import reach_picture
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict

SVG = "{http://www.w3.org/2000/svg}"
POINTS = st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=20)


@given(points=POINTS)
def test_a_hull_has_the_area_that_qhull_says(points: list[tuple[int, int]]) -> None:
    corners = hull([(float(x), float(y)) for x, y in points])
    try:
        expected = ConvexHull(np.array(points)).volume
    except QhullError:
        assert _area(corners) == 0.0
        return
    assert _area(corners) == pytest.approx(expected)


def _area(corners: tuple[tuple[float, float], ...]) -> float:
    pairs = zip(corners, (*corners[1:], *corners[:1]), strict=True)
    return sum(x * v - u * y for (x, y), (u, v) in pairs) / 2.0


def test_a_turned_box_is_seen_from_above_and_from_the_side() -> None:
    found = outline_of(
        (Box((2.0, 1.0, 0.4)),), translation(5.0, 0.0, 1.0) @ rotation((0, 0, 1), math.pi / 2)
    )
    assert found.low_m == pytest.approx((4.5, -1.0, 0.8))
    assert found.high_m == pytest.approx((5.5, 1.0, 1.2))
    assert _area(found.plan[0]) == pytest.approx(2.0)
    assert _area(found.elevation[0]) == pytest.approx(1.0 * 0.4)


@pytest.mark.parametrize(
    ("robots", "ways", "look"), [(1, 3, NARROW), (1, 4, EASY), (1, 10, AMPLE), (2, 2, TEAM)]
)
def test_the_colour_tells_how_many_ways_and_robots_there_are(
    robots: int, ways: int, look: object
) -> None:
    verdict = TargetVerdict(
        target=ComponentId("x"),
        standing=Standing.BUILDABLE,
        robots=tuple(RobotId(f"r{k}") for k in range(robots)),
        ways=ways,
    )
    assert look_of(verdict) is look
    others = [s for s in Standing if s is not Standing.BUILDABLE]
    fills = {look_of(replace(verdict, standing=s)).fill for s in others}
    assert len(fills) == len(others)


@pytest.fixture(scope="module")
def frame() -> ReachReport:
    return checked(read_project(EXAMPLES / "wooden_frame"))


def test_the_picture_shows_both_views_to_one_scale(frame: ReachReport) -> None:
    project = read_project(EXAMPLES / "wooden_frame")
    drawn = ET.fromstring(  # noqa: S314 - our own
        reach_picture(frame, labels_of(project.model, project.cell), "<frame> & co")
    )
    words = [t.text or "" for t in drawn.iter(f"{SVG}text")]
    assert "Reach: <frame> & co" in words
    assert words.count("kr120-a") == words.count("kr120-b") == 2
    widths = {float(c[0].get("width", 0)) for c in drawn.iter(f"{SVG}clipPath")}
    assert len(widths) == 1
    radii = {c.get("r") for c in drawn.iter(f"{SVG}circle") if c.get("stroke-dasharray") == "2 5"}
    assert len(radii) == 1  # two arms of one make, two views, one scale


def test_names_in_a_view_do_not_cover_each_other(frame: ReachReport) -> None:
    project = read_project(EXAMPLES / "wooden_frame")
    text = reach_picture(frame, labels_of(project.model, project.cell), "frame")
    for view in text.split("<clipPath")[1:]:
        boxes = [_covered(m) for m in re.finditer(r"<text [^>]*paint-order[^>]*>([^<]+)<", view)]
        assert len(boxes) >= 3
        for k, (left, top, right, bottom) in enumerate(boxes):
            for a, b, c, d in boxes[:k]:
                assert right <= a or c <= left or bottom <= b or d <= top


def _covered(match: re.Match[str]) -> tuple[float, float, float, float]:
    """Return a cautious box of a drawn name: its middle line, four pixels a letter."""
    tag, words = match.group(0), match.group(1)
    x, y = (float(re.findall(rf' {k}="([-0-9.]+)"', tag)[0]) for k in "xy")
    half = 2.0 * len(words)
    if "rotate" in tag:
        return x - 2.0, y - half, x + 2.0, y + half
    return x - half, y - 6.0, x + half, y - 1.0
