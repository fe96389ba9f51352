"""Exports of a project as a user asks for them: which state, of which project, to where."""

from __future__ import annotations

import csv
import io
import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from builders_foreign import BARS
from builders_gltf import bodies_in, colour_of, document_in, facts_in
from builders_history import built, wrote_run
from sitewright.app.built_state import state_at
from sitewright.app.importing import import_file
from sitewright.app.project import ProjectError, new_project
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.shapes import extent_of, shape_of, volume_of
from sitewright.central_controller.events import SiteObserved
from sitewright.cli.main import commands
from sitewright.errors import ExecutionError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import translation

FIRST, SECOND = "0001-aaaa", "0002-bbbb"
OFF = translation(0.003, 0.0, 0.004)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the wooden frame after one support was built, and another and a stud are in work."""
    folder = new_project(tmp_path_factory.mktemp("exports") / "frame")
    design = state_at(folder)
    poses = {
        t: OFF
        @ design.world_T_model
        @ design.design.component_by_id[ComponentId(t)].world_T_component
        for t in ("support-1", "support-2", "stud-1")
    }
    wrote_run(folder, FIRST, *built(design.design, "support-1", "thick.3", poses["support-1"]))
    moved = SiteObserved(
        time_s=1.0, world_T_piece={ComponentId("thin.4"): translation(2.0, 3.0, 0.5)}
    )
    wrote_run(
        folder,
        SECOND,
        *built(design.design, "support-2", "thick.2", poses["support-2"]),
        *built(design.design, "stud-1", "thin.5", poses["stud-1"], until="placed"),
        moved,
    )
    return folder


def export(*words: object) -> Result:
    return CliRunner().invoke(commands, ["export", *map(str, words)], catch_exceptions=False)


def exported(project: Path, *words: object) -> dict[str, Any]:
    result = export(project, *words, "--json")
    assert result.exit_code == 0, result.output
    found: dict[str, Any] = json.loads(result.stdout)
    return found


@pytest.fixture(scope="module")
def scene(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("scene") / "now.glb"
    assert exported(project, "--gltf", "-o", out)["installed"] == 2
    return out


def test_the_scene_shows_everything_with_its_layer_and_status(scene: Path) -> None:
    facts = facts_in(scene)
    statuses = {i: (f["layer"], f.get("status")) for i, f in facts.items()}
    assert statuses["support-1"] == statuses["support-2"] == ("as_built", "verified")
    assert statuses["stud-1"] == ("target", "placed")
    assert statuses["stud-2"] == ("target", "planned")
    assert statuses["thin.4"] == ("material", "available")
    assert {"thick.3", "thick.2", "thin.5"}.isdisjoint(facts), "they are stock no more"
    assert facts["support-1"]["robot"] == "kr120-a"
    assert facts["support-1"]["material_used"] == "thick.3"
    assert facts["support-1"]["deviation_mm"] == 5.0
    assert facts["stud-1"]["operations"] == dict.fromkeys(facts["stud-1"]["operations"], "open")
    assert set(facts) == set(bodies_in(scene)), "another library finds the same nodes"
    assert document_in(scene)["scenes"][0]["extras"] == {
        "schema": "sitewright.scene/1",
        "state": "as_built",
        "installed": 2,
        "frame": "cell",
    }


def test_each_layer_and_status_has_its_colour(scene: Path) -> None:
    names = ("support-1", "stud-1", "stud-2", "thin.4", "service-column")
    colours = [colour_of(scene, n) for n in names]
    assert colours == ["as_built", "in work", "target", "material", "virtual_collision"]


def test_what_was_sensed_is_drawn_where_it_was_and_all_else_where_it_should_be(
    project: Path, scene: Path
) -> None:
    design, bodies = state_at(project), bodies_in(scene)
    for name in ("support-1", "stud-1", "stud-2"):
        component = design.design.component_by_id[ComponentId(name)]
        pose = design.world_T_model @ component.world_T_component
        sensed = pose if name == "stud-2" else OFF @ pose
        wanted = extent_of(shape_of(component), sensed)
        assert bodies[name].low_m == pytest.approx(wanted.low_m, abs=1e-6)
        assert bodies[name].high_m == pytest.approx(wanted.high_m, abs=1e-6)
    assert bodies["thin.4"].low_m[2] == pytest.approx(0.48)
    assert bodies["thin.4"].high_m[2] == pytest.approx(0.52)


def test_stock_that_nobody_saw_lies_in_its_pile_at_its_stock_place(
    project: Path, scene: Path
) -> None:
    state, bodies = state_at(project), bodies_in(scene)
    assert state.cell is not None
    (pile,) = [s for s in state.as_built.stacks if "thick.1" in s.items]
    place = state.cell.stock_place_by_id[pile.place].world_T_stock.position_m
    assert bodies["thick.1"].low_m[2] == pytest.approx(place[2], abs=1e-6)
    spans = zip(bodies["thick.1"].low_m[:2], bodies["thick.1"].high_m[:2], strict=True)
    assert [(a + b) / 2.0 for a, b in spans] == pytest.approx(list(place[:2]), abs=1e-6)


def test_the_design_and_every_run_have_their_own_scene(project: Path, tmp_path: Path) -> None:
    design = exported(project, "--gltf", "--design", "-o", tmp_path / "design.glb")
    first = exported(project, "--gltf", "--run", FIRST, "-o", tmp_path / "first.glb")
    assert (design["installed"], first["installed"]) == (0, 1)
    before, after = facts_in(tmp_path / "design.glb"), facts_in(tmp_path / "first.glb")
    assert set(before) - set(after) == {"thick.3"}
    assert {f["layer"] for i, f in before.items() if i == "support-1"} == {"target"}
    assert [after[i]["layer"] for i in ("support-1", "support-2")] == ["as_built", "target"]


def test_other_kinds_of_export_are_of_the_same_states(project: Path, tmp_path: Path) -> None:
    for words, installed in ((["--design"], 0), (["--run", FIRST], 1), ([], 2)):
        exported(project, "--csv", *words, "-o", tmp_path / "t.csv")
        rows = list(csv.DictReader(io.StringIO((tmp_path / "t.csv").read_text(encoding="utf-8"))))
        assert sum(r["status"] == "verified" for r in rows) == installed
        exported(project, "--json-model", *words, "-o", tmp_path / "t.json")
        model = read_building(tmp_path / "t.json", is_exported=True)
        assert sum(c.layer == "as_built" for c in model.component_by_id.values()) == installed


def test_files_are_named_after_the_state_that_they_show(project: Path) -> None:
    names = [Path(exported(project, "--gltf", *w)["files"][0]).name for w in ([], ["--design"])]
    assert names == ["as_built.glb", "design.glb"]


def test_sawn_and_composed_shapes_have_the_volume_of_the_model(
    shared_data: Path, tmp_path: Path
) -> None:
    import_file(shared_data / "timber" / "frame_house.btlx", tmp_path / "house")
    exported(tmp_path / "house", "--gltf")
    model = read_building(tmp_path / "house" / "building.json")
    bodies = bodies_in(tmp_path / "house" / "as_built.glb")
    assert set(bodies) == set(model.component_by_id)
    for name, component in model.component_by_id.items():
        assert bodies[name].is_closed
        assert bodies[name].volume_m3 == pytest.approx(volume_of(component), rel=1e-4)


def test_a_cell_that_lacks_the_stock_place_is_told_once_for_all_pieces(
    project: Path, tmp_path: Path
) -> None:
    bare = tmp_path / "bare"
    bare.mkdir()
    shutil.copy(project / "building.json", bare)
    notes = exported(bare, "--gltf")["notes"]
    assert [n for n in notes if "pallet-thick" in n] == [
        "Stock is not drawn (pieces: 3): the cell has no stock place 'pallet-thick'."
    ]
    assert len(notes) == 3
    assert set(facts_in(bare / "as_built.glb")) >= {"support-1", "stud-3"}
    assert document_in(bare / "as_built.glb")["scenes"][0]["extras"]["frame"] == "model"


def test_the_design_is_never_the_goal_and_a_goal_needs_a_folder(project: Path) -> None:
    before = (project / "building.json").read_bytes()
    for kind in ("--csv", "--json-model", "--gltf"):
        with pytest.raises(ProjectError, match="is the design"):
            export(project, kind, "-o", project / "building.json")
        with pytest.raises(ProjectError, match="is no folder"):
            export(project, kind, "-o", project / "nowhere" / "x")
    assert (project / "building.json").read_bytes() == before


def test_one_state_at_a_time_and_only_runs_that_are_there(project: Path) -> None:
    both = export(project, "--design", "--run", FIRST)
    assert (both.exit_code, "two states" in both.output) == (2, True)
    with pytest.raises(ExecutionError, match="There is no run '0003-cccc'"):
        export(project, "--run", "0003-cccc")


@pytest.mark.parametrize(("kind", "name"), [("--ifc", "ifc"), ("--3dm", "rhino")])
def test_a_patch_needs_the_file_that_the_project_was_imported_from(
    project: Path, kind: str, name: str
) -> None:
    with pytest.raises(ProjectError, match=f"The {name} file that .* Name it with --original"):
        export(project, kind)


@pytest.mark.parametrize(
    ("ending", "start"), [(".json", b"{"), (".glb", b"glTF"), (".csv", b"id,")]
)
def test_the_ending_says_the_kind_if_no_option_does(
    project: Path, tmp_path: Path, ending: str, start: bytes
) -> None:
    out = tmp_path / f"state{ending}"
    exported(project, "-o", str(out))
    assert out.read_bytes().startswith(start)
    exported(project, "--csv", "-o", str(out))
    assert out.read_bytes().startswith(b"id,")


def test_a_project_of_another_kind_of_file_has_none_to_patch(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_bytes(BARS)
    import_file(tmp_path / "a.json", tmp_path / "out")
    with pytest.raises(ProjectError, match=r"imported from bar_frame, not from ifc: .*--gltf"):
        export(tmp_path / "out", "--ifc")
