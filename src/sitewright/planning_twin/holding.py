"""The hard motions first: one grasp that serves pick, carry, place, steadying and letting go."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
from sitewright.planning_twin.grasp_trial import GraspTrial, grasp_trial
from sitewright.planning_twin.grasps import Grasp, grasp_in_use, grasps_of
from sitewright.planning_twin.held_proof import proof_of_too_few
from sitewright.planning_twin.held_words import too_few_words
from sitewright.planning_twin.moment import moment_of
from sitewright.planning_twin.refusal import (
    BlockedBy,
    HeldFreedoms,
    NoGrasp,
    NoIk,
    PayloadExceeded,
    Refusal,
)
from sitewright.planning_twin.tacking import Holding, Tacking, owed_tacks, with_tacks
from sitewright.planning_twin.task import TwinContext
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.description import Joints

_TACKS = "fasten while held"
_PICK = "pick and lift"
_PLACE = "place"
_FAR_PIECE = "reach the piece"
_FAR_TARGET = "reach the target"
_LET_GO = "let go"
DROPPED: Mapping[str, Sentence] = {
    _TACKS: Sentence("fasten while held"),
    _PICK: Sentence("pick and lift"),
    _PLACE: Sentence("place"),
    _LET_GO: Sentence("let go"),
    _FAR_PIECE: Sentence("reach the piece"),
    _FAR_TARGET: Sentence("reach the target"),
}
"""Where grasps fail, in words."""
_LOOKED_AT = 8
"""So many grasps are looked at to tell what is in the way, once none has served."""


def find_holding(
    context: TwinContext,
    robot: Robot,
    piece: ComponentId,
    *,
    tried: tuple[Holding, ...] = (),
) -> Holding | Refusal:
    """Search the grasp freedoms of a robot for a piece, cheapest first.

    The first grasp wins that lets enough fasteners be driven while it is held.

    Args:
        context: Engines, site and task.
        robot: Who should take the piece.
        piece: A candidate of the task.
        tried: Holdings whose motions were refused; the search goes on after the last of them.
    """
    tool = context.tool_of(robot.id)
    if tool is None or tool.grips_m is None:
        return NoGrasp(is_proven=True, candidates=0, reason=Sentence("no gripper is mounted"))
    candidates = _candidates(context, robot, tool, piece)
    hopeless = (
        _too_heavy(context, robot, tool, piece)
        or _too_far(context, robot, tool, piece, candidates)
        or _taken(context, robot, tool, piece, candidates)
    )
    if hopeless is not None:
        return hopeless
    dropped: Counter[str] = Counter()
    tacking = Tacking(context, robot.id, piece, tool)
    first = tried[-1].rank if tried else 0
    for rank in range(first, len(candidates)):
        trial = grasp_trial(context, robot, tool, piece, candidates[rank])
        tacks = tacking.of(trial.grasp)
        if not any(map(tacks.suffice, trial.hold_postures())):
            dropped[_TACKS if tacks.asked else _PLACE] += 1
            continue
        for holding in _serving(trial, rank, dropped):
            is_tried = any(h.hold_rad == holding.hold_rad and h.rank == rank for h in tried)
            if not is_tried and tacks.suffice(holding.hold_rad):
                passed_over = tuple(sorted(dropped.items()))
                return replace(
                    holding, tacks=tacks.while_at(holding.hold_rad), passed_over=passed_over
                )
    never = _never_enough(context, robot, tool, piece, candidates, dropped)
    return NoGrasp(
        is_proven=not candidates or never is not None,
        candidates=len(candidates),
        dropped_by=tuple(sorted(dropped.items())),
        reason=_reason(tacking, dropped, tried, never),
        nearest=None if tried else _nearest(context, robot, tool, piece, candidates, never),
        freedoms=never,
    )


def _never_enough(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    candidates: list[Grasp],
    dropped: Counter[str],
) -> HeldFreedoms | None:
    """Return over what it is proven that no way to hold lets enough be driven meanwhile."""
    if not dropped[_TACKS] or set(dropped) - {_TACKS, _PLACE}:
        return None
    return proof_of_too_few(context, robot, tool, piece, candidates)


def depends_on_start(refusal: Refusal) -> bool:
    """Tell whether a search for a grasp might have ended otherwise if the piece lay elsewhere."""
    match refusal:
        case NoGrasp(dropped_by=dropped):
            return any(name in (_PICK, _FAR_PIECE) for name, _ in dropped)
        case _:
            return False


def is_for_fasteners(refusal: Refusal) -> bool:
    """Tell whether there would be a grasp if fewer fasteners had to be driven while it is held."""
    return isinstance(refusal, NoGrasp) and any(name == _TACKS for name, _ in refusal.dropped_by)


def is_out_of_reach(
    context: TwinContext, robot: Robot, piece: ComponentId, world_T_piece: Pose
) -> bool:
    """Tell whether it is proven that a robot reaches a piece at a pose with no grasp at all."""
    tool = context.tool_of(robot.id)
    if tool is None or tool.grips_m is None:
        return True
    candidates = _candidates(context, robot, tool, piece)
    return bool(_proofs_of_far(context, robot, tool, world_T_piece, candidates))


def _taken(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    candidates: list[Grasp],
) -> BlockedBy | None:
    """Return what is where this piece belongs: pieces dropped there, fixtures, zones."""
    for grasp in candidates:
        trial = grasp_trial(context, robot, tool, piece, grasp)
        found = trial.in_its_place()
        if found is not None:
            return _in_its_place(trial, *found)
    return None


def _in_its_place(trial: GraspTrial, others: tuple[str, ...], q_rad: Joints) -> BlockedBy | None:
    if not others:
        return None
    is_one = len(others) == 1
    reason = (
        Sentence("{things:and} is in its place", things=others)
        if is_one
        else Sentence("{things:and} are in its place", things=others)
    )
    pairs = tuple((str(trial.piece), other) for other in others)
    return BlockedBy(
        pairs=pairs,
        removals=(others,),
        reason=reason,
        moment=moment_of(trial.carrying.scene, {trial.robot.id: q_rad}, pairs[0]),
    )


def _nearest(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    candidates: list[Grasp],
    never: HeldFreedoms | None,
) -> BlockedBy | None:
    """Return what is in the way of a fastener while the piece is held, else of a first grasp."""
    if never is not None and never.blocked:
        return never.blocked[0][1]
    return _in_the_way(context, robot, tool, piece, candidates)


def _in_the_way(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    candidates: list[Grasp],
) -> BlockedBy | None:
    """Return what keeps the cheapest of the first grasps that something is in the way of."""
    trials = (grasp_trial(context, robot, tool, piece, g) for g in candidates[:_LOOKED_AT])
    return next((why for t in trials if (why := t.why_not()) is not None), None)


def _too_far(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    piece: ComponentId,
    candidates: list[Grasp],
) -> NoGrasp | None:
    """Return the proof that no grasp reaches the piece, or the target, from the robot's base."""
    ends = {_FAR_TARGET: context.task.world_T_target}
    if context.site.arms[robot.id].held != piece:
        ends[_FAR_PIECE] = context.site.world_T_piece[piece]
    for end, world_T_piece in ends.items():
        proofs = _proofs_of_far(context, robot, tool, world_T_piece, candidates)
        if proofs:
            least = min(p.extension_m for p in proofs)
            return NoGrasp(
                is_proven=True,
                candidates=len(candidates),
                dropped_by=((end, len(candidates)),),
                reason=_far(end, least),
            )
    return None


