"""The report of a run: figures folded from its journal, pictures, and a page that stands alone."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from typing_extensions import override

from builders_run import A, B, Site, design
from sitewright.app.run import run_project
from sitewright.app.run_folder import RunFolder, chain_of, event_of, run_folders
from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    Layer,
    Operation,
    Process,
)
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.events import AnyEvent, ProposalSuperseded, RunFinished
from sitewright.central_controller.site_state import SiteState
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, Node
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.drawing.bars import Bar
from sitewright.interaction_twin.drawing.gantt import gantt
from sitewright.interaction_twin.drawing.graph_picture import GraphStyle, graph_picture
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.report.content import RunSummary, Stamped
from sitewright.interaction_twin.report.figures import report_json
from sitewright.interaction_twin.report.page import report_page
from sitewright.interaction_twin.report.summary import summarise
from sitewright.interaction_twin.report.waiting import Cause, robot_times, time_by_cause
from sitewright.journal.sqlite import read_records
from sitewright.robot_team.skill import SkillCall

FIGURES = {
    "targets_total",
    "targets_installed",
    "fasteners_total",
    "fasteners_driven",
    "skills_executed",
    "trajectories_total",
    "trajectories_certified",
    "trajectories_confirmed",
    "unallowed_contacts",
    "closest_distance_m",
    "worst_pose_error_m",
    "worst_pose_error_rad",
    "replans",
    "questions_asked",
    "makespan_s",
    "planning_s",
    "refusals",
}


def model_of(site: SiteState) -> BuildingModel:
    components = [
        Component(
            id=t,
            layer=Layer.TARGET,
            type="stud",
            geometry=BoxGeometry((1.0, 0.1, 0.1)),
            operations=tuple(
                Operation(id=o, process=Process.NAIL, on=(t,)) for o in site.operations[t]
            ),
        )
        for t in site.targets
    ]
    return BuildingModel(name="Small", component_by_id={c.id: c for c in components})


def history_of(folder: RunFolder) -> list[Stamped]:
    return [Stamped(r.t_utc_ns, event_of(folder, r)) for r in read_records(folder.journal)]


@pytest.fixture
def history(tmp_path: Path) -> list[Stamped]:
    site = Site(tmp_path)
    result = run_project(site.ports(), site.options())
    assert result.exit_code == 0
    return history_of(run_folders(site.folder / "runs")[-1])


def summary_of(history: Sequence[Stamped]) -> RunSummary:
    return summarise(model_of(design()), design(), history)


def with_contacts(history: Sequence[Stamped], contacts: Json) -> list[Stamped]:
    def changed(event: AnyEvent) -> AnyEvent:
        if isinstance(event, RunFinished):
            return replace(event, extra={} if contacts is None else {"contacts": contacts})
        return event

    return [Stamped(s.at_utc_ns, changed(s.event)) for s in history]


def test_the_figures_are_those_of_the_run(history: list[Stamped]) -> None:
    figures = summary_of(history).figures
    assert (figures.targets_installed, figures.targets_total) == (2, 2)
    assert (figures.fasteners_driven, figures.fasteners_total) == (4, 4)
    kinds = [s.event.kind for s in history]
    assert figures.skills_executed == kinds.count("skill_outcome") > 0
    assert figures.skills_failed == 0
    assert figures.trajectories_total > 0
    assert figures.trajectories_certified == figures.trajectories_total
    assert figures.trajectories_confirmed == figures.trajectories_total
    assert figures.closest_distance_m == pytest.approx(0.042)
    assert figures.worst_pose_error_m == pytest.approx(0.001)
    assert figures.worst_pose_error_rad == pytest.approx(0.0, abs=1e-9)
    assert figures.planning_s["total"] == pytest.approx(0.2)
    assert figures.makespan_s > 0.0


def test_contacts_that_the_cell_did_not_tell_are_unknown_and_not_zero(
    history: list[Stamped],
) -> None:
    assert summary_of(with_contacts(history, [])).figures.unallowed_contacts == 0
    silent = [
        Stamped(
            s.at_utc_ns, replace(s.event, extra={}) if isinstance(s.event, RunFinished) else s.event
        )
        for s in history
    ]
    assert summary_of(silent).figures.unallowed_contacts is None


def test_contacts_count_once_per_pair_and_skill(history: list[Stamped]) -> None:
    contacts: Json = [
        {"pair": ["b", "a"], "skill": "reach", "depth_m": 0.001},
        {"pair": ["a", "b"], "skill": "reach", "depth_m": 0.002},
        {"pair": ["a", "b"], "skill": "grasp", "depth_m": 0.002},
    ]
    summary = summary_of(with_contacts(history, contacts))
    assert summary.figures.unallowed_contacts == 2
    assert summary.contacts == (("a", "b", "grasp"), ("a", "b", "reach"))


def test_a_failed_skill_and_a_replan_show(tmp_path: Path) -> None:
    site = Site(tmp_path, fail={"grasp": "grasp-failed"})
    assert run_project(site.ports(), site.options()).exit_code == 0
    history = history_of(run_folders(site.folder / "runs")[-1])
    summary = summary_of(history)
    replans = [s for s in history if isinstance(s.event, ProposalSuperseded) and s.event.is_replan]
    assert summary.figures.skills_failed == 1
    assert summary.figures.replans == len(replans) == 1
    assert [b.call.skill for b in summary.actual if not b.is_done] == ["grasp"]


def test_a_run_that_continues_another_counts_its_own_work_only(tmp_path: Path) -> None:
    site = Site(tmp_path)
    run_project(site.ports(), site.options())
    folder = run_folders(site.folder / "runs")[-1]
    history, before = history_of(folder), run_project(site.ports(), site.options()).site
    assert len(chain_of(folder)) == 1
    summary = summarise(model_of(design()), before, history[:1])
    assert summary.figures.targets_installed == 2
    assert summary.figures.skills_executed == 0
    assert summary.ended == "open"


def test_bars_of_one_robot_never_overlap_and_begin_at_zero(history: list[Stamped]) -> None:
    summary = summary_of(history)
    for bars in (summary.planned, summary.actual):
        assert min(b.starts_s for b in bars) == pytest.approx(0.0)
        for robot in (A, B):
            own = sorted((b for b in bars if b.robot == robot), key=lambda b: b.starts_s)
            assert own
            for earlier, later in pairwise(own):
                assert earlier.starts_s + earlier.duration_s <= later.starts_s + 1e-9
    assert len(summary.actual) == len(summary.planned) == summary.figures.skills_executed


def test_the_time_of_a_run_is_told_by_cause_and_nothing_of_it_is_left_out(
    history: list[Stamped],
) -> None:
    spent_s = time_by_cause(history)
    whole_s = (history[-1].at_utc_ns - history[0].at_utc_ns) / 1e9
    assert sum(spent_s.values()) == pytest.approx(whole_s)
    kinds = ["skill_intent", "skill_outcome", "proposal_made", "approval_given"]
    by_kind = {k: next(s.event for s in history if s.event.kind == k) for k in kinds}
    seconds = (0, 4, 5, 8, 100, 300)
    order = ["skill_intent", "skill_outcome", "proposal_made", "approval_given", "skill_intent"]
    made = [Stamped(0, history[0].event)]
    made += [Stamped(s * 10**9, by_kind[k]) for k, s in zip(order, seconds[1:], strict=True)]
    assert time_by_cause(made) == {
        Cause.PROOF: 4.0 + 200.0,
        Cause.WORK: 1.0,
        Cause.PLANNING: 3.0,
        Cause.DECISION: 92.0,
    }


def test_every_robot_spends_the_whole_makespan_on_something(history: list[Stamped]) -> None:
    summary = summary_of(history)
    times = {t.robot: t for t in summary.robot_times}
    assert set(times) == {A, B}
    for t in times.values():
        whole_s = t.works_s + t.holds_s + t.waits_s + t.still_s
        assert whole_s == pytest.approx(summary.figures.makespan_s)
    works_s = sum(b.duration_s for b in summary.actual if b.robot == A)
    assert times[A].works_s == pytest.approx(works_s)


def test_a_robot_that_holds_a_piece_for_another_does_not_merely_wait() -> None:
    def bar(robot: RobotId, skill: str, starts_s: float, duration_s: float) -> Bar:
        call = SkillCall(skill, robot, ())
        facts = {"target": ComponentId("t"), "starts_s": starts_s, "duration_s": duration_s}
        return Bar(robot=robot, call=call, **facts)  # type: ignore[arg-type]

    bars = [
        bar(A, "grasp", 0.0, 2.0),
        bar(B, "fasten", 2.0, 5.0),
        bar(A, "release", 7.0, 1.0),
        bar(B, "reach", 9.0, 3.0),
    ]
    first, second = robot_times(bars)
    assert (first.works_s, first.holds_s, first.waits_s, first.still_s) == (3.0, 5.0, 3.0, 1.0)
    assert (second.works_s, second.holds_s, second.waits_s, second.still_s) == (8.0, 0.0, 3.0, 1.0)


def test_the_document_holds_all_figures_and_is_plain_json(history: list[Stamped]) -> None:
    document = report_json(summary_of(history))
    assert set(document) >= FIGURES
    assert document["schema"] == "sitewright.report/1"
    assert json.loads(json.dumps(document, allow_nan=False)) == document


def node(name: str, *parents: str, layer: Layer = Layer.TARGET) -> Node:
    return Node(
        id=ComponentId(name),
        label=name,
        layer=layer,
        type="stud",
        construction_parents=tuple(ComponentId(p) for p in parents) or (JOBSITE,),
        world_T_component=Pose(),
        size_m=(1.0, 0.1, 0.1),
    )


def graph_with(*nodes: Node) -> ConstructionGraph:
    return ConstructionGraph(node_by_id={n.id: n for n in nodes})


FRAME = graph_with(
    node("support-1", layer=Layer.AS_BUILT),
    node("support-2"),
    node("stud-1", "support-1", "support-2"),
    node("stud-2", "support-1", "support-2"),
    node("piece-1", layer=Layer.MATERIAL),
    node("piece-2", "piece-1", layer=Layer.MATERIAL),
)


def boxes(svg: str) -> dict[str, tuple[float, float]]:
    root = ET.fromstring(svg)  # noqa: S314 -- our own text
    name = "{http://www.w3.org/2000/svg}"
    found = {}
    for group in root.iter(f"{name}g"):
        title, box = group.find(f"{name}title"), group.find(f"{name}rect")
        assert title is not None
        assert title.text is not None
        assert box is not None
        found[title.text.split(" (")[0]] = (float(box.get("x", 0)), float(box.get("y", 0)))
    return found


def test_what_rests_on_something_is_drawn_above_it() -> None:
    place = boxes(graph_picture(FRAME))
    assert len(place) == 7, "six nodes and the jobsite"
    for n in FRAME.node_by_id.values():
        for parent in n.construction_parents:
            below = "Jobsite" if parent == JOBSITE else parent
            assert place[n.id][1] < place[below][1]


def test_no_two_boxes_of_a_graph_overlap() -> None:
    wide = [node(f"stud-{n}", f"support-{n % 3}") for n in range(17)]
    graph = graph_with(*(node(f"support-{n}") for n in range(3)), *wide)
    place = sorted(boxes(graph_picture(graph)).values(), key=lambda p: (p[1], p[0]))
    for (x1, y1), (x2, y2) in pairwise(place):
        assert y1 != y2 or x2 - x1 >= GraphStyle().box_px


def test_names_from_a_model_cannot_break_out_of_the_pictures() -> None:
    evil = '<script>alert(1)</script>&"'
    svg = graph_picture(graph_with(replace(node("a"), label=evil)))
    assert "<script" not in svg
    ET.fromstring(svg)  # noqa: S314 -- our own text


class Links(HTMLParser):
    """Collects what a page would load, and its tags."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.loads: list[str] = []

    @override
    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.loads += [v or "" for k, v in attrs if k in {"src", "href", "data", "action"}]


