"""A piece of material as a physical body."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape


@dataclass(frozen=True, slots=True, kw_only=True)
class Piece:
    """A piece that lies on the site when the cell starts.

    Attributes:
        shape: Convex pieces in the component frame.
        world_T_piece: Where it lies at the very start; a cell that remembers more ignores it.
    """

    id: ComponentId
    shape: Shape
    world_T_piece: Pose
    mass_kg: float
