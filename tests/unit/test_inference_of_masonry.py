"""Contacts, supports and order of real masonry files: the stored interfaces are matched exactly."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitewright.building_model.component import Component, ConvexGeometry, Layer
from sitewright.building_model.inference.bodies import bodies_of
from sitewright.building_model.inference.completion import complete
from sitewright.building_model.inference.interfaces import interfaces_of
from sitewright.building_model.model import BuildingModel, RelationKind
from sitewright.building_model.validation import check_model
from sitewright.foundation.ids import ComponentId

Pairs = set[tuple[str, str]]


def blocks(file: Path) -> tuple[BuildingModel, Pairs]:
    """Return the blocks of an assembly and the pairs of its stored interfaces."""
    graph = json.loads(file.read_text(encoding="utf-8"))["data"]["graph"]["data"]
    corners = {
        f"block-{k}": [(v["x"], v["y"], v["z"]) for v in n["block"]["data"]["vertex"].values()]
        for k, n in graph["node"].items()
    }
    ground = {f"block-{k}" for k, n in graph["node"].items() if n.get("is_support")}
    pairs = {
        tuple(sorted((f"block-{u}", f"block-{v}")))
        for u, others in graph["edge"].items()
        for v in others
    }
    return model_of(corners, ground), {(a, b) for a, b in pairs}


def groups(file: Path) -> BuildingModel:
    """Return the named groups of an OBJ file."""
    points: list[tuple[float, float, float]] = []
    corners: dict[str, list[tuple[float, float, float]]] = {}
    name = ""
    for line in file.read_text(encoding="utf-8").splitlines():
        match line.split():
            case ["o", *words]:
                name = "-".join(words)
                corners[name] = []
            case ["v", x, y, z]:
                points.append((float(x), float(y), float(z)))
            case ["f", *indices]:
                found = (points[int(i.split("/")[0]) - 1] for i in indices)
                corners[name] += [p for p in found if p not in corners[name]]
            case _:
                pass
    return model_of(corners, set())


def model_of(
    corners: dict[str, list[tuple[float, float, float]]], ground: set[str]
) -> BuildingModel:
    return BuildingModel(
        name="masonry",
        component_by_id={
            ComponentId(i): Component(
                id=ComponentId(i),
                layer=Layer.TARGET,
                type="block",
                geometry=ConvexGeometry(tuple(corners[i])),
                ground=i in ground,
            )
            for i in sorted(corners)
        },
    )


def found_pairs(model: BuildingModel) -> Pairs:
    bodies, problems = bodies_of(model)
    assert problems == []
    return {(i.a, i.b) for i in interfaces_of(bodies)}


@pytest.mark.parametrize(("file", "count"), [("wall_assembly", 80), ("arch_assembly", 29)])
def test_contacts_are_exactly_the_stored_interfaces(
    shared_data: Path, file: str, count: int
) -> None:
    model, stored = blocks(shared_data / "masonry" / f"{file}.json")
    assert len(stored) == count
    assert found_pairs(model) == stored


def test_the_blocks_of_an_obj_file_touch_in_60_pairs(shared_data: Path) -> None:
    model = groups(shared_data / "masonry" / "wall_simple.obj")
    assert len(model.component_by_id) == 38
    assert len(found_pairs(model)) == 60


def test_a_wall_stands_on_ten_blocks_and_is_built_from_below(shared_data: Path) -> None:
    given, _ = blocks(shared_data / "masonry" / "wall_assembly.json")
    model, problems = complete(given)
    supports = [r for r in model.relations if r.kind is RelationKind.SUPPORTS]
    components = model.component_by_id
    assert len(components) == 52
    assert sum(c.ground for c in components.values()) == 10
    assert len(supports) == 80
    assert max(c.order or 0 for c in components.values()) == 5
    assert all((components[r.a].order or 0) < (components[r.b].order or 0) for r in supports)
    assert problems == []
    assert not [p for p in check_model(model) if p.code in ("F1", "F2", "P2", "P4")]


def test_an_arch_without_falsework_has_an_order_but_20_stones_that_nothing_carries(
    shared_data: Path,
) -> None:
    given, _ = blocks(shared_data / "masonry" / "arch_assembly.json")
    model, problems = complete(given)
    supports = [r for r in model.relations if r.kind is RelationKind.SUPPORTS]
    assert len(supports) == 8
    assert [p.code for p in problems] == ["F2"] * 20
    assert [p.where for p in check_model(model) if p.code == "F2"] == sorted(
        p.where for p in problems
    )
    assert all(c.order is not None and "insertion" in c.ext for c in model.component_by_id.values())
