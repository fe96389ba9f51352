"""The commands ``approve``, ``reject``, ``hold`` and ``resume``: decisions through a server."""

from __future__ import annotations

from pathlib import Path

import click

from sitewright.cli.options import FOLDER, Command, json_option
from sitewright.cli.output import Output

_DECISION = "sitewright.decision/1"
_REASONS = ("wrong-component", "wrong-robot", "path-unsafe", "site-differs", "later", "other")


def _project_option(command: Command) -> Command:
    return click.option(
        "--project",
        type=FOLDER,
        default=Path(),
        help="The project that is served; here if not given.",
    )(command)


@click.command()
@click.argument("code")
@click.option("--until", type=click.IntRange(1), metavar="N", help="Approve up to step N only.")
@click.option("--step", "is_step", is_flag=True, help="Approve the next step only.")
@_project_option
@json_option
def approve(code: str, until: int | None, is_step: bool, project: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Approve the open plan with the check code CODE at the project's server."""
    from sitewright.app.serving.by_command import Part
    from sitewright.app.serving.by_command import approve as approve_plan

    if until is not None and is_step:
        raise click.UsageError("Give --until or --step, not both.")
    out = Output(is_json)
    told = approve_plan(project, code, Part(until=until, is_step=is_step))
    out.line(f"Approved by {told['who']}: {told['code']}")
    for line in told["lines"]:
        out.line(f"  {line}")
    out.line(f"Bound to {told['fingerprint']}.")
    out.document(_DECISION, told)
    return 0


@click.command()
@click.argument("code")
@click.option("--reason", type=click.Choice(_REASONS), required=True, help="Why.")
@click.option("--detail", default="", help="Say more.")
@click.option("--step", type=click.IntRange(0), default=0, help="The step it is about.")
@_project_option
@json_option
def reject(
    code: str,
    reason: str,
    detail: str,
    step: int,
    project: Path,
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Reject the open plan with the check code CODE at the project's server."""
    from sitewright.app.serving.by_command import reject as reject_plan

    out = Output(is_json)
    told = reject_plan(project, code, reason=reason, detail=detail, step=step)
    out.line(f"Rejected by {told['who']}: {told['code']}. A new plan is being made.")
    out.document(_DECISION, told)
    return 0


@click.command()
@click.option("--reason", default="", help="Why, in your words.")
@_project_option
@json_option
def hold(reason: str, project: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Ask the project's server to hold the robots. This is no emergency stop."""
    from sitewright.app.serving.by_command import hold as hold_run

    out = Output(is_json)
    told = hold_run(project, reason)
    reached = "The cell was told to hold." if told["told_cell"] else "No cell was there to be told."
    out.line(f"{reached} This is a request; the stop is on the cell.")
    out.document(_DECISION, {"verb": "hold", **told})
    return 0


@click.command()
@_project_option
@json_option
def resume(project: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Begin, or go on after a hold, at the project's server."""
    from sitewright.app.serving.by_command import resume as resume_run

    out = Output(is_json)
    told = resume_run(project)
    out.line(f"{told['who']} lets the run go on. What moves next is asked first.")
    out.document(_DECISION, told)
    return 0
