"""The one writer of pictures: what it draws stands where and looks as the schedule says."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest

from builders_run import A, B
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.drawing.bars import Bar, on_the_axis_of, robot_numbers
from sitewright.interaction_twin.drawing.gantt import REPORT, beside_a_picture, gantt
from sitewright.interaction_twin.drawing.palette import FAILED, ROBOT_COLOURS
from sitewright.interaction_twin.labels import Kind, Label, Labels
from sitewright.interaction_twin.languages import PHRASEBOOKS
from sitewright.robot_team.skill import SkillCall

SVG = "{http://www.w3.org/2000/svg}"
LABELS = Labels({B: Label(Kind.ROBOT, "Berta"), A: Label(Kind.ROBOT, "Anton")})
PAGE = beside_a_picture(800.0, PHRASEBOOKS["de"])


def bar(step: int, starts_s: float, robot: str = A, **changes: object) -> Bar:
    facts: dict[str, object] = {
        "robot": robot,
        "call": SkillCall("grasp", A, ("piece-1", "pallet", "gripper")),
        "target": ComponentId("stud-1"),
        "starts_s": starts_s,
        "duration_s": 2.0,
        "step": step,
        "fingerprint": "f",
        **changes,
    }
    return Bar(**facts)  # type: ignore[arg-type]


PLANNED = (bar(1, 0.0), bar(2, 2.0, B), bar(3, 4.0))
ACTUAL = (bar(1, 0.5), bar(2, 3.0, B, is_done=False))


@pytest.mark.parametrize("style", [REPORT, PAGE], ids=["report", "page"])
def test_bars_stand_at_their_times_in_the_colour_of_their_robot(style: object) -> None:
    root = ET.fromstring(gantt(PLANNED, ACTUAL, LABELS, style))  # type: ignore[arg-type]  # noqa: S314
    left, right, end_s = (float(root.attrib[f"data-{n}"]) for n in ("left", "right", "end-s"))
    assert end_s == 6.0
    drawn: dict[tuple[str, int], tuple[str, dict[str, str]]] = {}
    for group in root.iter(f"{SVG}g"):
        for box in group.findall(f"{SVG}rect"):
            key = (box.attrib["class"], int(box.attrib["data-step"]))
            drawn[key] = (box.get("fill", group.attrib["fill"]), box.attrib)
    wanted = {("planned", b.step): b for b in PLANNED} | {("actual", b.step): b for b in ACTUAL}
    assert set(drawn) == set(wanted)
    for key, wish in wanted.items():
        colour, where = drawn[key]
        number = 1 if wish.robot == B else 2  # in the order of the cell
        assert colour == (ROBOT_COLOURS[number - 1] if wish.is_done else FAILED)
        assert float(where["data-starts-s"]) == wish.starts_s
        assert float(where["x"]) == pytest.approx(
            left + (right - left) * wish.starts_s / end_s, abs=0.6
        )
    assert float(drawn["planned", 1][1]["y"]) < float(drawn["actual", 1][1]["y"])


def test_a_picture_has_nothing_that_a_page_forbids_or_loads() -> None:
    root = ET.fromstring(gantt(PLANNED, ACTUAL, LABELS, PAGE))  # noqa: S314
    names = {e.tag.removeprefix(SVG) for e in root.iter()}
    assert names == {"svg", "title", "rect", "circle", "text", "line", "g"}
    attributes = {a for e in root.iter() for a in e.attrib}
    assert not {a for a in attributes if a in {"style", "href"} or a.startswith("on")}


def test_a_schedule_speaks_the_language_of_its_page() -> None:
    assert "geplant (Umriss)" in gantt(PLANNED, ACTUAL, LABELS, PAGE)


def test_what_ran_is_moved_to_where_its_plan_starts() -> None:
    late = (bar(2, 50.0, B), bar(3, 53.0), bar(1, 60.0, fingerprint="another"))
    moved = on_the_axis_of(PLANNED, late)
    assert [(b.step, b.starts_s) for b in moved] == [(2, 2.0), (3, 5.0)]


def test_robots_have_the_numbers_of_the_cell_and_unknown_ones_come_after() -> None:
    assert robot_numbers(LABELS, [bar(1, 0.0, "zoe"), bar(2, 0.0)]) == {B: 1, A: 2, "zoe": 3}
