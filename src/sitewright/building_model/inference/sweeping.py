"""What is in the way when one body moves straight out of an assembly: exact for convex pieces.

Two convex pieces overlap when no axis separates them, and a straight move shifts the gap along
each axis evenly. So the part of a move in which two pieces overlap is an interval, and it is
known without taking samples.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from sitewright.building_model.inference.bodies import Body, Part, Points

TOLERANCE_M = 0.0005
"""Pieces may graze each other this deep while they slide; neighbours in models touch."""
_BUDGET = 3_000_000
_STILL = 1e-9
_TINY_M = 1e-6
_PARALLEL = 1e-7
_SIZES = ((8, 3, 3), (16, 8, 10), (48, 24, 20))
"""Corners, face lines and edge directions that a piece is padded to. Of the largest pieces some
edge directions are left out: then a way may look blocked that is narrowly free."""

Pairs = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Overlap:
    """When bodies overlap as the first of a pair moves.

    Attributes:
        pairs: Indices of bodies, first < second, one pair of pieces per row.
        enters_m: By row and direction: travel at which they begin to overlap.
        leaves_m: Travel at which they no longer do; not above `enters_m` if they never do.
    """

    pairs: Pairs
    enters_m: Points
    leaves_m: Points


@dataclass(frozen=True, eq=False)
class _Padded:
    """Pieces of one size class as arrays.

    Attributes:
        row: Row of a piece, by its index among all pieces.
    """

    row: Pairs
    corners: Points
    lines: Points
    edges: Points

    def of(self, pieces: Pairs) -> _Padded:
        """Return some of the pieces, each perhaps several times."""
        row = self.row[pieces]
        return _Padded(np.arange(len(row)), self.corners[row], self.lines[row], self.edges[row])


def overlaps(
    bodies: Sequence[Body],
    directions: Points,
    *,
    grown_m: float = 0.0,
    movers: int | None = None,
) -> list[Overlap]:
    """Return the overlaps of all pairs that can meet at all when the first moves.

    Args:
        bodies: Bodies in the model frame.
        directions: Unit vectors, one per row.
        grown_m: Count pieces as overlapping that are nearer than this. With 0, pieces that
            overlap in the model already may go on to, but no deeper.
        movers: Only so many bodies, the first ones, move; by default every one does.
    """
    pieces = [(k, part) for k, body in enumerate(bodies) for part in body.parts]
    owners = np.array([k for k, _ in pieces], dtype=np.int64)
    parts = [part for _, part in pieces]
    classes = np.array([_class_of(p) for p in parts], dtype=np.int64)
    found = []
    padded = {k: _padded(parts, classes == k, k) for k in {int(k) for k in classes}}
    last = len(parts) if movers is None else int(np.searchsorted(owners, movers))
    for pairs, meet in _corridors(parts, owners, last, directions, grown_m):
        kinds = classes[pairs]
        for one, other in product(sorted(padded), repeat=2):
            rows = np.flatnonzero((kinds[:, 0] == one) & (kinds[:, 1] == other))
            for chunk in _chunks(rows, one, other, len(directions)):
                first = padded[one].of(pairs[chunk, 0])
                second = padded[other].of(pairs[chunk, 1])
                enters, leaves = _intervals(first, second, directions, meet[chunk], grown_m)
                found.append(Overlap(owners[pairs[chunk]], enters, leaves))
    return found


def _corridors(
    parts: Sequence[Part], owners: Pairs, last: int, directions: Points, grown_m: float
) -> Iterator[tuple[Pairs, Flags]]:
    """Yield pairs of pieces whose surrounding boxes meet in some direction, by first piece.

    With each pair go the directions in which they do.
    """
    low = np.array([p.corners_m.min(axis=0) for p in parts])
    high = np.array([p.corners_m.max(axis=0) for p in parts])
    middle, half = (low + high) / 2.0, (high - low) / 2.0
    kept: list[Pairs] = []
    ways: list[Flags] = []
    for i in range(min(last, len(parts) - 1)):
        others = np.flatnonzero(owners[i + 1 :] != owners[i]) + i + 1
        gaps = middle[others] - middle[i]
        reach = half[others] + half[i] + grown_m
        enters, leaves = _meeting(gaps[:, :, None], reach[:, :, None], directions.T[None])
        meet = enters < leaves - _TINY_M
        met = np.flatnonzero(meet.any(axis=1))
        kept.append(np.column_stack([np.full(len(met), i), others[met]]).astype(np.int64))
        ways.append(meet[met])
        if sum(map(len, kept)) > _BUDGET // 1000:
            yield np.vstack(kept), np.vstack(ways)
            kept, ways = [], []
    if kept:
        yield np.vstack(kept), np.vstack(ways)


def _intervals(
    first: _Padded, second: _Padded, directions: Points, meet: Flags, grown_m: float
) -> tuple[Points, Points]:
    """Return by pair and direction when they overlap; looked at only where their boxes meet."""
    axes = _axes(first, second)
    a_low, a_high = _shadow(first.corners, axes)
    b_low, b_high = _shadow(second.corners, axes)
    gaps = (b_high + b_low - a_high - a_low) / 2.0
    reach = (b_high - b_low + a_high - a_low) / 2.0
    if grown_m > 0.0:
        reach = reach + grown_m
    else:
        depth = np.maximum(0.0, (reach - np.abs(gaps)).min(axis=1))
        depth[depth <= TOLERANCE_M] = 0.0
        reach = reach - TOLERANCE_M - depth[:, None]
    enters, leaves = np.full(meet.shape, np.inf), np.full(meet.shape, -np.inf)
    pair, way = np.nonzero(meet)
    rates = np.einsum("nki,ni->nk", axes[pair], directions[way])
    enters[pair, way], leaves[pair, way] = _meeting(gaps[pair], reach[pair], rates)
    return enters, leaves


def _shadow(corners: Points, axes: Points) -> tuple[Points, Points]:
    """Return where each piece begins and ends along each of its axes."""
    along = axes @ corners.transpose(0, 2, 1)
    return along.min(axis=2), along.max(axis=2)


def _meeting(gaps: Points, reach: Points, rates: Points) -> tuple[Points, Points]:
    """Return when ``|gap - t rate| < reach`` begins and ends to hold along all axes (axis 1)."""
    moves = np.abs(rates) > _STILL
    safe = np.where(moves, rates, 1.0)
    one, other = (gaps - reach) / safe, (gaps + reach) / safe
    inside = np.abs(gaps) < reach
    enters = np.where(moves, np.minimum(one, other), np.where(inside, -np.inf, np.inf))
    leaves = np.where(moves, np.maximum(one, other), np.where(inside, np.inf, -np.inf))
    never = np.broadcast_to(reach <= 0.0, enters.shape)
    enters = np.where(never, np.inf, enters).max(axis=1)
    leaves = np.where(never, -np.inf, leaves).min(axis=1)
    past = leaves <= _TINY_M
    return np.where(past, np.inf, enters), np.where(past, -np.inf, leaves)


def _axes(first: _Padded, second: _Padded) -> Points:
    crossed = np.cross(first.edges[:, :, None, :], second.edges[:, None, :, :])
    crossed = crossed.reshape(len(crossed), -1, 3)
    sizes = np.linalg.norm(crossed, axis=2, keepdims=True)
    plain = np.broadcast_to(first.lines[:, :1, :], crossed.shape)
    crossed = np.where(sizes > _PARALLEL, crossed / np.maximum(sizes, _PARALLEL), plain)
    return np.concatenate([first.lines, second.lines, crossed], axis=1)


def _class_of(part: Part) -> int:
    counts = (len(part.corners_m), len(part.lines), len(part.edges))
    for k, sizes in enumerate(_SIZES[:-1]):
        if all(n <= most for n, most in zip(counts, sizes, strict=True)):
            return k
    return len(_SIZES) - 1


def _padded(parts: Sequence[Part], chosen: Flags, size: int) -> _Padded:
    corners, lines, edges = _SIZES[size]
    these = [part for part, is_chosen in zip(parts, chosen, strict=True) if is_chosen]
    if size == len(_SIZES) - 1:
        corners = max(len(p.corners_m) for p in these)
        lines = max(len(p.lines) for p in these)
    return _Padded(
        np.cumsum(chosen) - 1,
        np.array([_filled(p.corners_m, corners) for p in these]),
        np.array([_filled(p.lines, lines) for p in these]),
        np.array([_filled(p.edges, edges) for p in these]),
    )


def _filled(rows: Points, count: int) -> Points:
    """Return so many rows: the last one again and again, or only the first ones."""
    if len(rows) >= count:
        return rows[:count]
    return np.vstack([rows, np.repeat(rows[-1:], count - len(rows), axis=0)])


def _chunks(rows: Pairs, one: int, other: int, directions: int) -> Iterator[Pairs]:
    axes = _SIZES[one][1] + _SIZES[other][1] + _SIZES[one][2] * _SIZES[other][2]
    corners = max(_SIZES[one][0], _SIZES[other][0])
    step = max(1, _BUDGET // (axes * (directions + corners)))
    for start in range(0, len(rows), step):
        yield rows[start : start + step]
