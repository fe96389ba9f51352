"""Piles: where the pieces of a stack lie, and pieces made from a count."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sitewright.building_model.component import Component
from sitewright.building_model.model import Stack
from sitewright.building_model.shapes import size_of
from sitewright.foundation.ids import ComponentId, StackId
from sitewright.foundation.pose import Pose, Vector, dot, rotation, translation

_LENGTH: Vector = (1.0, 0.0, 0.0)
_HALF = 0.5
_UPRIGHT = 0.7


def generated_pieces(stack: StackId, like: Component, count: int) -> list[Component]:
    """Return `count` equal pieces ``<stack>.1`` (the lowest) and so on, read as ``<stack> 1``."""
    numbers = range(1, count + 1)
    return [replace(like, id=ComponentId(f"{stack}.{n}"), name=f"{stack} {n}") for n in numbers]


def piled(
    stack: Stack, pieces: Sequence[Component], turns: Sequence[Pose] | None = None
) -> list[Component]:
    """Return the pieces, bottom first, each lying on the one below in the stock place's frame.

    Args:
        stack: Where the pile stands.
        pieces: Their poses do not matter.
        turns: How each lies, turned about its length; by default its own z axis is up.
    """
    result, height_m = [], 0.0
    for piece, turn in zip(pieces, turns or [Pose()] * len(pieces), strict=True):
        thickness_m = lying_section_m(piece, turn)[1]
        centre = translation(0.0, 0.0, height_m + thickness_m / 2.0)
        result.append(replace(piece, world_T_component=stack.stock_T_stack @ centre @ turn))
        height_m += thickness_m + stack.spacer_m
    return result


def lying_section_m(piece: Component, turn: Pose) -> tuple[float, float]:
    """Return width and thickness of a piece that lies turned by right angles about its length."""
    _, width_m, thickness_m = size_of(piece)
    is_on_edge = abs(turn.z_axis[2]) < _HALF
    return (thickness_m, width_m) if is_on_edge else (width_m, thickness_m)


def turn_as_placed(target: Component, up: Vector) -> Pose:
    """Return how the piece for a target lies: the face up that is up once it is placed.

    So a gripper that takes it from above comes from above when it places it, too. What is placed
    upright has no such face; it lies on its own z axis.

    Args:
        target: A component at its place in the model.
        up: Unit vector against gravity, in the model frame.
    """
    pose = target.world_T_component
    if abs(dot(pose.x_axis, up)) > _UPRIGHT:
        return Pose()
    across, above = dot(pose.y_axis, up), dot(pose.z_axis, up)
    if abs(above) >= abs(across):
        return Pose() if above > 0.0 else rotation(_LENGTH, math.pi)
    return rotation(_LENGTH, math.copysign(math.pi / 2.0, across))
