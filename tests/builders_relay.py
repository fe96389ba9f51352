"""Cells of one beam: its stock lies far from where it belongs, with a buffer between."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from builders_planning import EXAMPLES

_CELL = """schema = "sitewright.cell/1"
name = "A beam is passed on"

[site]
world_T_model = {{ p_m = [{target_x}, 0.0, 0.40] }}
clearance_m = 0.010
"""
_FIXTURE = """
[[fixture]]
id = "{id}"
geometry = {{ box = {{ size_m = {size_m} }} }}
world_T_fixture = {{ p_m = {p_m} }}
"""
_ROBOT = """
[[robot]]
id = "arm-{name}"
model = "kuka-kr120-r2500-pro"
subtype = "handler"
world_T_base = {{ p_m = [{x}, {y}, 0.0] }}
home_q_deg = [90, -110, 110, 0, 80, 0]
parking_q_deg = [[-90, -110, 110, 0, 80, 0]]
max_acceleration_deg_s2 = [312, 312, 312, 660, 660, 1230]
end_effectors = ["gripper-{name}"]
mounted = "gripper-{name}"

[[end_effector]]
id = "gripper-{name}"
kind = "gripper"
urdf = "builtin:parallel-gripper"
grips_m = [0.030, 0.140]
opens_to_m = 0.170
"""
_PLACES = """
[[stock_place]]
id = "pallet-thick"
world_T_stock = {{ p_m = [{stock_x}, 0.0, 0.30]{turn} }}
"""
_BUFFER = """
[[station]]
id = "{id}"
kind = "buffer"
world_T_station = {{ p_m = [{x}, {y}, 0.30]{turn} }}
"""
_ACROSS = ", q_wxyz = [0.7071067812, 0, 0, 0.7071067812]"


def fixture_text(name: str, size_m: list[float], p_m: list[float]) -> str:
    """Return a box that stands in the cell, as ``cell.toml`` has it."""
    return _FIXTURE.format(id=name, size_m=size_m, p_m=p_m)


@dataclass(frozen=True, kw_only=True)
class Relay:
    """Where things stand.

    Attributes:
        arms: Name and base of each robot.
        buffers: Where it may be laid down between; the first is called ``between``, others
            ``between-2`` and so on.
        is_across: The beam lies along y, else along x, everywhere.
    """

    arms: tuple[tuple[str, float, float], ...]
    stock_x: float
    target_x: float
    buffers: tuple[tuple[float, float], ...]
    is_across: bool

    def write(self, folder: Path) -> Path:
        """Write the project into a folder and return it."""
        folder.mkdir(parents=True)
        (folder / "cell.toml").write_text(self._cell(), encoding="utf-8")
        (folder / "building.json").write_text(json.dumps(self._building()), encoding="utf-8")
        return folder

    def _building(self) -> dict[str, object]:
        frame = json.loads((EXAMPLES / "wooden_frame" / "building.json").read_text())
        (beam,) = (c for c in frame["components"] if c["id"] == "support-1")
        beam["world_T_component"]["p_m"] = [0.0, 0.0, 0.07]
        if not self.is_across:
            beam["world_T_component"]["q_wxyz"] = [1, 0, 0, 0]
        stacks = [s for s in frame["stacks"] if s["id"] == "thick"]
        return {**frame, "components": [beam], "stacks": stacks}

    def _cell(self) -> str:
        turn = _ACROSS if self.is_across else ""
        stand = [0.30, 2.50, 0.32] if self.is_across else [2.50, 0.30, 0.32]
        table = [*stand[:2], 0.42]
        fixtures = {
            "floor": ([16.0, 9.0, 0.10], [0.0, 0.0, -0.07]),
            "table": (table, [self.target_x, 0.0, 0.19]),
            "stock-stand": (stand, [self.stock_x, 0.0, 0.14]),
        }
        named = [(_number("between", k), x, y) for k, (x, y) in enumerate(self.buffers, start=1)]
        fixtures |= {f"stand-{name}": (stand, [x, y, 0.14]) for name, x, y in named}
        return "".join(
            (
                _CELL.format(target_x=self.target_x),
                *(fixture_text(i, s, p) for i, (s, p) in fixtures.items()),
                *(_ROBOT.format(name=name, x=bx, y=by) for name, bx, by in self.arms),
                *(_BUFFER.format(id=name, x=x, y=y, turn=turn) for name, x, y in named),
                _PLACES.format(stock_x=self.stock_x, turn=turn),
            )
        )


def _number(name: str, number: int) -> str:
    return name if number == 1 else f"{name}-{number}"


HAND_OVER = Relay(
    arms=(("a", -2.1, 0.0), ("b", 1.8, 0.0)),
    stock_x=-3.9,
    target_x=3.4,
    buffers=((0.0, 0.0),),
    is_across=True,
)
"""Only arm a reaches the stock, only arm b the target, both the buffer."""
REGRASP = Relay(
    arms=(("a", 0.0, 0.0),), stock_x=-2.75, target_x=2.75, buffers=((0.0, 1.7),), is_across=False
)
"""One arm reaches the beam in stock at one end only, and has to hold the other at the target."""
CHAIN = Relay(
    arms=(("a", -2.1, 0.0), ("c", 1.8, 0.0), ("b", 5.4, 0.0)),
    stock_x=-3.9,
    target_x=7.0,
    buffers=((0.0, 0.0), (3.6, 0.0)),
    is_across=True,
)
"""Arm a reaches the stock and one buffer, arm c both buffers, arm b the other and the target."""