@pytest.fixture
def page(history: list[Stamped]) -> str:
    return report_page(summary_of(history), FRAME, FRAME, Labels())


def test_the_page_loads_nothing_and_runs_nothing(page: str) -> None:
    links = Links()
    links.feed(page)
    assert links.loads == []
    assert not links.tags & {"script", "link", "iframe", "img", "object", "form"}
    assert "default-src 'none'" in page
    assert not re.search(r"url\(|@import|\son\w+=", page)
    body = page.split("<body>", 1)[1]
    assert " style=" not in body
    assert "http" not in body.replace("http://www.w3.org/2000/svg", "")


def test_the_page_shows_every_part(page: str) -> None:
    for title in (
        "Schedule",
        "Where the time went",
        "Construction graph",
        "As built",
        "Plans",
        "Planning times",
        "Approvals and decisions",
        "Refusals and deviations",
        "Contacts that were not allowed",
    ):
        assert f"<h2>{title}</h2>" in page
    assert page.count("<svg") == 3
    assert "Complete" in page
    assert "approved" in page


def test_the_same_run_gives_the_same_page(history: list[Stamped]) -> None:
    pages = {report_page(summary_of(history), FRAME, FRAME, Labels()) for _ in range(2)}
    assert len(pages) == 1


def test_three_hundred_steps_are_drawn_small(history: list[Stamped]) -> None:
    one = summary_of(history).actual[0]
    many = [replace(one, starts_s=float(n), duration_s=0.9) for n in range(300)]
    svg = gantt((), many, Labels())
    assert svg.count("<rect") >= 300
    assert len(svg) < 80_000
