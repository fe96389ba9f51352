"""A changed file and the user's own edits meet in a three-way merge."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from builders_frame import beam, frame, portal
from sitewright.building_model.component import BoxGeometry, Operation, Process
from sitewright.building_model.merging import Preference, in_coordinates_of, merged_design
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.building_model.same_value import is_same
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import translation

RAIL = ComponentId("rail")
BASE = portal()


def with_(model: BuildingModel, **facts: Any) -> BuildingModel:
    """Change facts of the rail."""
    changed = replace(model.component_by_id[RAIL], **facts)
    return replace(model, component_by_id={**model.component_by_id, RAIL: changed})


def without(model: BuildingModel) -> BuildingModel:
    components = {i: c for i, c in model.component_by_id.items() if i != RAIL}
    relations = tuple(r for r in model.relations if RAIL not in (r.a, r.b))
    return replace(model, component_by_id=components, relations=relations)


def nail(name: str) -> Operation:
    return Operation(id=OperationId(name), process=Process.NAIL, on=(RAIL, ComponentId("left")))


def test_nothing_changes_if_the_file_says_what_it_said() -> None:
    mine = with_(BASE, order=7, ext={"colour": "red"})
    assert merged_design(BASE, mine, BASE) == (mine, [])


def test_noise_of_an_export_is_no_change() -> None:
    near = translation(0.0, 0.0, 1e-8) @ BASE.component_by_id[RAIL].world_T_component
    assert merged_design(BASE, BASE, with_(BASE, world_T_component=near)) == (BASE, [])


def test_what_only_the_file_changed_is_taken_and_what_only_the_user_changed_stays() -> None:
    pose = translation(0.0, 0.0, 0.1)
    mine = with_(BASE, order=7, operations=(nail("own"),), raw={"a": 1})
    theirs = with_(BASE, world_T_component=pose, operations=(nail("drawn"),), raw={"b": 2})
    merged, conflicts = merged_design(BASE, mine, theirs)
    rail = merged.component_by_id[RAIL]
    assert conflicts == []
    assert (rail.world_T_component, rail.order) == (pose, 7)
    assert [o.id for o in rail.operations] == ["drawn", "own"]
    assert rail.raw == {"a": 1, "b": 2}


@pytest.mark.parametrize("prefer", Preference)
def test_a_fact_that_both_changed_is_told_and_one_of_them_wins(prefer: Preference) -> None:
    mine, theirs = with_(BASE, type="mine"), with_(BASE, type="theirs")
    merged, (conflict,) = merged_design(BASE, mine, theirs, prefer)
    wanted = "mine" if prefer is Preference.MINE else "theirs"
    assert merged.component_by_id[RAIL].type == wanted
    assert (conflict.where, conflict.key, conflict.mine, conflict.file, conflict.taken) == (
        "rail",
        "type",
        "mine",
        "theirs",
        prefer,
    )


def test_both_changing_it_alike_is_no_conflict() -> None:
    both = with_(BASE, geometry=BoxGeometry((1.0, 0.1, 0.1)))
    assert merged_design(BASE, both, both) == (both, [])


def test_what_the_file_adds_and_removes_comes_and_goes_with_its_relations() -> None:
    new = beam("brace", (0.0, 0.0, 0.5), (1.0, 0.1, 0.1))
    own = Relation(kind=RelationKind.BEFORE, a=RAIL, b=ComponentId("plate"))
    mine = replace(BASE, relations=(*BASE.relations, own))
    gone = without(BASE)
    theirs = replace(gone, component_by_id={**gone.component_by_id, new.id: new})
    merged, conflicts = merged_design(BASE, mine, theirs)
    assert set(merged.component_by_id) == {"sill", "left", "right", "plate", "brace"}
    assert all(RAIL not in (r.a, r.b) for r in merged.relations)
    assert conflicts == []


def test_what_the_user_added_or_removed_stays_so() -> None:
    own = beam("own", (0.0, 0.0, 3.0), (1.0, 0.1, 0.1))
    mine = without(BASE)
    mine = replace(mine, component_by_id={**mine.component_by_id, own.id: own})
    merged, conflicts = merged_design(BASE, mine, BASE)
    assert (merged.component_by_id, conflicts) == (
        dict(sorted(mine.component_by_id.items())),
        [],
    )


@pytest.mark.parametrize(
    ("mine", "theirs", "taken"),
    [
        (with_(BASE, order=3), without(BASE), Preference.FILE),
        (without(BASE), with_(BASE, type="other"), Preference.MINE),
    ],
)
def test_removed_on_one_side_and_changed_on_the_other_is_told(
    mine: BuildingModel, theirs: BuildingModel, taken: Preference
) -> None:
    merged, conflicts = merged_design(BASE, mine, theirs)
    assert RAIL not in merged.component_by_id
    assert [(c.where, c.key, c.taken) for c in conflicts] == [("rail", "", taken)]


def test_another_shift_of_the_origin_moves_nothing() -> None:
    far = replace(BASE, origin_shift_m=(2000.0, 0.0, 0.0))
    components = {
        i: replace(c, world_T_component=translation(-3.0, 0.0, 0.0) @ c.world_T_component)
        for i, c in BASE.component_by_id.items()
    }
    again = replace(far, component_by_id=components, origin_shift_m=(2003.0, 0.0, 0.0))
    assert is_same(in_coordinates_of(again, far).component_by_id, far.component_by_id)


def test_facts_of_the_whole_model_are_merged_too() -> None:
    mine = replace(BASE, materials={"C24": {"density_kg_m3": 420.0}}, rules=({"id": "r"},))
    theirs = replace(BASE, raw={"survey": {"crs": "x"}}, materials={"GL": {"density_kg_m3": 500.0}})
    merged, conflicts = merged_design(BASE, mine, theirs)
    assert conflicts == []
    assert set(merged.materials) == {"C24", "GL"}
    assert (merged.rules, merged.raw) == (mine.rules, theirs.raw)


def test_a_frame_of_another_name_keeps_its_own() -> None:
    assert merged_design(BASE, BASE, replace(frame([]), name="v2"))[0].name == BASE.name
