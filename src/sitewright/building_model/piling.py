"""Piles: where the pieces of a stack lie, and pieces made from a count."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sitewright.building_model.component import Component
from sitewright.building_model.model import Stack
from sitewright.building_model.shapes import size_of
from sitewright.foundation.ids import ComponentId, StackId
from sitewright.foundation.pose import translation


def generated_pieces(stack: StackId, like: Component, count: int) -> list[Component]:
    """Return `count` equal pieces named ``<stack>.1`` (the lowest) and so on."""
    return [replace(like, id=ComponentId(f"{stack}.{n}")) for n in range(1, count + 1)]


def piled(stack: Stack, pieces: Sequence[Component]) -> list[Component]:
    """Return the pieces, bottom first, each lying on the one below in the stock place's frame."""
    result, height_m = [], 0.0
    for piece in pieces:
        thickness_m = size_of(piece)[2]
        centre = translation(0.0, 0.0, height_m + thickness_m / 2.0)
        result.append(replace(piece, world_T_component=stack.stock_T_stack @ centre))
        height_m += thickness_m + stack.spacer_m
    return result
