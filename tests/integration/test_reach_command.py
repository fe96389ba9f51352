"""`sitewright check --reach`: who reaches what, and why not, on changed cells and buildings."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sitewright.app.project import new_project
from sitewright.cli.main import exit_code

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "frame")


def edit(project: Path, old: str, new: str) -> None:
    cell = project / "cell.toml"
    text = cell.read_text(encoding="utf-8")
    assert old in text
    cell.write_text(text.replace(old, new, 1), encoding="utf-8")


def reach(project: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, Any]]:
    code = exit_code(["check", "--reach", str(project), "--json"])
    document: dict[str, Any] = json.loads(capsys.readouterr().out)
    assert document["schema"] == "sitewright.reach/1"
    return code, document


def of(document: dict[str, Any], target: str) -> dict[str, Any]:
    found: dict[str, Any] = next(t for t in document["targets"] if t["id"] == target)
    return found


def test_the_case_study_is_within_reach_and_drawn(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, document = reach(project, capsys)
    assert (code, document["targets_buildable"], document["share_buildable"]) == (0, 5, 1.0)
    stud = of(document, "stud-1")
    assert stud["robots"] == ["kr120-a"]
    assert stud["handlings"][0]["ways"][0] == {
        "face": "+z",
        "pitch_deg": 0.0,
        "is_turned": False,
        "offset_m": 0.0,
        "insertion": 0,
    }
    assert [o["ways"] for o in stud["operations"]] == [["upright"]] * 4
    assert stud["steadying"]["is_enough"]
    picture = ET.fromstring(Path(document["svg"]).read_text(encoding="utf-8"))  # noqa: S314
    hints = [t.text or "" for t in picture.iter(f"{SVG}title")]
    for name in ("Transverse stud 1: buildable by kr120-a", "kr120-b", "walkway", "assembly-table"):
        assert any(name in h for h in hints), name
    assert any(h.startswith("stud-1.nail-1: reached by kr120-b") for h in hints)


def test_the_same_project_is_told_alike_twice(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    documents = [reach(project, capsys)[1] for _ in range(2)]
    for document in documents:
        del document["seconds"]
    assert documents[0] == documents[1]


def test_a_robot_far_away_is_proven_to_reach_nothing(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(project, "p_m = [-1.6, 0.0, 0.0], q", "p_m = [-4.4, 0.0, 0.0], q")
    code, document = reach(project, capsys)
    assert (code, document["targets_buildable"]) == (6, 0)
    refused = of(document, "support-1")["handlings"][0]["refused"]
    assert refused["is_proven"]
    assert refused["kind"] == "NoIk"
    assert of(document, "support-1")["standing"] == "impossible"
    out_by = {t["id"]: t["handlings"][0]["refused"]["extension_m"] for t in document["targets"]}
    assert out_by["support-2"] == pytest.approx(out_by["support-1"] + 1.2, abs=0.3)


@pytest.mark.parametrize(
    ("change", "standing", "words"),
    [
        (
            lambda p: edit(p, "grips_m = [0.030, 0.140]", "grips_m = [0.005, 0.020]"),
            "impossible",
            "gripper-s grips 5 to 20 mm, the piece is 90 x 140 mm",
        ),
        (
            lambda p: edit(
                p,
                'id = "walkway"\ngeometry = { box = { size_m = [8.0, 0.10, 2.20] } }\n'
                "world_T_zone = { p_m = [0.0, -2.90, 1.10] }",
                'id = "walkway"\ngeometry = { box = { size_m = [0.3, 0.30, 0.3] } }\n'
                "world_T_zone = { p_m = [-0.6, 0.0, 0.56] }",
            ),
            "not-found",
            "walkway",
        ),
        (
            lambda p: edit(p, 'id = "kr120-a" # ', 'id = "kr120-a"\npayload_kg = 40 # '),
            "impossible",
            "the arm carries 40 kg",
        ),
    ],
    ids=["opening", "blocked", "payload"],
)
def test_each_kind_of_no_names_its_reason(
    change: Callable[[Path], None],
    standing: str,
    words: str,
    project: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    change(project)
    code, document = reach(project, capsys)
    support = of(document, "support-1")
    assert code == 6
    assert support["standing"] == standing
    assert words in support["reasons"][0]
    assert of(document, "stud-1")["standing"] != "buildable"


def test_lines_say_who_does_how_much_and_what_waits(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(project, "p_m = [1.6, 0.0, 0.0], q", "p_m = [2.9, 0.0, 0.0], q")
    picture = project / "drawn.svg"
    assert exit_code(["check", "--reach", str(project), "--svg", str(picture)]) == 6
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("2 of 5 targets buildable (40 %)")
    assert "  kr120-a with gripper-s places 5 of 5 targets" in lines
    assert any("stud-1.nail-3: kr120-b: out of reach by" in line for line in lines)
    assert picture.exists()


def test_reach_and_repairs_are_two_questions(project: Path) -> None:
    assert exit_code(["check", "--reach", "--fix", str(project)]) == 2
    assert exit_code(["check", "--svg", str(project / "x.svg"), str(project)]) == 2