def _far(end: str, least_m: float) -> Sentence:
    is_target = end == _FAR_TARGET
    if least_m <= 0.0 and is_target:
        return Sentence("the target is out of reach with every grasp (proven)")
    if least_m <= 0.0:
        return Sentence("the piece is out of reach with every grasp (proven)")
    if is_target:
        return Sentence(
            "the target is out of reach by {by_mm:.0f} mm with every grasp (proven)",
            by_mm=least_m * 1000,
        )
    return Sentence(
        "the piece is out of reach by {by_mm:.0f} mm with every grasp (proven)",
        by_mm=least_m * 1000,
    )


def _proofs_of_far(
    context: TwinContext,
    robot: Robot,
    tool: EndEffector,
    world_T_piece: Pose,
    candidates: list[Grasp],
) -> list[NoIk]:
    """Return the proof for each grasp, or nothing as soon as one grasp has none."""
    proofs: list[NoIk] = []
    for grasp in candidates:
        proof = _proof_of_far(context, robot, tool, world_T_piece, grasp)
        if proof is None:
            return []
        proofs.append(proof)
    return proofs


def _proof_of_far(
    context: TwinContext, robot: Robot, tool: EndEffector, world_T_piece: Pose, grasp: Grasp
) -> NoIk | None:
    base_T_tip = robot.world_T_base.inverse() @ world_T_piece @ grasp.tip_T_piece(tool).inverse()
    kinematics = context.backends.kinematics
    found = kinematics.solve(robot.description, base_T_tip, robot.home_q_rad)
    return found if isinstance(found, NoIk) and found.is_proven else None


