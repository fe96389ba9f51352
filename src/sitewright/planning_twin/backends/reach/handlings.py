"""Who can take a piece and place it as a target: the kinds of grasps that serve, or why none."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.kinematic_chain import matrix_of
from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.grasp_set import way_of
from sitewright.planning_twin.backends.reach.handling import GraspTrials, Hold
from sitewright.planning_twin.reachability.answer import GraspWay, Handling, Refused
from sitewright.planning_twin.reachability.question import ReachTarget
from sitewright.planning_twin.refusal import NoGrasp, PayloadExceeded

_NAMELESS = ComponentId("piece")
_ALWAYS_ROUNDS = 3
"""So many offsets are looked at for every kind of grasp; more only while none serves."""


@dataclass(frozen=True, slots=True, eq=False)
class Handled:
    """What was found for one arm and target, with the postures for those who ask further."""

    handling: Handling
    holds: tuple[Hold, ...] = ()


@dataclass(slots=True)
class _Found:
    """Both ends over all groups of grasps of one piece."""

    stock: EndRecord = field(default_factory=EndRecord)
    goal: EndRecord = field(default_factory=EndRecord)
    holds: dict[tuple[float, int], Hold] = field(default_factory=dict)

    def in_order(self) -> tuple[Hold, ...]:
        """Return the ways to hold, the cheapest grasp first."""
        return tuple(sorted(self.holds.values(), key=lambda h: h.group.grasps[h.grasp].cost))


def handled(bench: Bench, arm: ArmBench, target: ReachTarget) -> Handled:
    """Try all kinds of grasps of the pieces that may become a target, the expected one first."""
    heavy = _too_heavy(arm, target)
    if heavy is not None:
        refused = Refused(where="both", refusal=heavy)
        return Handled(_handling(arm, target, refused=refused, never=(True, True)))
    first: Refused | None = None
    for piece in target.task.candidates:
        lying = target.world_T_piece[piece]
        found = _tried(bench, arm, target, piece, lying)
        if found.holds:
            holds = found.in_order()
            ways = tuple(way_of(h.group.grasps[h.grasp], h.insertion) for h in holds)
            return Handled(_handling(arm, target, piece=piece, ways=ways), holds)
        first = first or _refused(arm, target, found, lying)
    if first is None:
        found = _tried(bench, arm, target, _NAMELESS, None)
        first = _refused(arm, target, found, None)
    return Handled(_handling(arm, target, refused=first, never=_never(arm, target)))


def _handling(
    arm: ArmBench,
    target: ReachTarget,
    *,
    piece: ComponentId | None = None,
    ways: tuple[GraspWay, ...] = (),
    refused: Refused | None = None,
    never: tuple[bool, bool] = (False, False),
) -> Handling:
    return Handling(
        robot=arm.robot.id,
        end_effector=arm.tool.id,
        target=target.id,
        piece=piece or next(iter(target.task.candidates), None),
        ways=ways,
        refused=refused,
        never_at_target=never[0],
        never_at_stock=never[1],
    )


def _tried(
    bench: Bench, arm: ArmBench, target: ReachTarget, piece: ComponentId, lying: Pose | None
) -> _Found:
    found = _Found()
    for group in bench.engines.groups(target.shape, arm.tool, lying):
        trials = GraspTrials(
            bench=bench,
            arm=arm,
            target=target,
            piece=piece,
            group=group,
            lying=lying,
            stock=found.stock,
            goal=found.goal,
        )
        _search(trials, found)
    return found


def _search(trials: GraspTrials, found: _Found) -> None:
    """Go through the offsets of all kinds of grasps until each kind serves, or one does."""
    group = trials.group
    is_open = np.ones(len(group.kind), dtype=np.bool_)
    for number, all_kinds in enumerate(group.rounds()):
        if number == 1 and is_open.any():
            is_open &= trials.with_postures()
        grasps = all_kinds[is_open[all_kinds]]
        if not is_open.any() or (number >= _ALWAYS_ROUNDS and found.holds):
            return
        if not len(grasps):
            continue
        is_picked = trials.at_stock(grasps)
        placed = grasps if number == 0 else grasps[is_picked]
        picked = set(grasps[is_picked].tolist())
        for hold in trials.at_target(placed) if len(placed) else ():
            if hold.grasp in picked:
                kind = int(group.kind[hold.grasp])
                found.holds.setdefault((group.width_m, kind), hold)
                is_open[group.kind == kind] = False


def _refused(arm: ArmBench, target: ReachTarget, found: _Found, lying: Pose | None) -> Refused:
    """Return the reason that says most: what is proven first."""
    engines = arm.engines
    if not engines.groups(target.shape, arm.tool, lying):
        fits_no_side = not engines.groups(target.shape, arm.tool, None)
        return Refused(where="both", refusal=_too_wide(arm, target, is_proven=fits_no_side))
    ends = [("target", found.goal), *([] if lying is None else [("stock", found.stock)])]
    open_ends = [(name, end) for name, end in ends if not end.is_served]
    for name, end in sorted(open_ends, key=lambda e: e[1].has_posture or not e[1].is_never):
        return Refused(where=name, refusal=end.refusal())
    if lying is None:
        reason = "the stock has no piece for it"
        return Refused(where="stock", refusal=_no_grasp(reason))
    reason = "no grasp that serves at the stock serves at the target"
    return Refused(where="both", refusal=_no_grasp(reason))


def _no_grasp(reason: str) -> NoGrasp:
    return NoGrasp(is_proven=False, candidates=0, reason=reason)


def _too_wide(arm: ArmBench, target: ReachTarget, *, is_proven: bool) -> NoGrasp:
    low, high = (1000.0 * g for g in arm.tool.grips_m or (0.0, 0.0))
    _, y, z = (1000.0 * s for s in target.shape.size_m)
    reason = f"{arm.tool.id} grips {low:.0f} to {high:.0f} mm, the piece is {y:.0f} x {z:.0f} mm"
    if not is_proven:
        reason += ", and as it lies no side that fits looks up"
    return NoGrasp(is_proven=is_proven, candidates=0, reason=reason)


def _too_heavy(arm: ArmBench, target: ReachTarget) -> PayloadExceeded | None:
    own_kg = sum(link.mass_kg for link in arm.tool.description.links)
    mass_kg, limit_kg = own_kg + target.shape.mass_kg, arm.robot.description.payload_kg
    if limit_kg and mass_kg > limit_kg:
        return PayloadExceeded(mass_kg=mass_kg, payload_kg=limit_kg)
    return None


def _never(arm: ArmBench, target: ReachTarget) -> tuple[bool, bool]:
    """Return what is proven: no grasp of any side reaches the target; nor any of the pieces.

    A piece that was laid down somewhere else first could be taken on another side.
    """
    lying = target.world_T_piece.values()
    at_target = _is_out_of_reach(arm, target, [target.task.world_T_target])
    return at_target, bool(lying) and _is_out_of_reach(arm, target, lying)


def _is_out_of_reach(arm: ArmBench, target: ReachTarget, at: Iterable[Pose]) -> bool:
    for pose in at:
        for group in arm.engines.groups(target.shape, arm.tool, None):
            rows = arm.postures(matrix_of(pose) @ group.piece_T_tip)
            if not rows.is_never.all():
                return False
    return True
