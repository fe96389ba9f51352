"""Nails and screws by rules: where they go, what is checked, what is refused."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import pytest

from builders_frame import beam, portal, upright
from sitewright.building_model.check_fasteners import MIN_PENETRATION_M, penetration_m
from sitewright.building_model.component import Component, FastenerSpec, Operation, Origin, Process
from sitewright.building_model.inference.completion import complete
from sitewright.building_model.inference.rules import rules_from
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.validation import check_model
from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, distance, dot

NAIL: Mapping[str, Json] = {"type": "nail", "d_m": 0.0031, "l_m": 0.09}
STUD_ENDS: Mapping[str, Json] = {
    "id": "stud-ends",
    "kind": "fasten",
    "through": "*plate",
    "into": "stud",
    "contact": "end-grain",
    "process": "nail",
    "fastener": NAIL,
    "count": 2,
}
DOUBLING: Mapping[str, Json] = {
    "id": "doubling",
    "kind": "fasten",
    "through": "top-plate",
    "into": "plate",
    "contact": "side",
    "fastener": {"type": "nail", "d_m": 0.0031, "l_m": 0.08},
    "count": 3,
}


def model_of(parts: Sequence[Component], *rules: Mapping[str, Json]) -> BuildingModel:
    return BuildingModel(
        name="panel",
        component_by_id={c.id: c for c in sorted(parts, key=lambda c: c.id)},
        rules=rules,
    )


def panel(*, has_double_plate: bool = False) -> list[Component]:
    """Return a wall panel that stands 0.3 m above the ground on two blocks: nine studs."""
    parts = [
        replace(beam("sole", (2.4, 0.0, 0.3225), (4.845, 0.095, 0.045)), type="plate"),
        replace(beam("top", (2.4, 0.0, 2.7675), (4.845, 0.095, 0.045)), type="plate"),
        beam("block-1", (0.3, 0.0, 0.15), (0.2, 0.2, 0.3), word="block"),
        beam("block-2", (4.5, 0.0, 0.15), (0.2, 0.2, 0.3), word="block"),
    ]
    parts += [
        replace(upright(f"stud-{k}", (0.6 * k, 0.0, 1.545), (2.4, 0.045, 0.095)), type="stud")
        for k in range(9)
    ]
    if has_double_plate:
        parts.append(beam("upper", (2.4, 0.0, 2.8125), (4.845, 0.095, 0.045), word="top-plate"))
    return parts


def operations(model: BuildingModel) -> list[tuple[Component, Operation]]:
    return [(c, o) for c in model.component_by_id.values() for o in c.operations]


def world(component: Component, operation: Operation) -> Pose:
    return component.world_T_component @ operation.component_T_operation


def test_all_18_stud_ends_of_a_panel_are_nailed_through_the_plates() -> None:
    model, problems = complete(model_of(panel(), STUD_ENDS))
    found = operations(model)
    assert not [p for p in problems if p.code in ("C1", "C3")]
    assert {o.on for _, o in found} == {(p, f"stud-{k}") for p in ("sole", "top") for k in range(9)}
    assert len(found) == 36
    assert len({o.id for _, o in found}) == 36
    assert all(o.origin is Origin.RULE and o.params["rule"] == "stud-ends" for _, o in found)
    assert not [p for p in check_model(model) if p.code in ("C1", "C2")]


def test_nails_enter_on_the_far_face_keep_their_distances_and_reach_deep_enough() -> None:
    model, _ = complete(model_of(panel(), STUD_ENDS))
    for component, operation in operations(model):
        through, into = (model.component_by_id[i] for i in operation.on)
        pose = world(component, operation)
        own = through.world_T_component.inverse() @ pose
        toward = dot(pose.z_axis, (0.0, 0.0, 1.0 if through.id == "sole" else -1.0))
        assert toward == pytest.approx(1.0)
        assert abs(own.position_m[2]) == pytest.approx(0.0225)
        assert abs(own.position_m[1]) <= 0.0475 - 5 * 0.0031 + 1e-9
        assert penetration_m(component, operation, into) >= MIN_PENETRATION_M
    for (_, a), (_, b) in combinations(operations(model), 2):
        if a.on == b.on:
            owner = next(c for c, o in operations(model) if o is a)
            apart = distance(world(owner, a).position_m, world(owner, b).position_m)
            assert apart >= 0.020


def test_the_later_of_two_owns_the_operation() -> None:
    model, _ = complete(model_of(panel(), STUD_ENDS))
    owners = {(o.on[0], c.id) for c, o in operations(model)}
    assert ("sole", "stud-3") in owners
    assert ("top", "top") in owners


def test_a_stud_that_would_topple_is_held_until_two_nails_are_in() -> None:
    model, _ = complete(model_of(panel(), STUD_ENDS))
    stud = model.component_by_id[ComponentId("stud-3")]
    assert stud.hold_until_fasteners == 2
    assert "times as high" in stud.origins["hold_until_fasteners"][1]
    assert model.component_by_id[ComponentId("top")].hold_until_fasteners == 0


def test_under_a_double_plate_the_studs_are_nailed_before_they_are_covered() -> None:
    model, problems = complete(model_of(panel(has_double_plate=True), STUD_ENDS, DOUBLING))
    first = {(r.a, r.b) for r in model.relations if r.kind is RelationKind.BEFORE}
    upper = model.component_by_id[ComponentId("upper")]
    assert upper.construction_parents == ("top",) or ("top", "upper") in first
    assert len(upper.operations) == 3
    assert not [p for p in problems if p.code in ("C1", "C3")]


def test_an_entry_face_on_the_ground_or_under_something_is_refused() -> None:
    parts = [replace(c, world_T_component=_lowered(c)) for c in panel() if "block" not in c.id]
    model, problems = complete(model_of(parts, STUD_ENDS))
    assert {p.code for p in problems} == {"C3"}
    assert len([p for p in problems if "the ground covers" in p.message]) == 9
    assert {o.on[0] for _, o in operations(model)} == {"top"}


def _lowered(component: Component) -> Pose:
    x, y, z = component.world_T_component.position_m
    return Pose((x, y, z - 0.3), component.world_T_component.quaternion_wxyz)


def test_a_nail_that_is_too_short_is_reported_and_not_made() -> None:
    short = {**STUD_ENDS, "fastener": {**NAIL, "l_m": 0.06}}
    model, problems = complete(model_of(panel(), short))
    assert [p.code for p in problems].count("C1") == 18
    assert operations(model) == []


def test_more_nails_than_fit_are_reported_with_how_many_do() -> None:
    model, problems = complete(model_of(panel(), {**STUD_ENDS, "count": 9}))
    assert {p.code for p in problems} == {"C3"}
    assert all("4 of 9 fasteners fit" in p.message for p in problems)
    assert len(operations(model)) == 18 * 4


def test_stated_operations_are_kept_and_none_are_added_beside_them() -> None:
    nail = Operation(
        id=OperationId("own"),
        process=Process.NAIL,
        on=(ComponentId("top"), ComponentId("stud-0")),
        fastener=FastenerSpec(type="nail", d_m=0.0031, l_m=0.09),
    )
    parts = [replace(c, operations=(nail,)) if c.id == "top" else c for c in panel()]
    model, _ = complete(model_of(parts, STUD_ENDS))
    between = [o for _, o in operations(model) if set(o.on) == {"top", "stud-0"}]
    assert between == [nail]


def test_what_a_rule_holds_is_hanging_not_floating() -> None:
    post = replace(upright("post", (0.0, 0.0, 1.2), (2.4, 0.1, 0.1)), type="post")
    arm = beam("arm", (0.3, 0.0, 2.0), (0.5, 0.1, 0.1), word="arm")
    loose, problems = complete(model_of([post, arm]))
    assert [(p.code, p.where) for p in problems] == [("F2", "arm")]
    screw: Mapping[str, Json] = {
        "id": "arms",
        "kind": "fasten",
        "through": "post",
        "into": "arm",
        "process": "screw",
        "fastener": {"type": "screw", "d_m": 0.006, "l_m": 0.16},
    }
    model, problems = complete(model_of([post, arm], screw))
    held = model.component_by_id[ComponentId("arm")]
    assert loose.component_by_id[ComponentId("arm")].construction_parents == ()
    assert [(p.code, p.where) for p in problems] == [("F1", "arm")]
    assert held.construction_parents == ("post",)
    assert held.hold_until_fasteners == 2
    assert [(r.a, r.b) for r in model.relations if r.kind is RelationKind.HOLD] == [("post", "arm")]
    assert not [p for p in check_model(model) if p.code == "F2"]


@pytest.mark.parametrize(
    ("rule", "words"),
    [
        ({"id": "a", "kind": "glue"}, "neither 'fasten' nor 'stock'"),
        ({**STUD_ENDS, "contact": "corner"}, "none of any"),
        ({**STUD_ENDS, "colour": "red"}, "unknown keys: colour"),
        ({**STUD_ENDS, "count": True}, "no number"),
        ({**STUD_ENDS, "fastener": {"type": "nail", "d_m": 0.003}}, "'l_m' is no length"),
        ({**STUD_ENDS, "edge_m": float("nan")}, "'edge_m' is no length"),
        ({"id": "b", "kind": "stock", "type": "*", "lengths_m": []}, "no list of lengths"),
        ({**STUD_ENDS, "id": ""}, "'id' is no text"),
    ],
)
def test_a_wrong_rule_is_named_with_what_is_wrong(rule: Mapping[str, Json], words: str) -> None:
    with pytest.raises(ModelRejectedError) as rejected:
        rules_from([rule, STUD_ENDS, {**STUD_ENDS, "count": 0}])
    problems = rejected.value.problems
    assert len(problems) == 2
    assert {p.code for p in problems} == {"K1"}
    assert words in problems[0].message


def test_a_frame_whose_file_lists_its_joints_gets_fasteners_too() -> None:
    rule = {**STUD_ENDS, "through": "*", "into": "*", "fastener": {**NAIL, "l_m": 0.16}}
    model, _ = complete(replace(portal(), rules=(rule,)))
    again, _ = complete(model)
    rail = model.component_by_id[ComponentId("rail")]
    assert again == model
    assert all(o.origin is Origin.RULE for o in rail.operations)
    assert rail.operations
    assert rail.hold_until_fasteners == 2
