"""What stands still in the cell, in arrays, with the time that each body is there."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sitewright.foundation.ids import EndEffectorId
from sitewright.planning_twin.backends.convex_part import CompiledPart, compiled
from sitewright.planning_twin.backends.kinematic_chain import Array, matrix_of
from sitewright.planning_twin.backends.pair_table import Indices
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.reachability.question import TimedBody


@dataclass(frozen=True, slots=True, eq=False)
class Surroundings:
    """Convex parts that stand still.

    Attributes:
        names: Body of each part.
        frames: n x 4 x 4, world_T_part.
        half_m: n x 3, half edges of the enclosing boxes.
        radius_m: Of the enclosing balls.
        low_m, high_m: n x 3, the boxes along the world's axes.
        appears, vanishes: As in `TimedBody`.
        docked: End effector that a part belongs to; empty if none.
    """

    parts: tuple[CompiledPart, ...]
    names: tuple[str, ...]
    frames: Array
    half_m: Array
    radius_m: Array
    low_m: Array
    high_m: Array
    appears: Indices
    vanishes: Indices
    docked: tuple[str, ...]
    rows_of: Mapping[str, Indices]

    def at(self, number: int) -> Flags:
        """Return which parts are there while a target is placed, docks aside."""
        return np.asarray((self.appears <= number) & (number < self.vanishes))

    def lying(self, tools: Collection[EndEffectorId]) -> Flags:
        """Return which parts are there if just these end effectors lie in their docks."""
        return np.array([not d or d in tools for d in self.docked], dtype=np.bool_)

    def rows(self, body: str) -> Indices:
        """Return the parts of a body; none of one that is not known."""
        return self.rows_of.get(body, np.zeros(0, dtype=np.intp))


def surroundings(bodies: Sequence[TimedBody]) -> Surroundings:
    """Compile bodies that stand still."""
    rows = [
        (body, part, matrix_of(body.world_T_body) @ part.body_T_part)
        for body in bodies
        for part in map(compiled, body.shape)
    ]
    return placed_parts(
        [(body.id, part, frame) for body, part, frame in rows],
        appears=np.array([b.appears for b, _, _ in rows], dtype=np.intp),
        vanishes=np.array([b.vanishes for b, _, _ in rows], dtype=np.intp),
        docked=tuple(b.docked or "" for b, _, _ in rows),
    )


def placed_parts(
    rows: Sequence[tuple[str, CompiledPart, Array]],
    *,
    appears: Indices,
    vanishes: Indices,
    docked: tuple[str, ...],
) -> Surroundings:
    """Return parts with names and world poses as surroundings."""
    frames = np.array([frame for _, _, frame in rows]).reshape(-1, 4, 4)
    half_m = np.array([part.half_m for _, part, _ in rows]).reshape(-1, 3)
    spread_m = spreads(frames, half_m)
    rows_of: dict[str, list[int]] = defaultdict(list)
    for k, (name, _, _) in enumerate(rows):
        rows_of[name].append(k)
    return Surroundings(
        parts=tuple(part for _, part, _ in rows),
        names=tuple(name for name, _, _ in rows),
        frames=frames,
        half_m=half_m,
        radius_m=np.array([part.radius_m for _, part, _ in rows]),
        low_m=frames[:, :3, 3] - spread_m,
        high_m=frames[:, :3, 3] + spread_m,
        appears=appears,
        vanishes=vanishes,
        docked=docked,
        rows_of={name: np.array(k, dtype=np.intp) for name, k in rows_of.items()},
    )


def spreads(frames: Array, half_m: Array) -> Array:
    """Return half the edges of the boxes along the world's axes around turned boxes."""
    return np.asarray(np.einsum("...ij,...j->...i", np.abs(frames[..., :3, :3]), half_m))
