"""`sitewright layout`: a cell laid out badly gets places from which everything can be built."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest

from sitewright.app.project import new_project
from sitewright.cli.main import exit_code

BADLY = (
    ("p_m = [-1.6, 0.0, 0.0], q", "p_m = [-2.1, 0.2, 0.0], q"),
    ("p_m = [1.6, 0.0, 0.0], q", "p_m = [2.0, 0.3, 0.0], q"),
)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = new_project(tmp_path / "frame")
    cell = folder / "cell.toml"
    text = cell.read_text(encoding="utf-8")
    for old, new in BADLY:
        assert old in text
        text = text.replace(old, new, 1)
    cell.write_text(text, encoding="utf-8")
    return folder


def layout(project: Path, capsys: pytest.CaptureFixture[str], *more: str) -> dict[str, Any]:
    exit_code(["layout", str(project), "--json", "--budget", "14", *more])
    document: dict[str, Any] = json.loads(capsys.readouterr().out)
    assert document["schema"] == "sitewright.layout/1"
    return document


def test_robots_put_badly_are_moved_until_all_can_be_built(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = project / "cell.toml"
    before = cell.read_text(encoding="utf-8")
    first, again = (layout(project, capsys) for _ in range(2))
    assert first["share_before"] < 0.5
    assert first["share_after"] == 1.0
    assert first == again
    assert cell.read_text(encoding="utf-8") == before
    assert not first["is_written"]
    assert {m["id"] for m in first["moves"]} <= {
        "kr120-a",
        "kr120-b",
        "pallet-thick",
        "pallet-thin",
    }
    assert all(words.startswith(("Move ", "Turn ")) for words in first["words"])
    picture = ET.fromstring(Path(first["svg"]).read_text(encoding="utf-8"))  # noqa: S314 - ours
    ids = [e.get("id") for e in picture.iter() if e.get("id")]
    assert len(ids) == len(set(ids)) == 4


def test_what_is_written_is_what_was_proposed_and_passes_the_reach_check(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    proposed = layout(project, capsys, "--write")
    assert proposed["is_written"]
    assert (project / "cell.toml.bak").exists()
    assert exit_code(["check", "--reach", str(project), "--json"]) == 0
    checked = json.loads(capsys.readouterr().out)
    assert checked["share_buildable"] == proposed["share_after"] == 1.0
    assert checked["notes"] == []


def test_what_is_to_stay_stays(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    keep = ("--keep", "kr120-b", "--keep", "pallet-thin", "--keep", "pallet-thick")
    found = layout(project, capsys, *keep)
    assert {m["id"] for m in found["moves"]} <= {"kr120-a"}
    assert exit_code(["layout", str(project), "--keep", "kr120-c"]) == 2


@pytest.mark.parametrize("area", ["1,2,3", "a,b,c,d", "2,0,1,5"])
def test_an_area_is_four_numbers_in_order(project: Path, area: str) -> None:
    assert exit_code(["layout", str(project), "--area", area]) == 2
