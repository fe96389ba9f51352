"""What became of each object of the imported file, by its own id."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

from builders_building import component, model, nail, piece, stock
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.component import Component, Layer, Source
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.object_states import ObjectState, object_states, status_document
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, rotation, translation

WORLD_T_MODEL = translation(0.0, 0.0, 0.4) @ rotation((0.0, 0.0, 1.0), 0.5)
AT = "2030-05-01T09:00:00+00:00"


def drawn(made: Component, source: str, kind: str = "rhino") -> Component:
    return replace(made, source=Source(file="", kind=kind, id=source))


def record(target: str, material: str, at: Pose = WORLD_T_MODEL, **more: Any) -> InstallRecord:
    facts: dict[str, Any] = {"robot": "kr120-a", "installed_at": AT, **more}
    return InstallRecord(
        target=ComponentId(target), material=ComponentId(material), world_T_measured=at, **facts
    )


def states(
    design: BuildingModel, *records: InstallRecord, at: Pose = WORLD_T_MODEL
) -> dict[str, ObjectState]:
    return object_states(design, fold(design, records), at)


def told(design: BuildingModel, *records: InstallRecord) -> dict[str, Any]:
    """Return the document as a reader of the file gets it."""
    document = status_document(states(design, *records))
    found: dict[str, Any] = json.loads(json.dumps(document, allow_nan=False))
    return found


def frame() -> BuildingModel:
    """Return two targets, a pile of stock, a drawn line and a zone, all of one drawing."""
    nails = (nail("n-1", on=["stud", "sill"], at_m=(0.0, 0.0, 0.0)),)
    pile = [drawn(p, f"P-{n}") for n, p in enumerate(stock(3), 1)]
    parts = [
        drawn(component("sill"), "A"),
        drawn(component("stud", operations=nails), "B"),
        drawn(component("line", layer=Layer.AS_DESIGNED), "C"),
        drawn(component("zone", layer=Layer.VIRTUAL_COLLISION), "D"),
        drawn(component("wall", layer=Layer.AS_BUILT), "E"),
        component("mine"),
    ]
    return model(*parts, stacks=[pile])


def test_every_object_of_the_file_has_an_entry_and_nothing_else_has() -> None:
    assert set(told(frame())) == {"A", "B", "C", "D", "E", "P-1", "P-2", "P-3"}


def test_before_anything_is_built_nothing_has_changed() -> None:
    found = told(frame())
    assert not any(e["changed"] for e in found.values())
    assert {e["moves_to"] for e in found.values()} == {""}
    statuses = {i: e["keys"].get("status") for i, e in found.items()}
    stock_too = dict.fromkeys(("P-1", "P-2", "P-3"), "available")
    plans = {"A": "planned", "B": "planned", "C": None, "D": None, "E": None}
    assert statuses == {**plans, **stock_too}


def test_what_was_built_tells_by_whom_of_what_when_and_how_exactly() -> None:
    off = WORLD_T_MODEL @ translation(0.003, 0.0, 0.024) @ rotation((0.0, 0.0, 1.0), 0.01)
    entry = told(frame(), record("sill", "piece-3", off, operations={OperationId("n"): "done"}))[
        "A"
    ]
    assert (entry["components"], entry["layer"], entry["moves_to"]) == (
        ["sill"],
        "as_built",
        "As-Built",
    )
    assert entry["keys"] == {
        "status": "verified",
        "built_at": AT,
        "robot": "kr120-a",
        "material_used": "piece-3",
        "deviation_mm": "5.00",
        "deviation_deg": f"{math.degrees(0.01):.3f}",
    }
    assert entry["operations"] == {"n": "done"}


def test_the_measured_pose_is_in_the_coordinates_of_the_file() -> None:
    shifted = replace(frame(), origin_shift_m=(1000.0, 0.0, -5.0))
    at = WORLD_T_MODEL @ translation(0.1, 0.2, 0.3)
    measured = told(shifted, record("sill", "piece-3", at))["A"]["measured"]
    assert measured == {"p_m": [1000.1, 0.2, -4.7], "q_wxyz": [1.0, 0.0, 0.0, 0.0]}


def test_a_used_piece_of_stock_is_stock_no_more_and_tells_for_what() -> None:
    found = told(frame(), record("sill", "piece-3"))
    assert found["P-3"] == {
        "components": ["piece-3"],
        "changed": True,
        "layer": "as_designed",
        "moves_to": "Consumed",
        "keys": {"status": "consumed", "used_for": "sill"},
    }
    assert found["P-2"]["keys"] == {"status": "available"}


def test_a_target_in_work_stays_on_its_layer() -> None:
    entry = told(frame(), record("stud", "piece-3", status="placed"))["B"]
    assert (entry["changed"], entry["layer"], entry["moves_to"]) == (True, "target", "")
    assert entry["keys"]["status"] == "placed"


def split(kind: str = "rhino", separator: str = ".") -> BuildingModel:
    bodies = [drawn(component(f"w{n}"), f"W{separator}{n}", kind) for n in (1, 2)]
    return model(*bodies, stacks=[[piece("p-1"), piece("p-2")]])


def test_an_object_of_which_only_a_body_is_built_is_partly_built() -> None:
    (found,) = states(split(), record("w2", "p-2")).values()
    assert (found.source_id, found.status, found.layer) == ("W", "partly", None)
    assert found.components == ("w1", "w2")
    assert (found.is_changed, found.moves_to) == (True, "")


def test_an_object_all_of_whose_bodies_are_built_is_built_since_the_last_one() -> None:
    later = "2030-05-01T10:00:00+00:00"
    records = record("w1", "p-1", installed_at=later), record("w2", "p-2")
    (found,) = states(split(), *records).values()
    assert (found.status, found.layer, found.moves_to) == ("verified", Layer.AS_BUILT, "As-Built")
    assert found.record is not None
    assert found.record.installed_at == later


def test_a_dot_is_part_of_the_name_where_a_format_allows_one() -> None:
    assert set(states(split("obj"))) == {"W.1", "W.2"}
    assert set(states(split("ifc"))) == {"W"}
