"""Runs as lists and as stories to replay, read from their journals."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.app.design_changes import project_at
from sitewright.app.project import Project
from sitewright.app.run import fold_of
from sitewright.app.run_folder import RunFolder, chain_of, event_of, run_folders
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import RunStarted
from sitewright.central_controller.site_state import site_of
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.drawing.bars import Bar
from sitewright.interaction_twin.event_document import event_document
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import Phrasebook
from sitewright.interaction_twin.replay_document import ReplaySource, replay_document
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.report.timeline import timeline
from sitewright.interaction_twin.scene_document import docked_at
from sitewright.interaction_twin.web.twin import Document
from sitewright.journal.sqlite import read_records

_MS = 1_000_000


def runs_document(project: Project) -> Document:
    """Return all runs of a project, the newest first."""
    folders = [f for f in run_folders(project.folder / "runs") if not f.is_blank()]
    return {"runs": [_row(project, folder) for folder in reversed(folders)]}


def run_document(project: Project, run: str, labels: Labels, book: Phrasebook) -> Document | None:
    """Return one run with its events and its bars on the time axis; None if there is none."""
    folders = {f.run: f for f in run_folders(project.folder / "runs")}
    if run not in folders:
        return None
    folder = folders[run]
    stamped = history(folder)
    bars = timeline(s.event for s in stamped)
    return {
        **_row(project, folder),
        "events": [event_document(run, s, labels, book) for s in stamped],
        "planned": bars_document(bars.planned, labels),
        "actual": bars_document(bars.actual, labels),
    }


def replay_of(project: Project, run: str) -> Document | None:
    """Return everything that was sensed in a run; None if there is none."""
    folder = next((f for f in run_folders(project.folder / "runs") if f.run == run), None)
    if folder is None:
        return None
    chain, design = chain_of(folder), site_of(project.model)
    before = fold_of(chain[:-1], design)[0].site if len(chain) > 1 else design
    docks = ((t.id, docked_at(project.cell, t)) for t in project.cell.end_effector_by_id.values())
    return replay_document(
        ReplaySource(
            run=run,
            before=before,
            world_T_mount={tool: pose for tool, pose in docks if pose is not None},
            history=history(folder),
        )
    )


def history(folder: RunFolder) -> list[Stamped]:
    """Return the records of one run."""
    return [
        Stamped(at_utc_ns=r.t_utc_ns, event=event_of(folder, r), number=r.seq)
        for r in read_records(folder.journal)
    ]


def bars_document(bars: Sequence[Bar], labels: Labels) -> list[Json]:
    """Return skills on the time axis."""
    return [
        {
            "robot": bar.robot,
            "step": bar.step,
            "fingerprint": bar.fingerprint,
            "skill": bar.call.skill,
            "words": narrate(bar.call, labels),
            "target": bar.target,
            "starts_s": round(bar.starts_s, 3),
            "duration_s": round(bar.duration_s, 3),
            "is_done": bar.is_done,
        }
        for bar in bars
    ]


def _row(project: Project, folder: RunFolder) -> dict[str, Json]:
    stamped = history(folder)
    first = stamped[0].event
    state, _ = fold_of(chain_of(folder), site_of(project.model))
    then = project_at(project, state.model_sha256)
    state, _ = fold_of(chain_of(folder), site_of(then.model))
    return {
        "id": folder.run,
        "started_at_ms": stamped[0].at_utc_ns // _MS,
        "ended_at_ms": stamped[-1].at_utc_ns // _MS,
        "ended": _ended(state),
        "installed": len(state.site.installed),
        "targets": len(state.site.targets),
        "continues": first.previous_run if isinstance(first, RunStarted) else "",
    }


def _ended(state: CycleState) -> str:
    if state.finished is not None:
        return "complete" if state.site.is_complete else "finished"
    return "held" if state.held is not None else "open"
