"""Observations as differences: what an event records, and how the record is put together again."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sitewright.central_controller.events import SiteObserved
from sitewright.foundation.pose import Pose
from sitewright.robot_team.driver import Observation, RobotObservation

_SAME_M = 1e-4
_PIECES_PER_EVENT = 100
_SAME_RAD = 2e-4


def difference(before: Observation | None, now: Observation, *, after: str = "") -> SiteObserved:
    """Return what changed between two observations; `before` None records all."""
    if before is None:
        before = Observation(time_s=0.0, robots={}, world_T_piece={})
    was = {f.operation: f for f in before.fasteners}
    there = {f.operation for f in now.fasteners}
    return SiteObserved(
        time_s=now.time_s,
        after=after,
        robots={r: s for r, s in now.robots.items() if not _is_same(before.robots.get(r), s)},
        world_T_piece={
            piece: pose
            for piece, pose in now.world_T_piece.items()
            if not _is_near(before.world_T_piece.get(piece), pose)
        },
        gone=tuple(sorted(set(before.world_T_piece) - set(now.world_T_piece))),
        fasteners=tuple(f for f in now.fasteners if f.operation not in was),
        lost_fasteners=tuple(sorted(o for o in was if o not in there)),
        coverage={o: c for o, c in now.coverage.items() if before.coverage.get(o) != c},
        docked=dict(now.docked),
    )


def differences(
    before: Observation | None, now: Observation, *, after: str = ""
) -> Iterator[SiteObserved]:
    """Return what changed in events that fit the journal; only the last one says `after`."""
    whole = difference(before, now, after=after)
    pieces = sorted(whole.world_T_piece)
    for start in range(_PIECES_PER_EVENT, len(pieces), _PIECES_PER_EVENT):
        some = pieces[start : start + _PIECES_PER_EVENT]
        yield SiteObserved(
            time_s=whole.time_s,
            world_T_piece={p: whole.world_T_piece[p] for p in some},
            docked=whole.docked,
        )
    first = {p: whole.world_T_piece[p] for p in pieces[:_PIECES_PER_EVENT]}
    yield replace(whole, world_T_piece=first)


def merged(before: Observation | None, event: SiteObserved) -> Observation:
    """Return the observation after a recorded difference."""
    if before is None:
        before = Observation(time_s=0.0, robots={}, world_T_piece={})
    poses = {p: T for p, T in before.world_T_piece.items() if p not in event.gone}
    kept = (f for f in before.fasteners if f.operation not in event.lost_fasteners)
    return replace(
        before,
        time_s=event.time_s,
        robots={**before.robots, **event.robots},
        world_T_piece={**poses, **event.world_T_piece},
        fasteners=(*kept, *event.fasteners),
        coverage={**before.coverage, **event.coverage},
        docked=dict(event.docked),
    )


def _is_near(a: Pose | None, b: Pose) -> bool:
    return a is not None and a.distance_to_m(b) <= _SAME_M and a.angle_to_rad(b) <= _SAME_RAD


def _is_same(a: RobotObservation | None, b: RobotObservation) -> bool:
    if a is None or (a.mounted, a.gripped) != (b.mounted, b.gripped):
        return False
    still = all(abs(x - y) <= _SAME_RAD for x, y in zip(a.q_rad, b.q_rad, strict=True))
    return still and abs(a.aperture_m - b.aperture_m) <= _SAME_M
