"""The cell that an import adds: two arms on pedestals, what is to be built between them."""

from __future__ import annotations

import math
from pathlib import Path

import tomlkit

from sitewright.building_model.laying import extents_as_laid
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import Extent

_ALONG_Y = math.sqrt(0.5)


def two_arm_cell(model: BuildingModel, example: Path) -> str:
    """Return the text of a cell file in which a model stands on the floor, long side along x.

    Args:
        model: What is to be built; if no shape of it is known, it stays where the example has it.
        example: Cell file of the house frame, laid out for a building in the middle.
    """
    text = example.read_text(encoding="utf-8")
    extents = extents_as_laid(model)
    if not extents:
        return text
    document = tomlkit.parse(text)
    document["site"]["world_T_model"] = _placed(_around(extents))
    return tomlkit.dumps(document)


def _around(extents: list[Extent]) -> Extent:
    low, high = (
        tuple(best(values) for values in zip(*corners, strict=True))
        for best, corners in (
            (min, [e.low_m for e in extents]),
            (max, [e.high_m for e in extents]),
        )
    )
    return Extent(low_m=(low[0], low[1], low[2]), high_m=(high[0], high[1], high[2]))


def _placed(extent: Extent) -> tomlkit.items.InlineTable:
    """Return the pose that brings the middle of the underside to the origin of the world."""
    x, y = ((extent.low_m[k] + extent.high_m[k]) / 2.0 for k in (0, 1))
    is_along_y = extent.size_m[1] > extent.size_m[0]
    at = (y, -x) if is_along_y else (-x, -y)
    table = tomlkit.inline_table()
    table["p_m"] = [round(v, 6) + 0.0 for v in (*at, -extent.low_m[2])]
    if is_along_y:
        table["q_wxyz"] = [_ALONG_Y, 0.0, 0.0, _ALONG_Y]
    return table
