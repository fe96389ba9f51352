"""Refusals in sentences for people."""

from __future__ import annotations

import math

from sitewright.foundation.pose import Pose
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoGrasp,
    NoIk,
    NoPath,
    NotClear,
    PayloadExceeded,
    Refusal,
    WorkerFailed,
)

_MOST_PAIRS = 3


def in_words(refusal: Refusal) -> str:
    """Return why a motion is not possible, as the end of a sentence."""
    match refusal:
        case NoIk() | NoGrasp() | PayloadExceeded():
            return _impossible(refusal)
        case BlockedBy(pairs=pairs, reason=reason):
            listed = ", ".join(f"{a} and {b}" for a, b in pairs[:_MOST_PAIRS])
            return f"{reason or 'every posture collides'}: {listed}"
        case NotClear(pair=(a, b), distance_m=d, threshold_m=t):
            return f"{a} and {b} come to {d * 1000:.1f} mm, allowed {t * 1000:.1f} mm"
        case Disagreement(pair=(a, b), distance_m=d):
            return f"the cross-check sees {a} and {b} at {d * 1000:.1f} mm"
        case NoPath(nodes=nodes, reason=reason):
            return reason or f"no path was found within {nodes} nodes"
        case WorkerFailed(task=task, exit_status=status):
            return f"the planning process of {task} died with {status}"


def how_held(grasp: Grasp, world_T_piece: Pose) -> str:
    """Return where along a piece a gripper holds it, and how it leans, in words."""
    offset_mm = abs(grasp.piece_T_tcp.position_m[0]) * 1000
    looks = world_T_piece.turn(grasp.piece_T_tcp.z_axis)
    lean_deg = math.degrees(math.acos(max(-1.0, min(1.0, -looks[2]))))
    where = f"{offset_mm:.0f} mm off the middle" if offset_mm >= 1.0 else "at the middle"
    return f"{where}, leaning {lean_deg:.0f} degrees" if lean_deg >= 1.0 else where


def _impossible(refusal: NoIk | NoGrasp | PayloadExceeded) -> str:
    match refusal:
        case NoIk(extension_m=extension, is_proven=True) if extension > 0.0:
            return f"out of reach by {extension * 1000:.0f} mm (proven)"
        case NoIk(reason=reason, is_proven=is_proven):
            proof = "proven" if is_proven else "not proven"
            return f"no posture reaches it ({proof}){f': {reason}' if reason else ''}"
        case NoGrasp(reason=reason):
            return reason
        case PayloadExceeded(mass_kg=mass, payload_kg=limit):
            return f"{mass:.0f} kg with the end effector, the arm carries {limit:.0f} kg"


def is_proof(refusal: Refusal) -> bool:
    """Tell whether a refusal is a proof that no motion exists, not just that none was found."""
    match refusal:
        case NoIk(is_proven=is_proven) | NoGrasp(is_proven=is_proven):
            return is_proven
        case PayloadExceeded():
            return True
        case _:
            return False
