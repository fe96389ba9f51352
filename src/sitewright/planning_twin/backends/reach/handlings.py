"""Who can take a piece and place it as a target: the kinds of grasps that serve, or why none."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.backends.reach.bench import ArmBench, Bench
from sitewright.planning_twin.backends.reach.end_record import EndRecord
from sitewright.planning_twin.backends.reach.grasp_case import GraspCase
from sitewright.planning_twin.backends.reach.grasp_end import GraspEnd, Hold
from sitewright.planning_twin.backends.reach.grasp_set import way_of
from sitewright.planning_twin.backends.whole_turns import Flags
from sitewright.planning_twin.reachability.answer import GraspWay, Handling, Refused
from sitewright.planning_twin.reachability.question import ReachTarget
from sitewright.planning_twin.refusal import NoGrasp, NoIk, PayloadExceeded

_LIMITS = "every posture is outside the joint limits"
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


Goals = dict[int, GraspEnd]
"""Ends at the target by identity of the group of grasps; they are alike for all pieces."""


def handled(bench: Bench, arm: ArmBench, target: ReachTarget, *, is_brief: bool = False) -> Handled:
    """Try all kinds of grasps of the pieces that may become a target, the expected one first.

    Args:
        bench: The cell.
        arm: Robot and gripper.
        target: What is to be placed.
        is_brief: Stop at the first way, and prove nothing where there is none.
    """
    heavy = _too_heavy(arm, target)
    if heavy is not None:
        refused = Refused(where="both", refusal=heavy)
        return Handled(_handling(arm, target, refused=refused, never=(True, True)))
    first: Refused | None = None
    goals: Goals = {}
    for piece in target.task.candidates or (None,):
        if _cannot_be_placed(arm, target, piece, goals):
            continue
        found = _tried(bench, arm, target, piece, goals, is_brief=is_brief)
        if found.holds and piece is not None:
            holds = found.in_order()
            ways = tuple(way_of(h.group.grasps[h.grasp], h.way) for h in holds)
            return Handled(_handling(arm, target, piece=piece, ways=ways), holds)
        lying = None if piece is None else target.world_T_piece[piece]
        first = first or _refused(arm, target, found, lying)
    if is_brief:
        return Handled(_handling(arm, target, refused=first))
    at_target, at_stock = _never(arm, target)
    return Handled(
        _handling(
            arm,
            target,
            refused=at_target or at_stock or first,
            never=(at_target is not None, at_stock is not None),
        )
    )


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


def _cannot_be_placed(
    arm: ArmBench, target: ReachTarget, piece: ComponentId | None, goals: Goals
) -> bool:
    """Tell whether another piece that lies on the same side was tried, and no grasp places it."""
    lying = None if piece is None else target.world_T_piece[piece]
    groups = arm.engines.groups(target.shape, arm.tool, lying)
    known = [goals.get(id(g)) for g in groups]
    return bool(known) and all(g is not None and not g.record.is_served for g in known)


def _tried(
    bench: Bench,
    arm: ArmBench,
    target: ReachTarget,
    piece: ComponentId | None,
    goals: Goals,
    *,
    is_brief: bool,
) -> _Found:
    found = _Found()
    lying = None if piece is None else target.world_T_piece[piece]
    for group in bench.engines.groups(target.shape, arm.tool, lying):
        case = GraspCase(bench, arm, target, group)
        goal = goals.get(id(group))
        if goal is None:
            goal = goals[id(group)] = case.place_end(EndRecord())
        stock = None if piece is None else case.pick_end(piece, found.stock)
        _search(goal, stock, found, rounds=1 if is_brief else _ALWAYS_ROUNDS)
        if is_brief and found.holds:
            break
        found.goal.join(goal.record)
    return found


def _search(goal: GraspEnd, stock: GraspEnd | None, found: _Found, *, rounds: int) -> None:
    """Go through the offsets of all kinds of grasps until each kind serves, or one does."""
    group = goal.group
    ends = [e for e in (goal, stock) if e is not None]
    is_open = np.ones(len(group.kind), dtype=np.bool_)
    for number, all_kinds in enumerate(group.rounds()):
        if number == 1:
            _leave_hopeless(ends, is_open)
        grasps = all_kinds[is_open[all_kinds]]
        if not is_open.any() or (number >= rounds and found.holds):
            return
        picked = set(grasps.tolist()) if stock is None else {h.grasp for h in stock.holds(grasps)}
        if number:
            grasps = np.array([g for g in grasps.tolist() if g in picked], dtype=np.intp)
        for hold in goal.holds(grasps):
            if hold.grasp in picked:
                kind = int(group.kind[hold.grasp])
                found.holds.setdefault((group.width_m, kind), hold)
                is_open[group.kind == kind] = False
    if not found.holds:
        _leave_hopeless(ends, is_open)


def _leave_hopeless(ends: Iterable[GraspEnd], is_open: Flags) -> None:
    """Close the grasps that have no room for the hand at some end, or no posture."""
    for end in ends:
        left = np.flatnonzero(is_open)
        is_open[left] = end.with_hands(left)
    for end in ends:
        if is_open.any():
            is_open &= end.with_postures()


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


def _never(arm: ArmBench, target: ReachTarget) -> tuple[Refused | None, Refused | None]:
    """Return what is proven: no grasp of any side reaches the target; nor any of the pieces.

    A piece that was laid down somewhere else first could be taken on another side.
    """
    if not arm.engines.groups(target.shape, arm.tool, None):
        no = Refused(where="both", refusal=_too_wide(arm, target, is_proven=True))
        return no, no
    at_target = _far(arm, target, [target.task.world_T_target], "target")
    return at_target, _far(arm, target, target.world_T_piece.values(), "stock")


def _far(arm: ArmBench, target: ReachTarget, at: Iterable[Pose], where: str) -> Refused | None:
    groups = arm.engines.groups(target.shape, arm.tool, None)
    nearest_m: list[float] = []
    for pose in at:
        beyond_m = arm.out_of_reach_m(groups, pose)
        if beyond_m is None:
            return None
        nearest_m.append(beyond_m)
    if not nearest_m:
        return None
    no = NoIk(is_proven=True, extension_m=min(nearest_m), tried=len(nearest_m), reason=_LIMITS)
    return Refused(where=where, refusal=no)
