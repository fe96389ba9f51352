"""The script for inside Rhino: its steps, on a stand-in for Rhino's scripting functions."""

from __future__ import annotations

import json
import runpy
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from sitewright.building_model.component import Layer
from sitewright.building_model.formats.layer_rules import LayerNames
from sitewright.building_model.formats.rhino_patch import new_path

SCRIPT = runpy.run_path(str(Path(__file__).parents[2] / "docs" / "rhino" / "apply_status.py"))
BUILT: dict[str, Any] = {
    "changed": True,
    "layer": "as_built",
    "moves_to": "As-Built",
    "keys": {"status": "verified", "robot": "kr120-a"},
}
USED: dict[str, Any] = {
    "changed": True,
    "layer": "as_designed",
    "moves_to": "Consumed",
    "keys": {"status": "consumed", "used_for": "A"},
}
PLANNED: dict[str, Any] = {
    "changed": False,
    "layer": "target",
    "moves_to": "",
    "keys": {"status": "planned"},
}
PATHS = (
    ("", "As-Built", "As-Built"),
    ("Studs", "As-Built", "As-Built::Studs"),
    ("Target", "As-Built", "As-Built"),
    ("Frame::TARGETS::Studs", "As-Built", "Frame::As-Built::Studs"),
    ("target [x]::Target[y]::Studs", "As-Built", "target [x]::As-Built::Studs"),
    ("as built::Studs", "As-Built", "as built::Studs"),
    ("Storey 1[IfcStorey]::IfcWall", "As-Built", "As-Built::Storey 1[IfcStorey]::IfcWall"),
    ("Yard::Material::Studs", "Consumed", "Yard::Consumed::Studs"),
    ("As Designed::Studs", "Consumed", "Consumed::Studs"),
    ("consumed::Studs", "Consumed", "Consumed::Studs"),
)


@pytest.mark.parametrize(("path", "label", "wanted"), PATHS)
def test_the_role_layer_is_exchanged_and_the_others_stay(
    path: str, label: str, wanted: str
) -> None:
    assert new_path(path, label, LayerNames()) == wanted
    assert SCRIPT["new_path"](path, label) == wanted


def test_layers_of_the_users_own_are_known_by_the_map() -> None:
    names = LayerNames(role_by_name={"zubauen": Layer.TARGET})
    assert new_path("Zu bauen::Stiele", "As-Built", names) == "As-Built::Stiele"


class FakeRhino:
    """Keeps what the script asks of ``rhinoscriptsyntax``; Rhino itself is not here."""

    def __init__(self, layer_by_id: Mapping[str, str], text: dict[tuple[str, str], str]) -> None:
        self.layer_by_id, self.text = dict(layer_by_id), text
        self.visible = {
            "::".join(p.split("::")[: n + 1]): True
            for p in layer_by_id.values()
            for n in range(len(p.split("::")))
        }

    def IsObject(self, identity: str) -> bool:
        return identity in self.layer_by_id

    def SetUserText(self, identity: str, key: str, value: str) -> None:
        self.text[identity, key] = value

    def GetUserText(self, identity: str, key: str) -> str | None:
        return self.text.get((identity, key))

    def ObjectLayer(self, identity: str, layer: str | None = None) -> str:
        if layer is not None:
            assert layer in self.visible
            self.layer_by_id[identity] = layer
        return self.layer_by_id[identity]

    def IsLayer(self, layer: str) -> bool:
        return layer in self.visible

    def LayerColor(self, layer: str) -> str:
        assert layer in self.visible
        return "red"

    def LayerVisible(self, layer: str, visible: bool) -> None:  # noqa: FBT001 - Rhino's own
        assert layer in self.visible
        self.visible[layer] = visible

    def AddLayer(self, layer: str, color: str) -> None:
        assert color == "red"
        names = layer.split("::")
        for n in range(len(names)):
            self.visible.setdefault("::".join(names[: n + 1]), True)


def applied(rhino: FakeRhino, **status: Any) -> tuple[list[str], list[str]]:
    told = json.loads(json.dumps(status))
    written, missing = SCRIPT["apply_status"](rhino, told)
    return written, missing


def test_what_was_built_gets_its_status_and_layer_and_what_was_not_is_left_alone() -> None:
    rhino = FakeRhino({"A": "Target::Studs", "B": "Target::Studs"}, {})
    assert applied(rhino, A=BUILT, B=PLANNED, gone=BUILT) == (["A"], ["gone"])
    assert rhino.layer_by_id == {"A": "As-Built::Studs", "B": "Target::Studs"}
    assert rhino.text == {
        ("A", "sitewright.status"): "verified",
        ("A", "sitewright.robot"): "kr120-a",
    }
    assert all(rhino.visible.values())


def test_used_stock_goes_to_a_layer_that_is_switched_off_once() -> None:
    rhino = FakeRhino({"P": "Material::Studs", "Q": "Material::Beams"}, {})
    applied(rhino, P=USED)
    assert rhino.layer_by_id["P"] == "Consumed::Studs"
    assert {p for p, is_on in rhino.visible.items() if not is_on} == {"Consumed"}
    rhino.visible["Consumed"] = True  # the user looks at it
    applied(rhino, P=USED, Q=USED)
    assert rhino.layer_by_id["Q"] == "Consumed::Beams"
    assert all(rhino.visible.values())


def test_a_layer_that_is_stated_as_a_key_is_changed_too() -> None:
    rhino = FakeRhino({"A": "Studs"}, {("A", "sitewright.layer"): "target"})
    applied(rhino, A=BUILT)
    assert rhino.text["A", "sitewright.layer"] == "as_built"


def test_a_partly_built_object_stays_on_its_layer() -> None:
    rhino = FakeRhino({"A": "Target::Studs"}, {})
    applied(rhino, A={**BUILT, "layer": "", "moves_to": "", "keys": {"status": "partly"}})
    assert rhino.layer_by_id["A"] == "Target::Studs"
    assert rhino.text == {("A", "sitewright.status"): "partly"}
