"""A real timber frame of compas_timber: its figures, and what is refused of broken files."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sitewright.building_model.component import BoxGeometry, Layer
from sitewright.building_model.formats.compas_timber import read_compas_timber
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.foreign_files import read_foreign
from sitewright.building_model.formats.from_neutral import model_of
from sitewright.building_model.formats.import_map import ImportMap
from sitewright.building_model.formats.import_process import Limits
from sitewright.building_model.formats.native import read_building, write_building
from sitewright.building_model.inference.assembly import infer_assembly
from sitewright.building_model.inference.contact import contacts_of
from sitewright.building_model.inference.solid import Solid, solid_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.validation import check_model
from sitewright.construction_graph.project_check import check_project
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.ids import ComponentId
from sitewright.robot_team.formats.cell_toml import read_cell

CELL = Path(__file__).parents[2] / "examples" / "frame_house" / "cell.toml"

pytest.importorskip("compas_timber", reason="needs compas_timber: pip install 'sitewright[timber]'")


@pytest.fixture(scope="module")
def file(shared_data: Path) -> Path:
    return shared_data / "timber" / "frame_house.json"


@pytest.fixture(scope="module")
def house(file: Path) -> BuildingModel:
    model, problems = imported(file)
    assert problems == []
    return model


@pytest.fixture(scope="module")
def project(house: BuildingModel) -> tuple[BuildingModel, list[Problem]]:
    return infer_assembly(house)


def imported(path: Path, unit: str | None = "mm") -> tuple[BuildingModel, list[Problem]]:
    return model_of(read_compas_timber(path), path, unit=unit)


def solids(model: BuildingModel) -> dict[ComponentId, Solid]:
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    return {c.id: s for c in targets if (s := solid_of(c)) is not None}


def refusal(path: Path, unit: str | None = "mm") -> Problem:
    with pytest.raises(ModelRejectedError) as rejected:
        imported(path, unit)
    (problem,) = rejected.value.problems
    return problem


def test_the_frame_has_its_beams_joints_and_cuts(house: BuildingModel) -> None:
    components = list(house.component_by_id.values())
    assert len(components) == 31
    assert sum(len(c.cuts) for c in components) == 84
    assert Counter(str(r.data["type"]) for r in house.relations) == {
        "TButtJoint": 42,
        "LButtJoint": 21,
    }
    assert {c.type for c in components} == {
        "ceiling",
        "floor",
        "main",
        "support",
        "verticals",
        "window",
    }


def test_blanks_have_the_lengths_after_joinery(house: BuildingModel) -> None:
    lengths = Counter(
        round(c.geometry.size_m[0] * 1000.0, 1)
        for c in house.component_by_id.values()
        if isinstance(c.geometry, BoxGeometry)
    )
    assert lengths == {
        400.4: 2,
        1000.0: 1,
        1060.0: 1,
        1403.2: 1,
        1414.2: 2,
        1500.0: 5,
        1507.1: 2,
        1560.0: 3,
        1620.0: 1,
        1731.9: 1,
        2000.0: 3,
        2060.0: 2,
        2120.0: 2,
        2270.9: 1,
        3000.0: 1,
        3060.0: 1,
        3120.0: 2,
    }


def test_trimmed_beams_touch_in_54_pairs_and_all_of_them_are_joined(house: BuildingModel) -> None:
    contacts = contacts_of(solids(house))
    joined = {frozenset((r.a, r.b)) for r in house.relations}
    assert len(joined) == 63
    assert len(contacts) == 54
    assert all(frozenset((c.a, c.b)) in joined for c in contacts)


def test_the_frame_stands_upright(house: BuildingModel) -> None:
    heights = [s.highest_m((0.0, 0.0, 1.0)) for s in solids(house).values()]
    assert max(heights) == pytest.approx(2.06)
    assert min(s.lowest_m((0.0, 0.0, 1.0)) for s in solids(house).values()) == pytest.approx(-0.06)


def test_ids_are_those_of_the_file(house: BuildingModel, file: Path) -> None:
    assert set(house.component_by_id) == set(json.loads(file.read_text())["data"]["elements"])
    assert all(c.source and c.source.id == c.id for c in house.component_by_id.values())
    assert len({c.name for c in house.component_by_id.values()}) == 31


def test_everything_gets_its_place_in_the_order(
    project: tuple[BuildingModel, list[Problem]],
) -> None:
    model, problems = project
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    order = {c.id: c.order for c in targets}
    assert sorted(n for n in order.values() if n is not None) == list(range(1, 32))
    assert sum(c.ground for c in targets) == 9
    assert {p.code for p in problems} == {"F1"}
    for component in targets:
        assert component.ground or component.construction_parents
        number = order[component.id]
        assert number is not None
        assert all((order[p] or 99) < number for p in component.construction_parents)


def test_no_beam_has_to_slide_into_place(project: tuple[BuildingModel, list[Problem]]) -> None:
    model, _ = project
    ways = [c.ext["insertion"] for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    assert [w["slide_m"] for w in ways if isinstance(w, dict)] == [0.0] * 31


def test_the_project_fits_the_example_cell(
    project: tuple[BuildingModel, list[Problem]], tmp_path: Path
) -> None:
    model, problems = project
    write_building(model, tmp_path / "building.json")
    again = read_building(tmp_path / "building.json")
    found = [*check_model(again), *check_project(again, read_cell(CELL))]
    assert [p for p in found if p.severity == "E"] == []
    holds = {r.b for r in again.relations if r.kind is RelationKind.HOLD}
    assert len(holds) == len(problems) == 5
    assert sum(len(s.items) for s in again.stacks) == 31


def test_without_a_unit_both_readings_are_told(file: Path) -> None:
    problem = refusal(file, None)
    assert problem.code == "U1"
    assert "Longest part 3120: as mm 3.12 m, as m 3120 m" in problem.message
    assert "--unit mm" in problem.fix


def test_an_unknown_unit_comes_with_a_suggestion(file: Path) -> None:
    assert "Did you mean mm" in refusal(file, "mmm").message


def test_metres_in_place_of_millimetres_are_suspected(file: Path) -> None:
    _, problems = imported(file, "m")
    (problem,) = [p for p in problems if p.code == "U2"]
    assert problem.severity == "W"
    assert "mm" in str(problem)


def cut_off(text: str) -> str:
    return text[: len(text) // 2]


def nested(_text: str) -> str:
    return '{"dtype": "compas_timber.model/TimberModel", "data": ' + "[" * 5000 + "]" * 5000 + "}"


def with_foreign_type(text: str) -> str:
    return text.replace("compas.geometry/Frame", "subprocess/Popen", 1)


def with_nan(text: str) -> str:
    return text.replace("497.9030250550997", "NaN", 1)


def another_object(_text: str) -> str:
    point = {"dtype": "compas.geometry/Point", "data": [0.0, 0.0, 0.0], "guid": "x"}
    return json.dumps({"data": {}, "note": '"compas_timber.', **point})


def empty_model(_text: str) -> str:
    from compas.data import json_dumps
    from compas_timber.model import TimberModel

    return str(json_dumps(TimberModel()))


@pytest.mark.parametrize(
    ("change", "code", "words"),
    [
        (cut_off, "E4", "cut off"),
        (nested, "E5", "nested"),
        (with_foreign_type, "E2", "'subprocess/Popen'"),
        (with_nan, "K3", "NaN"),
        (empty_model, "E3", "read 0 beams"),
        (lambda _: "", "E2", "empty"),
        (lambda _: "version https://git-lfs.github.com/spec/v1\noid sha256:0", "E2", "Git LFS"),
        (lambda _: "ISO-10303-21;\nHEADER;", "E3", "looks like: ifc"),
        (lambda _: "<BTLx xmlns='https://www.design2machine.com'/>", "E3", "looks like: btlx"),
        (lambda _: '{"vertex": {}}', "E3", "looks like: json"),
        (lambda _: "\x00\x01", "E3", "looks like: unknown"),
        (lambda t: t.replace('"width": 60', '"breadth": 60'), "E2", "compas_timber cannot read it"),
        (
            lambda t: t.replace('"height": 120', '"height": 1e19', 2),
            "E2",
            "cannot work out beam",
        ),
    ],
)
def test_a_broken_file_is_one_clear_error(
    file: Path, tmp_path: Path, change: Callable[[str], str], code: str, words: str
) -> None:
    broken = tmp_path / "broken.json"
    broken.write_text(change(file.read_text()))
    problem = refusal(broken)
    assert problem.code == code
    assert words in problem.message
    assert problem.fix
    assert [p.name for p in tmp_path.iterdir()] == ["broken.json"]


def test_every_beam_without_thickness_is_told(file: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.json"
    broken.write_text(file.read_text().replace('"width": 60', '"width": 0'))
    with pytest.raises(ModelRejectedError) as rejected:
        imported(broken)
    flat = [p for p in rejected.value.problems if p.severity == "E"]
    assert len(flat) == file.read_text().count('"width": 60')
    assert {p.code for p in flat} == {"G6"}
    assert all("blank has the size" in p.message for p in flat)


def test_a_missing_file_is_one_clear_error(tmp_path: Path) -> None:
    assert "no such file" in refusal(tmp_path / "none.json").message


def test_a_file_that_is_no_text_is_one_clear_error(file: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.json"
    broken.write_bytes(file.read_bytes()[:5000] + b"\xff\xfe" + file.read_bytes()[5000:])
    assert refusal(broken).code == "E5"


def test_a_reader_without_memory_is_told(file: Path) -> None:
    starved = Limits(memory_bytes=64 * 1024**2)
    with pytest.raises(ModelRejectedError) as rejected:
        read_foreign(file, FileKind.COMPAS_TIMBER, limits=starved)
    (problem,) = rejected.value.problems
    assert problem.code == "E2"
    assert "the reader" in problem.message
    assert "not installed" not in problem.message


def test_importing_writes_nothing_beside_the_file(file: Path) -> None:
    def listing() -> Any:
        return sorted(p.name for p in file.parent.iterdir())

    before = listing()
    read_foreign(file, FileKind.COMPAS_TIMBER)
    assert listing() == before


def test_a_child_process_reads_the_same_as_we_do(file: Path) -> None:
    assert read_foreign(file, FileKind.COMPAS_TIMBER) == read_compas_timber(file)


def test_attributes_of_beams_are_mapped(file: Path) -> None:
    words = ImportMap(foreign_keys={"group": ("category",)})
    model, _ = model_of(read_compas_timber(file), file, unit="mm", mapping=words)
    assert {c.group for c in model.component_by_id.values()} == {
        c.raw["category"] for c in model.component_by_id.values()
    }
