from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitewright.app.checking import check
from sitewright.app.engines import identity_of
from sitewright.app.planning import start_of
from sitewright.app.project import (
    BUILDING,
    CELL,
    DOMAIN,
    EXAMPLES,
    SETTINGS,
    ProjectError,
    example_folder,
    is_usable,
    new_project,
    open_project,
)
from sitewright.errors import CellRejectedError, ModelRejectedError


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return new_project(tmp_path / "frame")


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_new_project_of_an_example_opens_at_once(example: str, tmp_path: Path) -> None:
    made = new_project(tmp_path / example, example=example)
    project = open_project(made)
    assert project.folder == made
    assert project.cell_file == made / CELL
    assert (project.settings, project.domain_file) == ({}, None)
    assert is_usable(made)
    assert [p for p in check(made) if p.severity == "E"] == []


def test_a_folder_that_has_something_in_it_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(ProjectError, match="not empty"):
        new_project(tmp_path)
    assert [f.name for f in tmp_path.iterdir()] == ["notes.txt"]


def test_an_unknown_example_is_refused_with_the_known_ones(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"wooden_frame, painted_frame.*Did you mean"):
        new_project(tmp_path / "x", example="wooden-frame")
    assert not (tmp_path / "x").exists()


def test_a_missing_folder_or_file_is_named_with_the_command_that_makes_it(
    tmp_path: Path, folder: Path
) -> None:
    with pytest.raises(ProjectError, match="sitewright new"):
        open_project(tmp_path / "nowhere")
    (folder / BUILDING).unlink()
    with pytest.raises(ProjectError, match=r"no building\.json.*sitewright import"):
        open_project(folder)
    with pytest.raises(ProjectError, match=r"no building\.json"):
        check(folder)
    assert not is_usable(folder)


def test_a_cell_that_is_not_there_is_named(folder: Path) -> None:
    with pytest.raises(ProjectError, match=r"no other\.toml"):
        open_project(folder, cell="other.toml")


def test_another_cell_is_found_beside_the_building_or_by_its_whole_path(folder: Path) -> None:
    mirrored = "cell.mirrored.toml"
    beside = open_project(folder, cell=mirrored)
    absolute = open_project(folder, cell=example_folder("wooden_frame") / mirrored)
    assert beside.cell == absolute.cell
    assert beside.cell != open_project(folder).cell


def test_settings_and_a_domain_of_ones_own_are_used(folder: Path) -> None:
    (folder / SETTINGS).write_text("[policy]\napprove = 'plan'\n", encoding="utf-8")
    (folder / DOMAIN).write_text("(define (domain mine))", encoding="utf-8")
    project = open_project(folder)
    assert project.settings == {"policy": {"approve": "plan"}}
    assert project.domain_file == folder / DOMAIN


@pytest.mark.parametrize("content", [b"policy = [", b"\xff\xfe"])
def test_settings_that_cannot_be_read_are_named(folder: Path, content: bytes) -> None:
    (folder / SETTINGS).write_bytes(content)
    with pytest.raises(ProjectError, match=r"sitewright\.toml.*Mend the file or remove it"):
        open_project(folder)


def test_problems_of_both_files_are_reported_together(folder: Path) -> None:
    building = json.loads((folder / BUILDING).read_text(encoding="utf-8"))
    building["components"][0]["geometry"]["box"]["size_m"] = [0.0, 0.09, 0.14]
    (folder / BUILDING).write_text(json.dumps(building), encoding="utf-8")
    cell = (folder / CELL).read_text(encoding="utf-8")
    (folder / CELL).write_text(cell.replace("[2.50, 0.30, 0.32]", "[-1, 0, 0]"), encoding="utf-8")
    problems = [p for p in check(folder) if p.severity == "E"]
    assert any("support-1" in p.where for p in problems)
    assert any("fixture" in f"{p.where} {p.message}" for p in problems)
    with pytest.raises((ModelRejectedError, CellRejectedError)):
        open_project(folder)


def test_a_building_that_does_not_fit_the_cell_is_refused_with_all_its_problems(
    folder: Path,
) -> None:
    building = json.loads((folder / BUILDING).read_text(encoding="utf-8"))
    for stack in building["stacks"]:
        stack["place"] = "nowhere"
    (folder / BUILDING).write_text(json.dumps(building), encoding="utf-8")
    with pytest.raises(ModelRejectedError) as caught:
        open_project(folder)
    assert len(caught.value.problems) >= 2


def test_the_untouched_site_has_all_stock_in_place_and_all_robots_at_home(folder: Path) -> None:
    project = open_project(folder)
    context = start_of(project)
    assert len(context.observation.world_T_piece) == 8
    assert set(context.site.targets) == {f"{k}-{n}" for k, n in
        (("support", 1), ("support", 2), ("stud", 1), ("stud", 2), ("stud", 3))}  # fmt: skip
    for robot, state in context.observation.robots.items():
        assert state.q_rad == project.cell.robot_by_id[robot].home_q_rad
        assert state.gripped is None
    assert set(context.observation.docked) == {"screwdriver", "paint-head"}


def test_an_identity_changes_with_each_of_its_files(folder: Path) -> None:
    before = identity_of(open_project(folder), "domain")
    assert identity_of(open_project(folder), "domain") == before
    assert identity_of(open_project(folder), "other")["domain"] != before["domain"]
    (folder / BUILDING).write_text(
        (folder / BUILDING).read_text(encoding="utf-8") + "\n", encoding="utf-8"
    )
    after = identity_of(open_project(folder), "domain")
    assert after["model"] != before["model"]
    assert after["cell"] == before["cell"]
