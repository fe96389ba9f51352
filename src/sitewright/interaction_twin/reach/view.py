"""From metres to pixels: plan above, elevation below it, both to one scale."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from sitewright.foundation.pose import Vector
from sitewright.interaction_twin.reach.outline import Outline, Point

PAD_M = 0.25


@dataclass(frozen=True, slots=True)
class Frame:
    """A rectangle of the picture that shows a rectangle of the cell.

    Attributes:
        left_px, top_px: Its upper left corner.
        low_m, high_m: What it shows.
        px_per_m: Scale.
    """

    left_px: float
    top_px: float
    low_m: Point
    high_m: Point
    px_per_m: float

    @property
    def width_px(self) -> float:
        """Width in the picture."""
        return (self.high_m[0] - self.low_m[0]) * self.px_per_m

    @property
    def height_px(self) -> float:
        """Height in the picture."""
        return (self.high_m[1] - self.low_m[1]) * self.px_per_m

    def at(self, point: Point) -> Point:
        """Return where a point of the cell is in the picture."""
        x = self.left_px + (point[0] - self.low_m[0]) * self.px_per_m
        y = self.top_px + (self.high_m[1] - point[1]) * self.px_per_m
        return x, y

    def path(self, polygon: Sequence[Point]) -> str:
        """Return the path of a polygon."""
        corners = [self.at(p) for p in polygon]
        return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in corners) + "Z"

    def grid_m(self) -> tuple[list[int], list[int]]:
        """Return the whole metres that it shows, along both axes."""
        return tuple(  # type: ignore[return-value]
            list(range(math.ceil(self.low_m[k]), math.floor(self.high_m[k]) + 1)) for k in range(2)
        )


def extent(outlines: Iterable[Outline]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the box around all outlines, with some room."""
    rows = list(outlines)
    low = tuple(min(o.low_m[k] for o in rows) - PAD_M for k in range(3))
    high = tuple(max(o.high_m[k] for o in rows) + PAD_M for k in range(3))
    return low, high


class Side(StrEnum):
    """Where the cell is looked at from."""

    PLAN = "plan"
    ELEVATION = "elevation"

    def point(self, at_m: Vector) -> Point:
        """Return a point of the cell in this view."""
        return (at_m[0], at_m[1] if self is Side.PLAN else at_m[2])

    def polygons(self, outline: Outline) -> tuple[tuple[Point, ...], ...]:
        """Return the outline in this view."""
        return outline.plan if self is Side.PLAN else outline.elevation

    def depth(self, outline: Outline) -> float:
        """Return what orders bodies: those in front come last."""
        return outline.high_m[2] if self is Side.PLAN else -outline.low_m[1]