def steadying(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | None:
    """Return how a robot holds the piece that is in place already, or None if it does not."""
    tool, arm = context.tool_of(robot.id), context.site.arms[robot.id]
    if tool is None or arm.held != piece or context.task.placed != piece:
        return None
    grasp = grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)
    holding = Holding(robot=robot.id, piece=piece, grasp=grasp, hold_rad=arm.q_rad)
    tacks = with_tacks(context, holding, tool).tacks
    return replace(holding, tacks=owed_tacks(context.task, tacks))


def _serving(trial: GraspTrial, rank: int, dropped: Counter[str]) -> Iterator[Holding]:
    """Yield the holdings of one grasp: one for each clear posture at the target."""
    is_in_hand = trial.context.site.arms[trial.robot.id].held == trial.piece
    pick = None if is_in_hand else next((p for p in trial.picks() if trial.can_lift(p)), None)
    if not is_in_hand and pick is None:
        dropped[_PICK] += 1
        return
    is_placed = False
    for number, place in trial.placements():
        is_placed = True
        if not trial.can_leave(place):
            dropped[_LET_GO] += 1
            continue
        yield Holding(
            robot=trial.robot.id,
            piece=trial.piece,
            grasp=trial.grasp,
            hold_rad=place.contact_rad,
            pick_rad=None if pick is None else pick.contact_rad,
            rank=rank,
            insertion=number,
        )
    if not is_placed:
        dropped[_PLACE] += 1


def _candidates(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> list[Grasp]:
    arm = context.site.arms[robot.id]
    if arm.held == piece:
        return [grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)]
    return grasps_of(context.site.pieces[piece], tool, context.site.world_T_piece[piece])


def _reason(
    tacking: Tacking,
    dropped: Counter[str],
    tried: tuple[Holding, ...],
    never: HeldFreedoms | None,
) -> Sentence:
    if dropped[_TACKS]:
        return too_few_words(tacking, never)
    if tried:
        return Sentence(
            "the motions of all {count} grasps that serve were refused", count=len(tried)
        )
    if not dropped:
        return Sentence("no side of the piece fits between the gripper's fingers")
    return Sentence("no grasp serves {ends:comma}", ends=dropped_at(dropped.most_common()))


def dropped_at(dropped: Iterable[tuple[str, int]]) -> tuple[Sentence, ...]:
    """Return at which ends of its motions grasps failed, and how many, in words."""
    return tuple(Sentence("{end} ({count})", end=DROPPED[end], count=n) for end, n in dropped)


def _too_heavy(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> PayloadExceeded | None:
    own_kg = sum(link.mass_kg for link in tool.description.links)
    mass_kg = own_kg + context.site.pieces[piece].mass_kg
    limit_kg = robot.description.payload_kg
    if limit_kg and mass_kg > limit_kg:
        return PayloadExceeded(mass_kg=mass_kg, payload_kg=limit_kg)
    return None
