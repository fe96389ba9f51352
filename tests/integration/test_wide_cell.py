"""The case study where no stud can be taken at its middle, and no upright gun reaches all nails."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import pytest

from builders_planning import EXAMPLES
from builders_site import Ended, RealSite, check_journal_against_physics, real_site
from sitewright.app.explaining_steps import explain_step
from sitewright.app.project import open_project
from sitewright.robot_team.skill import Skill

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealSite]:
    with real_site(tmp_path_factory.mktemp("wide"), studs=3) as made:
        wide = EXAMPLES / "wooden_frame" / "cell.wide.toml"
        (made.project / "cell.toml").write_bytes(wide.read_bytes())
        yield made


@pytest.fixture(scope="module")
def ended(site: RealSite) -> Ended:
    return site.run()


def instead(ended: Ended, target: str) -> dict[str, str]:
    """Return what was refused about a target, with what was done instead."""
    told = (r for r in ended.document["refusals"] if r["target"] == target)
    return {r["reason"].split(":")[0]: r["then"] for r in told}


def test_the_whole_frame_is_built_in_simulation(site: RealSite, ended: Ended) -> None:
    assert ended.exit_code == 0, ended.message or ended.said
    document = ended.document
    assert (document["targets_installed"], document["targets_total"]) == (5, 5)
    assert (document["fasteners_driven"], document["fasteners_total"]) == (12, 12)
    assert document["unallowed_contacts"] == 0
    assert document["closest_distance_m"] >= 0.010
    check_journal_against_physics(site, nails=12)


def test_the_proposals_say_which_first_choices_failed_and_what_is_done_instead(
    ended: Ended,
) -> None:
    for n in (1, 2, 3):
        told = instead(ended, f"stud-{n}")
        held = {k: v for k, v in told.items() if "straight at its middle" in k}
        assert list(held.values()) == ["it is held 100 mm off the middle"]
    for n in (1, 3):
        leaning = {k: v for k, v in instead(ended, f"stud-{n}").items() if "upright" in k}
        assert list(leaning) == [
            f"kr120-b cannot stand upright on stud-{n}.nail-{k}" for k in (3, 4)
        ]
        assert all(v.startswith("it leans (tilt ") for v in leaning.values())
    assert not any("upright" in k for k in instead(ended, "stud-2"))


def test_the_steps_are_as_they_were_told(site: RealSite, ended: Ended) -> None:
    assert ended.exit_code == 0
    project = open_project(site.project)
    leans, offsets = [], []
    for target in ("stud-1", "stud-3"):
        steps = explain_step(project, 1, target=target).steps
        for step in steps:
            if step.call.skill not in (Skill.FASTEN, Skill.GRASP):
                continue
            stance = explain_step(project, step.number, target=target).stance
            assert stance is not None
            if stance.lean_rad is not None:
                leans.append(round(math.degrees(stance.lean_rad), 1))
            if stance.from_middle_m is not None:
                offsets.append(round(abs(stance.from_middle_m), 3))
    assert offsets == [0.1, 0.1]
    assert sorted(leans) == [0.0] * 4 + [2.5, 2.5, 5.0, 5.0]


def test_the_report_tells_it_too(site: RealSite, ended: Ended) -> None:
    assert ended.exit_code == 0
    page = Path(site.newest / "report.html").read_text(encoding="utf-8")
    assert "it is held 100 mm off the middle" in page
    assert "it leans (tilt 5 deg" in page
