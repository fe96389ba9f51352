"""The hard motions first: one grasp that serves pick, carry, place, steadying and letting go."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.grasp_trial import GraspTrial, grasp_trial
from sitewright.planning_twin.grasps import Grasp, grasp_in_use, grasps_of
from sitewright.planning_twin.refusal import NoGrasp, PayloadExceeded, Refusal
from sitewright.planning_twin.tacking import Holding, with_tacks
from sitewright.planning_twin.task import Task, TwinContext
from sitewright.robot_team.cell import EndEffector, Robot


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
        return NoGrasp(is_proven=True, candidates=0, reason="no gripper is mounted")
    if heavy := _too_heavy(context, robot, tool, piece):
        return heavy
    candidates = _candidates(context, robot, tool, piece)
    dropped: Counter[str] = Counter()
    most_tacks = 0
    first = tried[-1].rank if tried else 0
    for rank in range(first, len(candidates)):
        trial = grasp_trial(context, robot, tool, piece, candidates[rank])
        for holding in _serving(trial, rank, dropped):
            if any(h.hold_rad == holding.hold_rad and h.rank == rank for h in tried):
                continue
            tacked = with_tacks(context, holding, tool)
            if len(tacked.tacks) >= context.task.hold_until:
                return tacked
            most_tacks = max(most_tacks, len(tacked.tacks))
            dropped["fasten while held"] += 1
    return NoGrasp(
        is_proven=False,
        candidates=len(candidates),
        dropped_by=tuple(sorted(dropped.items())),
        reason=_reason(context.task, most_tacks, dropped, tried),
    )


def steadying(context: TwinContext, robot: Robot, piece: ComponentId) -> Holding | None:
    """Return how a robot holds the piece that is in place already, or None if it does not."""
    tool, arm = context.tool_of(robot.id), context.site.arms[robot.id]
    if tool is None or arm.held != piece or context.task.placed != piece:
        return None
    grasp = grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)
    holding = Holding(robot=robot.id, piece=piece, grasp=grasp, hold_rad=arm.q_rad)
    return with_tacks(context, holding, tool)


def _serving(trial: GraspTrial, rank: int, dropped: Counter[str]) -> Iterator[Holding]:
    """Yield the holdings of one grasp: one for each clear posture at the target."""
    is_in_hand = trial.context.site.arms[trial.robot.id].held == trial.piece
    picks = [] if is_in_hand else trial.picks()
    pick = next((p for p in picks if trial.can_lift(p)), None)
    if not is_in_hand and pick is None:
        dropped["lift" if picks else "pick"] += 1
        return
    placements = list(trial.placements())
    if not placements:
        dropped["place"] += 1
    for number, place in placements:
        if not trial.can_leave(place):
            dropped["let go"] += 1
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


def _candidates(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> list[Grasp]:
    arm = context.site.arms[robot.id]
    if arm.held == piece:
        return [grasp_in_use(tool, arm.tip_T_held, arm.aperture_m)]
    return grasps_of(context.site.pieces[piece], tool, context.site.world_T_piece[piece])


def _reason(task: Task, most_tacks: int, dropped: Counter[str], tried: tuple[Holding, ...]) -> str:
    if dropped["fasten while held"]:
        return (
            f"at most {most_tacks} of the {task.hold_until} fasteners that must be driven "
            f"before letting go can be driven while it is held"
        )
    if tried:
        return f"the motions of all {len(tried)} grasps that serve were refused"
    if not dropped:
        return "no side of the piece fits between the gripper's fingers"
    return "no grasp serves " + ", ".join(f"{name} ({n})" for name, n in dropped.most_common())


def _too_heavy(
    context: TwinContext, robot: Robot, tool: EndEffector, piece: ComponentId
) -> PayloadExceeded | None:
    own_kg = sum(link.mass_kg for link in tool.description.links)
    mass_kg = own_kg + context.site.pieces[piece].mass_kg
    limit_kg = robot.description.payload_kg
    if limit_kg and mass_kg > limit_kg:
        return PayloadExceeded(mass_kg=mass_kg, payload_kg=limit_kg)
    return None
