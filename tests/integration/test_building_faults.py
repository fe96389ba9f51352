"""Faulty buildings in a project folder: opening it names the fault and touches no file."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sitewright.app.checking import check
from sitewright.app.project import open_project
from sitewright.errors import ModelRejectedError

EXAMPLE = Path(__file__).parents[2] / "examples" / "wooden_frame"
Change = Callable[[dict[str, Any]], object]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "frame"
    folder.mkdir()
    for name in ("building.json", "cell.toml"):
        shutil.copy(EXAMPLE / name, folder / name)
    return folder


def by_id(document: dict[str, Any], name: str) -> dict[str, Any]:
    found: dict[str, Any] = next(c for c in document["components"] if c["id"] == name)
    return found


def in_millimetres(document: dict[str, Any]) -> None:
    for component in document["components"]:
        box = component["geometry"].get("box")
        if box is not None:
            box["size_m"] = [s * 1000.0 for s in box["size_m"]]
    for stack in document["stacks"]:
        made = stack["generated"]
        made["length_m"] *= 1000.0
        made["section_m"] = [s * 1000.0 for s in made["section_m"]]


def circular(document: dict[str, Any]) -> None:
    stud = by_id(document, "stud-2")
    parent = stud["construction_parents"][0]
    by_id(document, parent).update(construction_parents=[stud["id"]], ground=False)


def twice(document: dict[str, Any]) -> None:
    document["components"].append(dict(by_id(document, "stud-2")))


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (in_millimetres, "U2"),
        (twice, "D1"),
        (lambda d: by_id(d, "stud-2").update(construction_parents=["no-such"]), "P1"),
        (circular, "P2"),
        (lambda d: by_id(d, "stud-2").update(order=0), "P4"),
        (lambda d: d.update(stacks=[]), "M1"),
        (lambda d: by_id(d, "stud-2")["geometry"]["box"].update(size_m=[1.8, 0.0, 0.04]), "G6"),
    ],
    ids=["unit", "duplicate", "missing parent", "cycle", "order", "no material", "zero size"],
)
def test_a_faulty_building_is_named_and_left_alone(
    project: Path, change: Change, code: str
) -> None:
    file = project / "building.json"
    document = json.loads(file.read_text())
    change(document)
    file.write_text(json.dumps(document))
    before = {p.name: p.read_bytes() for p in project.iterdir()}
    problems = check(project)
    assert code in {p.code for p in problems}
    assert all(p.where and p.message and p.fix for p in problems)
    with pytest.raises(ModelRejectedError):
        open_project(project)
    assert {p.name: p.read_bytes() for p in project.iterdir()} == before


@pytest.mark.parametrize("share", [0.0, 0.3, 0.99])
def test_a_truncated_building_is_one_problem(project: Path, share: float) -> None:
    file = project / "building.json"
    whole = file.read_bytes()
    file.write_bytes(whole[: int(len(whole) * share)])
    with pytest.raises(ModelRejectedError) as rejected:
        open_project(project)
    assert len(rejected.value.problems) == 1


def test_a_number_that_is_none_is_refused(project: Path) -> None:
    file = project / "building.json"
    document = json.loads(file.read_text())
    by_id(document, "stud-2")["geometry"]["box"]["size_m"][0] = float("nan")
    file.write_text(json.dumps(document))
    with pytest.raises(ModelRejectedError, match="finite number"):
        open_project(project)
