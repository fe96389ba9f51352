"""`building.json`: what is read, what is refused, and in which words."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

from builders_building import EXAMPLES, codes, component, document, model, stock
from sitewright.building_model.component import BoxGeometry, ExtrusionGeometry, Layer
from sitewright.building_model.formats.native import read_building, write_building
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose


def rejected(tmp_path: Path, text: str | bytes) -> tuple[Problem, ...]:
    path = tmp_path / "building.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ModelRejectedError) as refusal:
        read_building(path)
    return refusal.value.problems


def changed(tmp_path: Path, **changes: Any) -> tuple[Problem, ...]:
    return rejected(tmp_path, json.dumps(document(**changes)))


def first_component(**changes: Any) -> list[dict[str, Any]]:
    first, *rest = document()["components"]
    return [{**first, **changes}, *rest]


def test_the_case_study_has_its_members_nails_and_stock() -> None:
    frame = read_building(EXAMPLES / "wooden_frame" / "building.json")
    targets = [c for c in frame.component_by_id.values() if c.layer is Layer.TARGET]
    stud = frame.component_by_id[ComponentId("stud-2")]
    assert len(targets) == 5
    assert sum(len(c.operations) for c in targets) == 12
    assert stud.geometry == BoxGeometry((1.8, 0.09, 0.04))
    assert stud.hold_until_fasteners == 2
    assert [len(s.items) for s in frame.stacks] == [3, 5]


def test_generated_pieces_lie_on_each_other() -> None:
    frame = read_building(EXAMPLES / "wooden_frame" / "building.json")
    heights = [
        frame.component_by_id[ComponentId(f"thin.{n}")].world_T_component.position_m[2]
        for n in (1, 2, 5)
    ]
    assert heights == pytest.approx([0.02, 0.06, 0.18])


def test_a_byte_order_mark_is_no_problem(tmp_path: Path) -> None:
    path = tmp_path / "building.json"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(document()).encode())
    assert read_building(path).name == "Wooden frame"


def test_a_cut_file_is_told_with_line_and_column(tmp_path: Path) -> None:
    text = json.dumps(document(), indent=1)
    (problem,) = rejected(tmp_path, text[: len(text) // 2])
    assert problem.code == "E4"
    assert "cut off" in problem.message
    assert problem.message.startswith("Line ")


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        ('{"schema": oops}', "E5", "column 12"),
        ("[" * 40, "E5", "deeper than 32"),
        (b"\xff\xfe{}", "E5", "UTF-8"),
        ("version https://git-lfs.github.com/spec/v1\noid x", "E2", "LFS"),
        ("[]", "K1", "no object"),
        ('{"a": ' + "9" * 5000 + "}", "E5", "number"),
        ("", "E4", "cut off"),
    ],
)
def test_unreadable_text_is_refused_in_words(
    tmp_path: Path, text: str | bytes, code: str, words: str
) -> None:
    (problem,) = rejected(tmp_path, text)
    assert problem.code == code
    assert words in problem.message


def test_a_missing_file_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(ModelRejectedError, match="No such file"):
        read_building(tmp_path / "none.json")


def test_brackets_inside_texts_do_not_count_as_depth(tmp_path: Path) -> None:
    path = tmp_path / "building.json"
    name = "[" * 40 + '\\"' + "{" * 40
    path.write_text(json.dumps(document(name=name)), encoding="utf-8")
    assert read_building(path).name == name


def test_a_key_that_stands_twice_is_refused(tmp_path: Path) -> None:
    text = json.dumps(document()).replace('"order": 1', '"order": 1, "order": 2', 1)
    (problem,) = rejected(tmp_path, text)
    assert problem.code == "K2"
    assert "'order' of 'support-1'" in problem.message


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e400"])
def test_a_number_that_is_none_is_refused_once_with_its_place(tmp_path: Path, number: str) -> None:
    text = json.dumps(document()).replace("[2.4, 0.09, 0.14]", f"[2.4, {number}, 0.14]", 1)
    (problem,) = rejected(tmp_path, text)
    assert problem.code == "K3"
    assert "support-1" in problem.where


def test_a_number_that_is_none_is_also_found_in_free_keys(tmp_path: Path) -> None:
    text = json.dumps(document(components=first_component(ext={"a": 7}))).replace("7", "1e999", 1)
    assert [p.code for p in rejected(tmp_path, text)] == ["K3"]


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        ({"lenght": 1}, "components[support-1].lenght", "not known"),
        ({"order": "1"}, "components[support-1].order", "integer"),
        ({"ground": 1}, "components[support-1].ground", "boolean"),
        ({"mass_kg": -1.0}, "components[support-1].mass_kg", "greater than 0"),
        ({"layer": "Material"}, "components[support-1].layer", "material"),
        ({"id": "a b"}, "components[a b].id", "pattern"),
        ({"geometry": {}}, "components[support-1].geometry", "exactly one"),
        (
            {"world_T_component": {"p_m": [0, 0, 0], "q_wxyz": [1, 1, 0, 0]}},
            "components[support-1].world_T_component",
            "length 1.4142",
        ),
    ],
)
def test_a_wrong_key_is_told_with_its_place(
    tmp_path: Path, change: dict[str, Any], place: str, words: str
) -> None:
    (problem,) = changed(tmp_path, components=first_component(**change))
    assert problem.where == place
    assert words in problem.message


def test_a_misspelt_key_comes_with_a_suggestion(tmp_path: Path) -> None:
    (problem,) = changed(tmp_path, components=first_component(construction_parent=[]))
    assert "construction_parents" in problem.message


def test_all_problems_of_a_file_come_together(tmp_path: Path) -> None:
    components = document()["components"]
    components[0]["construction_parents"] = ["nobody"]
    components[1]["geometry"]["box"]["size_m"] = [2.4, 0.0, 0.14]
    components[2]["order"] = 0
    stacks = [{**s, "items": ["thick.99"]} for s in document()["stacks"]]
    for stack in stacks:
        stack.pop("generated")
    found = changed(tmp_path, components=components, stacks=stacks)
    assert set(codes(found)) >= {"P1", "G6", "P4", "M1", "M4"}
    assert all(p.where and p.message and p.fix for p in found)


def test_a_duplicate_id_is_refused(tmp_path: Path) -> None:
    components = document()["components"]
    found = changed(tmp_path, components=[*components, components[0]])
    assert [(p.code, p.where) for p in found] == [("D1", "support-1")]


def test_a_component_may_not_take_the_id_of_a_generated_piece(tmp_path: Path) -> None:
    components = [*document()["components"], {**document()["components"][0], "id": "thin.2"}]
    assert [p.where for p in changed(tmp_path, components=components)] == ["thin.2"]


def test_as_built_records_stand_only_in_exported_states(tmp_path: Path) -> None:
    text = json.dumps(document(components=first_component(as_built={"status": "verified"})))
    assert "I2" in codes(rejected(tmp_path, text))
    assert read_building(tmp_path / "building.json", is_exported=True).name == "Wooden frame"


def test_a_hand_written_quaternion_is_made_exact(tmp_path: Path) -> None:
    pose = {"p_m": [-0.6, 0.0, 0.07], "q_wxyz": [-0.7071, 0, 0, -0.7071]}
    path = tmp_path / "building.json"
    path.write_text(json.dumps(document(components=first_component(world_T_component=pose))))
    read = read_building(path).component_by_id[ComponentId("support-1")].world_T_component
    assert read.quaternion_wxyz == pytest.approx((0.5**0.5, 0, 0, 0.5**0.5), abs=1e-12)


def test_every_kind_of_geometry_survives_writing(tmp_path: Path) -> None:
    profile = ((0.0, 0.0), (0.2, 0.0), (0.2, 0.1), (0.0, 0.1))
    made = component("plate", ground=True)
    from dataclasses import replace

    plate = replace(made, geometry=ExtrusionGeometry(profile, 0.02))
    before = model(plate, stacks=[stock(1)])
    write_building(before, tmp_path / "b.json")
    assert read_building(tmp_path / "b.json") == before


def test_an_interrupted_write_leaves_the_old_file_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "building.json"
    write_building(model(component("a", ground=True)), path)
    before = path.read_bytes()

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        write_building(model(component("b", ground=True)), path)
    assert path.read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["building.json"]


def test_writing_is_sorted_short_and_stable(tmp_path: Path) -> None:
    one, two = component("b", ground=True), component("a", ground=True)
    path = tmp_path / "b.json"
    write_building(model(one, two), path)
    text = path.read_text()
    assert text.index('"a"') < text.index('"b"')
    assert max(map(len, text.splitlines())) <= 100
    write_building(read_building(path), path)
    assert path.read_text() == text
    assert read_building(path).component_by_id[one.id].world_T_component == Pose((0.0, 0.0, 0.02))
