"""Commands that check what a run left behind: ``audit certificates``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import cell_option, json_option, project_argument
from sitewright.cli.output import Output

if TYPE_CHECKING:
    from sitewright.app.auditing import AuditedMotion, AuditReport
    from sitewright.foundation.canonical import Json

_NOT_PROVEN = 8


@click.group()
def audit() -> None:
    """Check the record of a run, independently of the programs that made it."""


@audit.command()
@project_argument
@click.option("--run", "run_id", help="Id of the run; the newest by default.")
@cell_option
@json_option
def certificates(project: Path, run_id: str | None, cell: Path | None, is_json: bool) -> int:  # noqa: FBT001
    """Prove every certificate of a run again, without the planner and the prover."""
    from sitewright.app.auditing import audit_certificates
    from sitewright.app.project import read_project
    from sitewright.app.reporting import chosen_run

    out = Output(is_json)

    def tell(motion: AuditedMotion) -> None:
        for objection in motion.findings.objections:
            out.note(f"{_name(motion)}: {objection.fault}: {objection.what}.")

    opened = read_project(project, cell=cell)
    report = audit_certificates(opened, chosen_run(opened, run_id), on_motion=tell)
    for line in _summary(report):
        out.line(line)
    out.document("sitewright.audit/1", _document(report))
    return 0 if report.is_proven else _NOT_PROVEN


def _name(motion: AuditedMotion) -> str:
    return (
        f"{motion.target}, step {motion.step} ({motion.skill} by {motion.robot}), "
        f"motion {motion.number}"
    )


def _summary(report: AuditReport) -> list[str]:
    refused = [m for m in report.motions if m.findings.objections]
    proven = len(report.motions) - len(refused)
    gaps = sum(m.findings.gaps for m in report.motions)
    total, longest_mm = len(report.motions), _longest_contact_m(report) * 1e3
    lines = [
        f"Run {report.run}: {proven} of {total} motions proven again by {gaps} separating planes.",
        f"Declared contacts last at most {longest_mm:.0f} mm of the tip's way.",
    ]
    if report.not_kept:
        lines.append(f"{report.not_kept} motions are of a version that kept no certificates.")
    if not report.is_scene_compared:
        lines.append("The cell file is another one by now; scenes were not compared with it.")
    return lines


def _longest_contact_m(report: AuditReport) -> float:
    return max((m.findings.longest_contact_m for m in report.motions), default=0.0)


def _document(report: AuditReport) -> dict[str, Json]:
    return {
        "run": report.run,
        "is_proven": report.is_proven,
        "is_scene_compared": report.is_scene_compared,
        "motions_not_kept": report.not_kept,
        "longest_contact_m": _longest_contact_m(report),
        "motions": [
            {
                "target": m.target,
                "step": m.step,
                "skill": m.skill,
                "robot": m.robot,
                "motion": m.number,
                "pairs": m.findings.pairs,
                "planes": m.findings.gaps,
                "closest_distance_m": m.findings.closest_distance_m,
                "longest_contact_m": m.findings.longest_contact_m,
                "objections": [{"fault": o.fault, "what": o.what} for o in m.findings.objections],
            }
            for m in report.motions
        ],
    }
