"""The wooden frame with the stock of one target lying where another one belongs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from builders_planning import EXAMPLES

_ACROSS = [0.7071067812, 0, 0, 0.7071067812]


def plank_in_the_way(folder: Path, *, is_after: bool = False, has_buffer: bool = True) -> Path:
    """Write a project of a support and a plank; the plank's only piece lies in the support's place.

    Args:
        folder: Where to.
        is_after: The design wants the plank after the support.
        has_buffer: There is a place to lay things aside.
    """
    folder.mkdir(parents=True)
    source = EXAMPLES / "wooden_frame"
    (folder / "cell.toml").write_text(_cell((source / "cell.toml").read_text(), has_buffer))
    frame = json.loads((source / "building.json").read_text())
    (folder / "building.json").write_text(json.dumps(_building(frame, is_after)))
    return folder


def _building(frame: dict[str, Any], is_after: bool) -> dict[str, Any]:  # noqa: FBT001
    known = {c["id"]: c for c in frame["components"]}
    support, stud = known["support-1"], known["stud-1"]
    plank = {
        "id": "plank",
        "name": "Plank",
        "layer": "target",
        "type": stud["type"],
        "material": stud["material"],
        "order": 2,
        "ground": True,
        "geometry": stud["geometry"],
        "world_T_component": {"p_m": [0.3, 0.0, 0.02], "q_wxyz": _ACROSS},
    }
    for stack in frame["stacks"]:
        stack["generated"]["count"] = 1
    before = [{"kind": "before", "a": "support-1", "b": "plank"}] if is_after else []
    return {**frame, "components": [support, plank], "relations": before}


def _cell(text: str, has_buffer: bool) -> str:  # noqa: FBT001
    there = "world_T_stock = { p_m = [-1.6, -1.55, 0.30] }"
    here = f"world_T_stock = {{ p_m = [-0.6, 0.0, 0.40], q_wxyz = {_ACROSS} }}"
    assert there in text
    text = text.replace(there, here)
    if has_buffer:
        return text
    tables = text.split("\n[[")
    return "\n[[".join(t for t in tables if 'kind = "buffer"' not in t)
