"""The built-in examples with other robots: another make, arms on tracks, four arms at once."""

from __future__ import annotations

import shutil
from functools import lru_cache
from pathlib import Path

import pytest

from builders_arms import offset_wrist_urdf, seven_joint_urdf
from builders_planning import EXAMPLES
from builders_reach import checked, contradictions, missed
from sitewright.app.planning import PlanReport, plan_project
from sitewright.app.project import open_project


@lru_cache(maxsize=3)
def planned(example: str) -> PlanReport:
    return plan_project(open_project(EXAMPLES / example))


@pytest.mark.slow
@pytest.mark.parametrize("example", ["irb6700_frame", "track_frame", "four_arms"])
def test_every_target_of_the_example_has_a_certified_plan(example: str) -> None:
    report = planned(example)
    assert not report.escalated
    assert not report.waiting
    assert report.targets_planned == report.targets_total > 0
    for found in report.planned:
        for step in found.proposal.steps:
            for motion in step.motions:
                assert motion.certificate.closest_distance_m >= 0.010
                assert motion.agreement.samples > 0


@pytest.mark.slow
@pytest.mark.parametrize("example", ["irb6700_frame", "track_frame", "four_arms"])
def test_the_reach_check_calls_nothing_impossible_that_is_planned(example: str) -> None:
    reach = checked(open_project(EXAMPLES / example))
    assert contradictions(reach, planned(example)) == []
    assert missed(reach, planned(example)) == []


@pytest.mark.slow
def test_arms_on_tracks_use_them_and_all_four_arms_work() -> None:
    track = planned("track_frame")
    ends = {
        (m.timed.path.robot, round(m.timed.path.end_rad[0], 2))
        for p in track.planned
        for s in p.proposal.steps
        for m in s.motions
    }
    for robot in ("kr120-a", "kr120-b"):
        positions = [at for name, at in ends if name == robot]
        assert max(positions) - min(positions) > 1.0
    four = planned("four_arms")
    movers = {s.call.robot for p in four.planned for s in p.proposal.steps}
    assert movers == {"kr120-west", "kr120-east", "irb6700-west", "irb6700-east"}


def with_own_handler(folder: Path, urdf: str, turns: str) -> Path:
    """Return the wooden frame with an arm of one's own as handler."""
    shutil.copytree(EXAMPLES / "wooden_frame", folder / "frame")
    (folder / "frame" / "own.urdf").write_text(urdf)
    cell = folder / "frame" / "cell.toml"
    old = cell.read_text(encoding="utf-8")
    edits = {
        'model = "kuka-kr120-r2500-pro"': 'urdf = "own.urdf"',
        "home_q_deg = [0, -110, 110, 0, 80, 0]": f"home_q_deg = [-14, {turns}]",
        "[[115, -110, 110, 0, 80, 0], [-115, -110, 110, 0, 80, 0]]": (
            f"[[101, {turns}], [-129, {turns}]]"
        ),
        "max_acceleration_deg_s2 = [312, 312, 312, 660, 660, 1230]\n": "",
    }
    for before, after in edits.items():
        assert before in old
        old = old.replace(before, after, 1)
    cell.write_text(old, encoding="utf-8")
    return folder / "frame"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("urdf", "turns"),
    [
        (offset_wrist_urdf(), "-100, 110, 80, -90, -104"),
        (seven_joint_urdf(), "-100, 0, 110, 80, -90, -104"),
    ],
    ids=["offset wrist", "seven joints"],
)
def test_the_wooden_frame_is_planned_with_an_arm_of_ones_own(
    tmp_path: Path, urdf: str, turns: str
) -> None:
    report = plan_project(open_project(with_own_handler(tmp_path, urdf, turns)))
    assert report.targets_planned == report.targets_total == 5
