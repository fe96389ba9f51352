"""The as-built table."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

from sitewright.app.project import example_folder
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.as_built_table import as_built_csv
from sitewright.building_model.component import Layer, Source
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, translation

WORLD_T_MODEL = translation(0.0, 0.0, 0.4)
STUD, PIECE = ComponentId("stud-1"), ComponentId("thin.5")


def built() -> BuildingModel:
    model = read_building(example_folder("wooden_frame") / "building.json")
    source = Source(file="frame.3dm", kind="rhino", id="A-1")
    stud = replace(model.component_by_id[STUD], source=source)
    model = replace(model, component_by_id={**model.component_by_id, STUD: stud})
    off = WORLD_T_MODEL @ stud.world_T_component @ translation(0.003, 0.0, 0.004)
    record = InstallRecord(
        target=STUD,
        material=PIECE,
        world_T_measured=off,
        robot="kr120-a",
        installed_at="2026-11-24T03:00:00+00:00",
    )
    return fold(model, [record])


def rows(text: str) -> dict[str, dict[str, str]]:
    return {r["id"]: r for r in csv.DictReader(io.StringIO(text))}


def test_the_table_has_the_building_and_no_stock_or_zone() -> None:
    table = rows(as_built_csv(built(), WORLD_T_MODEL))
    assert set(table) == {"stud-1", "stud-2", "stud-3", "support-1", "support-2"}
    assert table["stud-2"]["status"] == "planned"
    assert table["stud-2"]["deviation_mm"] == ""


def test_an_installed_component_tells_its_piece_robot_time_and_deviation() -> None:
    stud = rows(as_built_csv(built(), WORLD_T_MODEL))["stud-1"]
    assert (stud["material_used"], stud["robot"]) == (PIECE, "kr120-a")
    assert stud["installed_at"] == "2026-11-24T03:00:00+00:00"
    assert stud["deviation_mm"] == "5.00"
    assert stud["deviation_deg"] == "0.000"


def test_what_stood_before_is_neither_planned_nor_built() -> None:
    model = built()
    there = replace(model.component_by_id[ComponentId("support-1")], layer=Layer.AS_BUILT)
    model = replace(model, component_by_id={**model.component_by_id, there.id: there})
    assert rows(as_built_csv(model, WORLD_T_MODEL))["support-1"]["status"] == ""


def test_poses_without_a_measurement_are_those_of_the_design_in_the_world() -> None:
    support = rows(as_built_csv(built(), WORLD_T_MODEL))["support-1"]
    model = built().component_by_id[ComponentId("support-1")].world_T_component
    assert float(support["z_m"]) == round((WORLD_T_MODEL @ model).position_m[2], 6)
    assert float(rows(as_built_csv(built(), Pose()))["support-1"]["z_m"]) == model.position_m[2]
