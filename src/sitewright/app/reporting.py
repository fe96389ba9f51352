"""Writes the report of a run: figures, page and schedule, all folded from the journal."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sitewright.app.design_changes import project_at
from sitewright.app.looking import graph_at
from sitewright.app.project import Project
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import RunFolder, chain_of, event_of, run_named
from sitewright.central_controller.site_state import SiteState, site_of
from sitewright.errors import ExecutionError
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.drawing.gantt import gantt
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.report.content import RunSummary, Stamped
from sitewright.interaction_twin.report.figures import report_json
from sitewright.interaction_twin.report.page import report_page
from sitewright.interaction_twin.report.summary import summarise
from sitewright.journal.blobs import write_whole
from sitewright.journal.sqlite import read_records

REPORT_JSON, REPORT_PAGE, SCHEDULE = "report.json", "report.html", "schedule.svg"


@dataclass(frozen=True, slots=True, kw_only=True)
class Report:
    """A report that was written.

    Attributes:
        document: Content of ``report.json``.
        files: What was written.
    """

    summary: RunSummary
    document: dict[str, Json]
    files: tuple[Path, ...]


def write_report(
    project: Project, run: str | None = None, *, cell_figures: Mapping[str, Json] | None = None
) -> Report:
    """Write the report of a run into its folder.

    Args:
        project: An opened project.
        run: Id of the run; the newest by default.
        cell_figures: What the cell tells now, if the run has not finished.

    Raises:
        ExecutionError: There is no such run.
        JournalError: Its journal cannot be trusted.
    """
    folder = chosen_run(project, run)
    project = _as_designed_then(project, folder)
    before, after = _sites(project, folder)
    history = [
        Stamped(at_utc_ns=r.t_utc_ns, event=event_of(folder, r))
        for r in read_records(folder.journal)
    ]
    summary = summarise(project.model, before, history, cell_figures=cell_figures)
    document = report_json(summary)
    labels = labels_of(project.model, project.cell)
    page = report_page(summary, graph_at(project, before), graph_at(project, after), labels)
    texts = {
        REPORT_JSON: json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n",
        REPORT_PAGE: page,
        SCHEDULE: gantt(summary.planned, summary.actual, labels) + "\n",
    }
    for name, text in texts.items():
        write_whole(folder.path / name, text.encode())
    files = tuple(folder.path / name for name in texts)
    return Report(summary=summary, document=document, files=files)


def chosen_run(project: Project, run: str | None) -> RunFolder:
    """Return a run of a project, the newest if none is named.

    Raises:
        ExecutionError: There is no such run.
    """
    runs = project.folder / "runs"
    if run is None:
        newest = newest_run(runs)
        if newest is None:
            raise ExecutionError(
                f"{project.folder} has no run yet. `sitewright run {project.folder}` begins one."
            )
        return newest
    return run_named(runs, run)


def _as_designed_then(project: Project, folder: RunFolder) -> Project:
    """Return the project with the design that the run was about at its end."""
    state, _ = fold_of(chain_of(folder), site_of(project.model))
    return project_at(project, state.model_sha256)


def _sites(project: Project, folder: RunFolder) -> tuple[SiteState, SiteState]:
    """Return the site when the run began and as it stands after its last event."""
    design, chain = site_of(project.model), chain_of(folder)
    before = fold_of(chain[:-1], design)[0].site if len(chain) > 1 else design
    return before, fold_of(chain, design)[0].site
