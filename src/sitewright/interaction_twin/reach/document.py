"""A reach check as a JSON document, schema ``sitewright.reach/1``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TypeVar

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.labels import Labels
from sitewright.planning_twin.reachability.answer import Handling, Operating, Refused, Steadying
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict
from sitewright.planning_twin.refusal import BlockedBy, NoIk, PayloadExceeded
from sitewright.planning_twin.wording import in_words, is_proof

SCHEMA = "sitewright.reach/1"
Row = TypeVar("Row", Handling, Operating)


def reach_document(report: ReachReport, labels: Labels) -> dict[str, Json]:
    """Return the whole check, targets in construction order."""
    return {
        "targets_total": len(report.verdicts),
        "targets_buildable": report.count(Standing.BUILDABLE),
        "share_buildable": report.share,
        "notes": list(report.notes),
        "seconds": report.seconds,
        "targets": [_target(report, v, labels) for v in report.verdicts],
    }


def _target(report: ReachReport, verdict: TargetVerdict, labels: Labels) -> Json:
    target = verdict.target
    steadying = next((s for s in report.answer.steadyings if s.target == target), None)
    return {
        "id": target,
        "name": labels.name(target),
        "standing": verdict.standing.value,
        "robots": list(verdict.robots),
        "reasons": list(verdict.reasons),
        "waits_for": list(verdict.waits_for),
        "handlings": [_handling(h) for h in _of(target, report.answer.handlings)],
        "operations": [_operating(o) for o in _of(target, report.answer.operatings)],
        "steadying": None if steadying is None else _steadying(steadying),
    }


def _of(target: ComponentId, rows: Sequence[Row]) -> list[Row]:
    return [r for r in rows if r.target == target]


def _handling(handling: Handling) -> Json:
    return {
        "robot": handling.robot,
        "end_effector": handling.end_effector,
        "piece": handling.piece,
        "ways": [asdict(w) for w in handling.ways],
        "refused": _refused(handling.refused),
    }


def _operating(operating: Operating) -> Json:
    return {
        "operation": operating.operation,
        "robot": operating.robot,
        "end_effector": operating.end_effector,
        "ways": list(operating.ways),
        "refused": _refused(operating.refused),
    }


def _steadying(steadying: Steadying) -> Json:
    return {
        "needed": steadying.needed,
        "robot": steadying.robot,
        "done": list(steadying.done),
        "ways_looked_at": steadying.ways,
        "is_enough": steadying.is_enough,
    }


def _refused(refused: Refused | None) -> Json:
    if refused is None:
        return None
    facts: dict[str, Json] = {}
    match refused.refusal:
        case NoIk(extension_m=extension_m):
            facts = {"extension_m": extension_m}
        case PayloadExceeded(mass_kg=mass_kg, payload_kg=payload_kg):
            facts = {"mass_kg": mass_kg, "payload_kg": payload_kg}
        case BlockedBy(pairs=pairs):
            facts = {"pairs": [list(pair) for pair in pairs]}
        case _:
            pass
    return {
        "where": refused.where,
        "kind": type(refused.refusal).__name__,
        "reason": in_words(refused.refusal),
        "is_proven": is_proof(refused.refusal),
        **facts,
    }
