"""The summary of a run as one JSON document, so that anyone can check a run by machine."""

from __future__ import annotations

from dataclasses import asdict

from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.report.content import BuiltComponent, Decision, RunSummary

SCHEMA = "sitewright.report/1"


def report_json(summary: RunSummary) -> dict[str, Json]:
    """Return the document of ``report.json`` and of ``run --json``."""
    figures: dict[str, Json] = asdict(summary.figures)
    return {
        "schema": SCHEMA,
        "run": summary.run,
        "project": summary.project,
        "continues": summary.continues,
        "resumed": summary.resumed,
        "ended": summary.ended,
        "ending_note": summary.ending_note,
        "started_utc_ns": summary.started_utc_ns,
        "ended_utc_ns": summary.ended_utc_ns,
        **figures,
        "spent_s": dict(summary.spent_s),
        "robot_times": [asdict(t) for t in summary.robot_times],
        "refusals": [refusal_json(r) for r in summary.refusals],
        "contacts": [
            {"pair": [first, second], "skill": skill} for first, second, skill in summary.contacts
        ],
        "deviations": list(summary.deviations),
        "plans": [asdict(p) for p in summary.plans],
        "decisions": [_decision(d) for d in summary.decisions],
        "as_built": [_built(b) for b in summary.built],
        "hashes": dict(summary.hashes),
    }


def refusal_json(refusal: RefusalNote) -> dict[str, Json]:
    """Return a refusal as ``target, kind, reason, is_proven, verdict, blockers, then``."""
    return {
        "target": refusal.target,
        "kind": refusal.kind,
        "reason": refusal.reason,
        "is_proven": refusal.is_proven,
        "verdict": refusal.verdict,
        "blockers": list(refusal.blockers),
        "then": refusal.then,
    }


def _decision(decision: Decision) -> dict[str, Json]:
    return {
        "at_utc_ns": decision.at_utc_ns,
        "what": decision.what,
        "who": decision.who,
        "code": decision.code,
        "detail": decision.detail,
    }


def _built(row: BuiltComponent) -> dict[str, Json]:
    return {
        "target": row.target,
        "status": row.status,
        "piece": row.piece,
        "robot": row.robot,
        "operations_done": row.operations_done,
        "operations_total": row.operations_total,
        "position_error_m": row.position_error_m,
        "angle_error_rad": row.angle_error_rad,
        "note": row.note,
    }
