"""The cell for a panel built lying: a framing table of its size between two arms on tracks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.resources import files
from itertools import product
from string import Template

from sitewright.building_model.laying import extents_as_laid, size_as_laid_m
from sitewright.building_model.model import BuildingModel

TABLE_TOP_M = 0.60
PLATES_M = 0.12
"""The table ends so far before the panel, if there is room for tongues: plates lie on them."""
FLUSH_M = 0.005
"""The tongues end so far before the panel."""
NOSE_M = 0.060
"""Between a stud's side and the tongue beside it: room for the nose of the nail gun."""
_WIDEST_M = 0.30
_NARROWEST_M = 0.05
_PLATE_M = 0.10
_ASIDE_M = (0.75, 1.05)
"""From the panel's side to the middle of the track: at least, and if the arm reaches as far."""
_ACROSS_M = 2.35
"""So far from its track an arm places a stud and drives its nails."""
_BEYOND_M = 0.55
"""So far beyond the panel's ends the tracks reach."""
_TO_STOCK_M = 1.60
_TONGUE = """
[[fixture]]
id = "tongue-{number}"
geometry = {{ box = {{ size_m = [{width}, {length}, {thickness}] }} }}
world_T_fixture = {{ p_m = [{x}, {y}, {z}] }}
"""


def framing_cell(panel: BuildingModel) -> str:
    """Return the text of a cell file for a panel that is laid flat."""
    width_m, height_m, _ = size_as_laid_m(panel)
    bays = list(_bays(panel))
    table_x = max(width_m + 0.10, 0.90)
    table_y = height_m - 2 * (PLATES_M if bays else FLUSH_M)
    near_m, far_m = _ASIDE_M
    base_x = width_m / 2.0 + min(far_m, max(near_m, _ACROSS_M - width_m))
    travel = height_m / 2.0 + _BEYOND_M
    longest = max(width_m, height_m)
    stock_x, stock_y = base_x + _TO_STOCK_M, longest / 2.0 + 0.10
    foot_z = TABLE_TOP_M - _PLATE_M
    numbers = {
        "table_top": TABLE_TOP_M,
        "table_x": table_x,
        "table_y": table_y,
        "table_at_z": TABLE_TOP_M - _PLATE_M / 2.0,
        "foot_x": table_x - 0.40,
        "foot_y": table_y - 0.40,
        "foot_z": foot_z,
        "foot_at_z": foot_z / 2.0,
        "base_x": base_x,
        "travel": travel,
        "bed_y": 2 * travel + 1.40,
        "bearers_y": longest + 0.10,
        "stock_x": stock_x,
        "stock_y": stock_y,
        "floor_x": base_x + 1.50 + stock_x + 1.00,
        "floor_at_x": (base_x + 1.50 - stock_x - 1.00) / 2.0,
        "floor_y": 2 * (travel + 2.00),
    }
    words = {name: _text(value) for name, value in numbers.items()}
    text = (files("sitewright") / "app" / "cells" / "framing_table.toml").read_text("utf-8")
    return Template(text).substitute(
        words,
        panel=f"{width_m:.3f} x {height_m:.3f} m",
        tongues="".join(_tongues(bays, height_m)),
    )


def _text(length_m: float) -> str:
    """Return a length to the micrometre."""
    return f"{round(length_m, 6) + 0.0:.10g}"


def _tongues(bays: Sequence[tuple[float, float]], height_m: float) -> Iterator[str]:
    length_m = PLATES_M - FLUSH_M
    for number, ((low, high), side) in enumerate(product(bays, (-1.0, 1.0)), start=1):
        yield _TONGUE.format(
            number=number,
            width=_text(min(high - low - 2 * NOSE_M, _WIDEST_M)),
            length=_text(length_m),
            thickness=_text(_PLATE_M),
            x=_text((low + high) / 2.0),
            y=_text(side * (height_m / 2.0 - FLUSH_M - length_m / 2.0)),
            z=_text(TABLE_TOP_M - _PLATE_M / 2.0),
        )


def _bays(panel: BuildingModel) -> Iterator[tuple[float, float]]:
    """Yield the gaps along x between studs in which a tongue has room.

    A stud is what reaches further along y than along x.
    """
    spans = sorted(
        (e.low_m[0], e.high_m[0]) for e in extents_as_laid(panel) if e.size_m[1] > e.size_m[0]
    )
    end = spans[0][1] if spans else 0.0
    for low, high in spans[1:]:
        if low - end - 2 * NOSE_M > _NARROWEST_M:
            yield end, low
        end = max(end, high)
