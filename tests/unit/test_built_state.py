"""States of a project's building: as designed, as a run left it, now; with or without a cell."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from builders_history import ROBOT, built, wrote_run
from sitewright.app.built_state import BuiltState, Moment, state_at
from sitewright.app.installing import as_built_model
from sitewright.app.project import new_project, open_project
from sitewright.building_model.component import AsBuilt, Layer
from sitewright.building_model.formats.native import read_building
from sitewright.central_controller.events import SiteObserved
from sitewright.central_controller.site_state import PlacedPiece, site_of
from sitewright.errors import CellRejectedError, ExecutionError, ModelRejectedError
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, translation

FIRST, SECOND = "0001-aaaa", "0002-bbbb"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return new_project(tmp_path / "frame")


def ran(folder: Path, run: str, targets: Mapping[str, str], *, until: str = "verified") -> None:
    """Write a run that builds targets of pieces half a millimetre off, until each has a status."""
    design = state_at(folder, Moment(is_design=True))
    events = []
    for target, piece in targets.items():
        wanted = design.design.component_by_id[ComponentId(target)].world_T_component
        at = translation(0.0005, 0.0, 0.0) @ design.world_T_model @ wanted
        events += built(design.design, target, piece, at, until=until)
    wrote_run(folder, run, *events)


def record(state: BuiltState, target: str) -> AsBuilt:
    found = state.as_built.component_by_id[ComponentId(target)].as_built
    assert found is not None
    return found


def stock(state: BuiltState) -> set[str]:
    return {i for s in state.as_built.stacks for i in s.items}


def test_a_project_without_runs_is_now_as_designed(folder: Path) -> None:
    now, designed = state_at(folder), state_at(folder, Moment(is_design=True))
    assert now.as_built == designed.as_built == designed.design
    assert (now.installed, now.notes) == (0, ())
    assert (now.name, designed.name) == ("as_built", "design")


def test_every_run_has_its_own_state_and_now_is_that_of_the_newest(folder: Path) -> None:
    ran(folder, FIRST, {"support-1": "thick.3"})
    ran(folder, SECOND, {"support-2": "thick.2"})
    design = state_at(folder, Moment(is_design=True))
    first, second = state_at(folder, Moment(run=FIRST)), state_at(folder, Moment(run=SECOND))
    assert [s.installed for s in (design, first, second, state_at(folder))] == [0, 1, 2, 2]
    assert stock(design) - stock(first) == {"thick.3"}
    assert stock(design) - stock(second) == {"thick.3", "thick.2"}
    assert record(first, "support-1").status == "verified"
    assert first.as_built.component_by_id[ComponentId("support-2")].as_built is None


@pytest.mark.parametrize("status", ["held", "placed", "fastened"])
def test_a_target_in_work_has_its_piece_but_is_no_as_built_component(
    folder: Path, status: str
) -> None:
    ran(folder, FIRST, {"support-1": "thick.3", "stud-1": "thin.5"}, until=status)
    now = state_at(folder)
    for target in ("support-1", "stud-1"):
        assert now.as_built.component_by_id[ComponentId(target)].layer is Layer.TARGET
        expected = "fastened" if (status, target) == ("placed", "support-1") else status
        assert record(now, target).status == expected, "a support has no operations to wait for"
    nails = set(record(now, "stud-1").operations.values())
    assert nails == ({"done"} if status == "fastened" else {"open"})
    assert now.installed == 0
    assert {"thick.3", "thin.5"}.isdisjoint(stock(now))


def test_a_target_that_a_person_must_put_right_is_rejected(folder: Path) -> None:
    model, target = read_building(folder / "building.json"), ComponentId("stud-1")
    placed = PlacedPiece(
        piece=ComponentId("thin.5"), world_T_wanted=Pose(), world_T_measured=Pose(), robot=ROBOT
    )
    site = replace(site_of(model), placed={target: placed}, needs_rework={target: "bent nail"})
    component = as_built_model(model, site, {}).component_by_id[target]
    assert component.as_built is not None
    assert (component.layer, component.as_built.status) == (Layer.TARGET, "rejected")


def test_the_state_of_a_run_is_about_the_design_that_it_built(folder: Path) -> None:
    ran(folder, FIRST, {"support-1": "thick.3"})
    (folder / "runs" / "designs").mkdir()
    old = (folder / "building.json").read_bytes()
    (folder / "runs" / "designs" / f"{sha256_hex(old)}.json").write_bytes(old)
    changed = json.loads(old)
    changed["name"] = "changed"
    (folder / "building.json").write_text(json.dumps(changed), encoding="utf-8")
    assert state_at(folder).design.name == "changed"
    then = state_at(folder, Moment(run=FIRST))
    assert then.design.name == json.loads(old)["name"]
    assert then.notes == ()


def test_a_run_whose_design_was_not_kept_says_so(folder: Path) -> None:
    ran(folder, FIRST, {"support-1": "thick.3"})
    document = json.loads((folder / "building.json").read_bytes())
    (folder / "building.json").write_text(json.dumps(document), encoding="utf-8")
    state = state_at(folder, Moment(run=FIRST))
    assert state.installed == 1
    assert state.notes == ("The design of that run was not kept; this is today's.",)


def test_an_unknown_run_is_refused_with_the_known_ones(folder: Path) -> None:
    ran(folder, FIRST, {"support-1": "thick.3"})
    with pytest.raises(ExecutionError, match="Did you mean 0001-aaaa"):
        state_at(folder, Moment(run="0001-aaab"))


def test_a_building_without_a_usable_cell_has_its_design_state(folder: Path) -> None:
    (folder / "cell.toml").unlink()
    (note,) = state_at(folder).notes
    assert "it is not there" in note
    (folder / "cell.toml").write_text("nonsense = 1", encoding="utf-8")
    broken = state_at(folder)
    assert (broken.cell, broken.world_T_model) == (None, Pose())
    assert "model's own frame" in broken.notes[0]


def test_what_was_built_in_a_cell_needs_that_cell(folder: Path) -> None:
    ran(folder, FIRST, {"support-1": "thick.3"})
    (folder / "cell.toml").write_text("nonsense = 1", encoding="utf-8")
    with pytest.raises(CellRejectedError):
        state_at(folder)
    assert state_at(folder, Moment(is_design=True)).cell is None


def test_a_model_that_cannot_be_built_has_a_state_and_its_errors_are_counted(folder: Path) -> None:
    document = json.loads((folder / "building.json").read_bytes())
    document["components"][0]["construction_parents"] = ["nobody"]
    (folder / "building.json").write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(ModelRejectedError):
        open_project(folder)
    state = state_at(folder)
    assert len(state.as_built.component_by_id) > 5
    assert "sitewright check" in state.notes[0]


def test_stock_is_where_it_was_seen_last(folder: Path) -> None:
    seen = translation(1.0, 2.0, 3.0)
    wrote_run(folder, FIRST, SiteObserved(time_s=0.0, world_T_piece={ComponentId("thin.5"): seen}))
    sensed = state_at(folder).site.sensed
    assert sensed is not None
    assert sensed.world_T_piece[ComponentId("thin.5")] == seen
