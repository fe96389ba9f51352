"""A beam that no robot can carry all the way is laid down between, and taken from there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from builders_relay import CHAIN, HAND_OVER, REGRASP, Relay, fixture_text
from builders_site import RealSite, check_journal_against_physics
from sitewright.app.planning import PlanReport, plan_project
from sitewright.app.project import open_project
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.proposal_view import plan_lines, view_of
from sitewright.robot_team.skill import Skill

OK = 0


def planned(relay: Relay, folder: Path) -> PlanReport:
    return plan_project(open_project(relay.write(folder)))


def handling(report: PlanReport) -> list[tuple[str, str, str]]:
    """Return skill, robot and last place of each act of the only plan."""
    (plan,) = report.planned
    calls = (s.call for s in plan.proposal.steps)
    acts = [c for c in calls if c.skill not in (Skill.REACH, Skill.RETRACT)]
    return [(c.skill, c.robot, (*c.arguments, *c.arguments)[1]) for c in acts]


@pytest.mark.parametrize(
    ("relay", "taker", "words"),
    [
        (HAND_OVER, "arm-b", "arm-a lays it down at between, where arm-b takes it"),
        (REGRASP, "arm-a", "arm-a lays it down at between and takes it differently"),
    ],
    ids=["hand-over", "regrasp"],
)
def test_a_beam_goes_by_way_of_the_buffer_and_the_proposal_says_so(
    tmp_path: Path, relay: Relay, taker: str, words: str
) -> None:
    report = planned(relay, tmp_path / "p")
    assert handling(report) == [
        (Skill.GRASP, "arm-a", "pallet-thick"),
        (Skill.SET_DOWN, "arm-a", "between"),
        (Skill.GRASP, taker, "between"),
        (Skill.POSITION, taker, "support-1"),
        (Skill.RELEASE, taker, "support-1"),
    ]
    project = open_project(tmp_path / "p")
    view = view_of(
        report.planned[0].proposal,
        labels_of(project.model, project.cell),
        refusals=report.refusals,
    )
    assert any(line.endswith(f"instead: {words}") for line in plan_lines(view))


def test_three_arms_pass_a_beam_on_over_two_buffers(tmp_path: Path) -> None:
    report = planned(CHAIN, tmp_path / "p")
    assert handling(report) == [
        (Skill.GRASP, "arm-a", "pallet-thick"),
        (Skill.SET_DOWN, "arm-a", "between"),
        (Skill.GRASP, "arm-c", "between"),
        (Skill.SET_DOWN, "arm-c", "between-2"),
        (Skill.GRASP, "arm-b", "between-2"),
        (Skill.POSITION, "arm-b", "support-1"),
        (Skill.RELEASE, "arm-b", "support-1"),
    ]
    words = "arm-a lays it down at between, arm-c takes it from there to between-2, where"
    assert f"{words} arm-b takes it" in {note.then for note in report.refusals}
    motions = [m for step in report.planned[0].proposal.steps for m in step.motions]
    assert motions
    assert all(m.certificate.closest_distance_m > 0.0 for m in motions)


@pytest.mark.parametrize("missing", [0, 1])
def test_a_chain_without_one_of_its_buffers_is_proven_impossible(
    tmp_path: Path, missing: int
) -> None:
    left = tuple(b for k, b in enumerate(CHAIN.buffers) if k != missing)
    (refused,) = planned(replace(CHAIN, buffers=left), tmp_path / "p").escalated
    assert refused.is_proven


def test_without_a_place_between_the_refusal_is_a_proof(tmp_path: Path) -> None:
    """Each arm alone is out of reach of one end for certain, and there is no place between."""
    folder = HAND_OVER.write(tmp_path / "p")
    cell = folder / "cell.toml"
    head, tail = cell.read_text().split("[[station]]")
    cell.write_text(head + tail[tail.index("[[stock_place]]") :])
    (refused,) = plan_project(open_project(folder)).escalated
    assert refused.is_proven
    assert refused.verdict == "proven impossible"


def test_where_no_chain_of_arms_leads_to_the_target_it_is_a_proof_too(tmp_path: Path) -> None:
    far = replace(HAND_OVER, arms=(("a", -2.1, 0.0), ("b", 4.7, 0.0)))
    (refused,) = planned(far, tmp_path / "p").escalated
    assert refused.is_proven


def test_a_chain_that_only_something_in_the_way_breaks_is_no_proof(tmp_path: Path) -> None:
    """A post stands on the buffer: both arms reach it, and nothing can be laid there."""
    folder = HAND_OVER.write(tmp_path / "p")
    post = fixture_text("post", [0.2, 0.2, 1.0], [0.0, 0.0, 0.80])
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text() + post)
    (refused,) = plan_project(open_project(folder)).escalated
    assert not refused.is_proven
    assert refused.verdict == "not found within budget"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("relay", "grippers"),
    [
        (HAND_OVER, {"arm-a", "arm-b"}),
        (REGRASP, {"arm-a"}),
        (CHAIN, {"arm-a", "arm-b", "arm-c"}),
    ],
    ids=["hand-over", "regrasp", "chain"],
)
def test_a_beam_that_is_passed_on_is_built_in_simulation(
    tmp_path: Path, relay: Relay, grippers: set[str]
) -> None:
    relay.write(tmp_path / "project")
    site = RealSite(tmp_path)
    try:
        ended = site.run()
        assert ended.exit_code == OK, ended.message or ended.said
        assert ended.document["targets_installed"] == ended.document["targets_total"] == 1
        assert ended.document["unallowed_contacts"] == 0
        assert {e["robot"] for e in site.physical("gripped")} == grippers
        assert len(site.physical("gripped")) == len(relay.buffers) + 1
        check_journal_against_physics(site, nails=0)
    finally:
        site.clean_up()
