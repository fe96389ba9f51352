"""Commands that build: ``run``, ``demo``, ``resolve`` and ``report``."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from sitewright.cli.options import (
    FOLDER,
    approve_option,
    cell_option,
    json_option,
    project_argument,
)
from sitewright.cli.output import Output
from sitewright.cli.terminal import Dialogue

if TYPE_CHECKING:
    from sitewright.app.demo import Demo
    from sitewright.app.project import Project
    from sitewright.app.reporting import Report
    from sitewright.app.run import RunResult
    from sitewright.central_controller.events import AnyEvent
    from sitewright.foundation.canonical import Json
    from sitewright.interaction_twin.labels import Labels

_RUN = "sitewright.run/1"


@click.command()
@project_argument
@approve_option("plan")
@cell_option
@click.option("--from-design", is_flag=True, help="Start on an empty site.")
@json_option
def run(
    project: Path,
    approve: str,
    cell: Path | None,
    from_design: bool,  # noqa: FBT001 -- click
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Plan, ask for approval and build in the simulated cell; goes on where it stopped."""
    from sitewright.app.project import open_project

    opened = open_project(project, cell=cell)
    return _run(opened, approve, Output(is_json), from_design=from_design)


@click.command()
@approve_option("auto")
@click.option(
    "--into",
    type=FOLDER,
    default=Path("sitewright-demo"),
    show_default=True,
    help="Project folder; made if it is not there.",
)
@click.option(
    "--page/--no-page",
    "wants_page",
    default=None,
    help="Approve at the page in a browser; the default where there is a display and a terminal.",
)
@json_option
@click.pass_context
def demo(
    context: click.Context,
    approve: str,
    into: Path,
    wants_page: bool | None,  # noqa: FBT001 -- click
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Build the wooden frame in simulation: two robots, five studs, twelve nails."""
    from sitewright.app.demo import open_demo

    out = Output(is_json)
    ready = open_demo(into)
    is_approve_given = context.get_parameter_source("approve") is not ParameterSource.DEFAULT
    if wants_page or (wants_page is None and not (is_approve_given or is_json) and can_show_page()):
        return _serve_demo(ready, out)
    out.note(
        f"The wooden frame in {ready.project.folder}: building model -> construction graph -> PDDL "
        "-> Fast Downward -> certified motion -> approval -> MuJoCo."
    )
    return _run(ready.project, approve, out, from_design=ready.starts_anew)


def can_show_page() -> bool:
    """Tell whether somebody sits there with a terminal and a display for a browser."""
    is_terminal = sys.stdin.isatty() and sys.stdout.isatty()
    return is_terminal and bool({"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ))


def _serve_demo(ready: Demo, out: Output) -> int:
    from sitewright.app.serving.server import ServeOptions
    from sitewright.cli.serve_command import serve_page

    options = ServeOptions(folder=ready.project.folder, port=0, from_design=ready.starts_anew)
    return serve_page(options, out, opens_browser=can_show_page())


def _run(project: Project, approve: str, out: Output, *, from_design: bool) -> int:
    from sitewright.app.execution import require_targets, run_command
    from sitewright.app.reporting import write_report
    from sitewright.interaction_twin.approvers import (
        ApprovalMode,
        AutoApprover,
        TerminalApprover,
    )
    from sitewright.interaction_twin.labels import labels_of
    from sitewright.interaction_twin.progress import progress_line

    require_targets(project)
    labels = labels_of(project.model, project.cell)
    with Dialogue() as dialogue:
        mode = ApprovalMode(approve)
        is_auto = mode is ApprovalMode.AUTO
        approver = AutoApprover() if is_auto else TerminalApprover(dialogue, labels, mode)

        def on_event(event: AnyEvent) -> None:
            line = progress_line(event, labels)
            if line:
                dialogue.say(line)

        result = run_command(project, approver, on_event=on_event, from_design=from_design)
        report = write_report(project, result.run)
    _tell(result, report, labels, out)
    return result.exit_code


def _tell(result: RunResult, report: Report, labels: Labels, out: Output) -> None:
    figures = report.summary.figures
    out.line(labels.told(result.message))
    out.line(
        f"{figures.targets_installed}/{figures.targets_total} components, "
        f"{figures.fasteners_driven}/{figures.fasteners_total} fasteners, "
        f"{figures.trajectories_certified}/{figures.trajectories_total} motions certified, "
        f"{figures.trajectories_confirmed} confirmed, "
        f"unallowed contacts: {_or_unknown(figures.unallowed_contacts)}, "
        f"{figures.replans} replans, makespan {figures.makespan_s:.0f} s."
    )
    if result.question is not None:
        command = f"sitewright resolve {result.run} {result.question.step} done|not-done|partial"
        out.line(f"Answer with: {command}")
    out.line(f"Report: {result.folder / 'report.html'}")
    out.document(_RUN, _document(result, report))


def _or_unknown(count: int | None) -> str:
    return "unknown" if count is None else str(count)


def _document(result: RunResult, report: Report) -> dict[str, Json]:
    question = result.question
    return {
        **{k: v for k, v in report.document.items() if k != "schema"},
        "exit_code": result.exit_code,
        "message": result.message,
        "folder": str(result.folder),
        "refused": {str(target): reason for target, reason in result.refused.items()},
        "question": None
        if question is None
        else {"run": question.run, "step": question.step, "text": question.text},
    }


@click.command()
@click.argument("run_id", metavar="RUN")
@click.argument("step", type=click.IntRange(min=1))
@click.argument("answer", type=click.Choice(["done", "not-done", "partial"]))
@click.option("--project", type=FOLDER, default=Path(), help="Project folder.")
@click.option("--who", default="local", show_default=True, help="Name for the journal.")
@json_option
def resolve(
    run_id: str,
    step: int,
    answer: str,
    project: Path,
    who: str,
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Answer the question about a STEP of a RUN whose outcome nobody but a person can know."""
    from sitewright.app.execution import resolve_command
    from sitewright.app.project import open_project

    out = Output(is_json)
    question = resolve_command(open_project(project), run_id, step, answer, who=who)
    out.line(f"{question.text} {answer}.")
    out.line(f"Next: sitewright run {project}")
    out.document(
        "sitewright.resolve/1",
        {"run": run_id, "step": step, "question": question.text, "answer": answer},
    )
    return 0


@click.command()
@project_argument
@click.option("--run", "run_id", help="Id of the run; the newest by default.")
@cell_option
@json_option
def report(project: Path, run_id: str | None, cell: Path | None, is_json: bool) -> int:  # noqa: FBT001
    """Write report.html, report.json and schedule.svg of a run anew from its journal."""
    from sitewright.app.project import open_project
    from sitewright.app.reporting import write_report

    out = Output(is_json)
    written = write_report(open_project(project, cell=cell), run_id)
    for file in written.files:
        out.line(str(file))
    content = {k: v for k, v in written.document.items() if k != "schema"}
    out.document("sitewright.report/1", {**content, "files": [str(f) for f in written.files]})
    return 0
