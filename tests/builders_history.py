"""Journals of runs that never ran: what a controller would have written, event by event."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from builders_run import Clock
from sitewright.app.event_log import EventLog
from sitewright.app.ids import UuidSource
from sitewright.app.run_folder import RunFolder, chain_events, chain_of, run_folders
from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    OperationDone,
    RunFinished,
    RunStarted,
)
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId, RobotId, RunId
from sitewright.foundation.pose import Pose
from sitewright.journal.sqlite import SqliteJournal

ROBOT = RobotId("kr120-a")


def wrote_run(project: Path, run: str, *events: AnyEvent) -> Path:
    """Write the journal of a finished run that continues the newest one; return its folder."""
    folders = run_folders(project / "runs")
    head = chain_events(chain_of(folders[-1]))[1] if folders else ""
    folder, clock = RunFolder(project / "runs" / run), Clock()
    folder.create()
    start = RunStarted(
        run=RunId(run),
        project=project.name,
        hashes={"model": sha256_hex((project / "building.json").read_bytes())},
        previous_run=folders[-1].run if folders else "",
        previous_head=head,
    )
    with SqliteJournal(folder.journal) as journal:
        log = EventLog(folder, journal, clock=clock, ids=UuidSource(clock))
        for event in (start, *events, RunFinished(is_complete=False)):
            log.append(event)
    return folder.path


def built(
    model: BuildingModel, target: str, piece: str, at: Pose, *, until: str = "verified"
) -> list[AnyEvent]:
    """Return what is written while a target is built, until it has the given status."""
    name = ComponentId(target)
    poses = {"world_T_wanted": at, "world_T_measured": at}
    whole: dict[str, Any] = {"target": name, "piece": ComponentId(piece), "robot": ROBOT, **poses}
    operations = model.component_by_id[name].operations
    stages: dict[str, list[AnyEvent]] = {
        "held": [ComponentPositioned(**whole)],
        "placed": [ComponentStanding(target=name)],
        "fastened": [OperationDone(operation=o.id, target=name, robot=ROBOT) for o in operations],
        "verified": [ComponentInstalled(**whole)],
    }
    names = list(stages)
    return [e for stage in names[: names.index(until) + 1] for e in stages[stage]]


def stock_of(model: BuildingModel, target: str) -> str:
    """Return a piece of stock of a target's type; the name of one that is not drawn without any."""
    wanted = model.component_by_id[ComponentId(target)].type
    pieces = [i for s in model.stacks for i in reversed(s.items)]
    fitting = [i for i in pieces if model.component_by_id[i].type == wanted]
    return fitting[0] if fitting else "a-piece"


def targets_of(model: BuildingModel) -> list[str]:
    """Return the ids of all targets, in order of construction."""
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    return [c.id for c in sorted(targets, key=lambda c: (c.order or 0, c.id))]
