"""Why a step is as it is, as a JSON document."""

from __future__ import annotations

from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.step_reasons import Stance, StepReasons
from sitewright.planning_twin.motion import PlannedMotion


def step_document(reasons: StepReasons) -> dict[str, Json]:
    """Return the reasons of a step in plain values, ids and facts as they are in the plan."""
    call = reasons.step.call
    return {
        "run": reasons.run,
        "fingerprint": reasons.fingerprint,
        "code": check_code(reasons.fingerprint),
        "target": reasons.target,
        "number": reasons.number,
        "steps": len(reasons.steps),
        "status": reasons.status,
        "skill": call.skill,
        "robot": call.robot,
        "arguments": list(call.arguments),
        "act": [reasons.act.skill, *reasons.act.arguments],
        "needed_by": [{"fact": x.fact, "step": x.consumer} for x in reasons.needed_by],
        "lasting": list(reasons.lasting),
        "leads_to": list(reasons.way_to_purpose),
        "made_possible_by": [
            {"fact": x.fact, "step": x.producer} for x in reasons.made_possible_by
        ],
        "robots": [
            {"robot": d.robot, "can_by": d.can_by, "obstacles": list(d.obstacles)}
            for d in reasons.doers
        ],
        "piece": reasons.piece,
        "pieces": [
            {"piece": p.piece, "distance_m": p.distance_m, "under": list(p.under)}
            for p in reasons.pieces
        ],
        "duration_s": reasons.step.duration_s,
        "motions": [_motion(m) for m in reasons.step.motions],
        "stance": None if reasons.stance is None else _stance(reasons.stance),
        "may_touch": [list(pair) for pair in reasons.step.contacts],
        "refusals": [_refusal(n) for n in reasons.own_refusals],
        "other_refusals": [_refusal(n) for n in reasons.other_refusals],
    }


def _motion(motion: PlannedMotion) -> dict[str, Json]:
    proof = motion.certificate
    return {
        "duration_s": motion.timed.trajectory.duration_s,
        "closest_distance_m": proof.closest_distance_m if proof.closest_pair else None,
        "closest_pair": list(proof.closest_pair or ()),
        "clearance_m": proof.clearance_m,
        "pairs": proof.pairs,
        "engine": proof.engine,
        "second_engine": motion.agreement.engine,
    }


def _stance(stance: Stance) -> dict[str, Json]:
    pose = stance.world_T_tcp
    return {
        "world_T_tcp": {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)},
        "lean_rad": stance.lean_rad,
        "from_middle_m": stance.from_middle_m,
        "from_above_rad": stance.from_above_rad,
    }


def _refusal(note: RefusalNote) -> dict[str, Json]:
    return {
        "kind": note.kind,
        "reason": note.reason,
        "is_proven": note.is_proven,
        "verdict": note.verdict,
        "then": note.then,
    }
