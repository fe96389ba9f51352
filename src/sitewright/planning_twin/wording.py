"""Refusals in sentences for people."""

from __future__ import annotations

import math

from sitewright.foundation.pose import Pose
from sitewright.foundation.sentence import Sentence
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


def in_words(refusal: Refusal) -> Sentence:
    """Return why a motion is not possible, as the end of a sentence."""
    match refusal:
        case NoIk() | NoGrasp() | PayloadExceeded():
            return _impossible(refusal)
        case BlockedBy(pairs=pairs, reason=reason):
            return Sentence(
                "{reason}: {pairs:comma}",
                reason=reason or Sentence("every posture collides"),
                pairs=tuple(_pair(a, b) for a, b in pairs[:_MOST_PAIRS]),
            )
        case NotClear(pair=(a, b), distance_m=d, threshold_m=t):
            return Sentence(
                "{a} and {b} come to {gap_mm:.1f} mm, allowed {least_mm:.1f} mm",
                a=a,
                b=b,
                gap_mm=d * 1000,
                least_mm=t * 1000,
            )
        case Disagreement(pair=(a, b), distance_m=d):
            return Sentence(
                "the cross-check sees {a} and {b} at {gap_mm:.1f} mm", a=a, b=b, gap_mm=d * 1000
            )
        case NoPath(nodes=nodes, reason=reason):
            return as_sentence(reason) or Sentence(
                "no path was found within {nodes} nodes", nodes=nodes
            )
        case WorkerFailed(task=task, exit_status=status):
            return Sentence(
                "the planning process of {task} died with {status}", task=task, status=status
            )


def as_sentence(text: str) -> Sentence:
    """Return a text as a sentence; one that has no other language stays as it is."""
    return text if isinstance(text, Sentence) else Sentence("{text}", text=text)


def _pair(a: str, b: str) -> Sentence:
    return Sentence("{a} and {b}", a=a, b=b)


def how_held(grasp: Grasp, world_T_piece: Pose) -> Sentence:
    """Return where along a piece a gripper holds it, and how it leans, in words."""
    offset_mm = abs(grasp.piece_T_tcp.position_m[0]) * 1000
    looks = world_T_piece.turn(grasp.piece_T_tcp.z_axis)
    lean_deg = math.degrees(math.acos(max(-1.0, min(1.0, -looks[2]))))
    where = Sentence("at the middle")
    if offset_mm >= 1.0:
        where = Sentence("{offset_mm:.0f} mm off the middle", offset_mm=offset_mm)
    if lean_deg < 1.0:
        return where
    return Sentence("{where}, leaning {lean_deg:.0f} degrees", where=where, lean_deg=lean_deg)


def _impossible(refusal: NoIk | NoGrasp | PayloadExceeded) -> Sentence:
    match refusal:
        case NoIk(extension_m=extension, is_proven=True) if extension > 0.0:
            return Sentence("out of reach by {by_mm:.0f} mm (proven)", by_mm=extension * 1000)
        case NoIk(reason=reason, is_proven=True):
            none = Sentence("no posture reaches it (proven)")
            return Sentence("{what}: {why}", what=none, why=reason) if reason else none
        case NoIk(reason=reason):
            none = Sentence("no posture reaches it (not proven)")
            return Sentence("{what}: {why}", what=none, why=reason) if reason else none
        case NoGrasp(reason=reason):
            return as_sentence(reason)
        case PayloadExceeded(mass_kg=mass, payload_kg=limit):
            return Sentence(
                "{mass_kg:.0f} kg with the end effector, the arm carries {limit_kg:.0f} kg",
                mass_kg=mass,
                limit_kg=limit,
            )


def is_proof(refusal: Refusal) -> bool:
    """Tell whether a refusal is a proof that no motion exists, not just that none was found."""
    match refusal:
        case NoIk(is_proven=is_proven) | NoGrasp(is_proven=is_proven):
            return is_proven
        case PayloadExceeded():
            return True
        case _:
            return False
