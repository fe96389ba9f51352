"""The composition root of a run: project, engines, simulated cell, journal, approver."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from sitewright.app.clock import SystemClock
from sitewright.app.design_changes import keep_design, kept_design
from sitewright.app.engines import identity_of, proposals_of
from sitewright.app.ids import UuidSource
from sitewright.app.installing import write_as_built
from sitewright.app.planning import start_of
from sitewright.app.project import BUILDING, Project, ProjectError
from sitewright.app.run import RunOptions, RunResult, fold_of, newest_run, resolve, run_project
from sitewright.app.run_folder import chain_of, installation_key
from sitewright.app.runner import RunPorts
from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import AnyEvent
from sitewright.central_controller.ports import Answer, Approver, Hold, Question
from sitewright.central_controller.proposing import Proposals
from sitewright.central_controller.protection import protection_problems
from sitewright.central_controller.site_state import site_of
from sitewright.central_controller.zoned import ZonedProposals
from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.report.content import Stamped
from sitewright.robot_team.driver import CellDriver
from sitewright.robot_team.piece import Piece

OnEvent = Callable[[AnyEvent], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Watch:
    """How somebody outside follows a run and steers it beside the approvals.

    Attributes:
        on_record: Gets the run's id and each record once it is on the disk.
        on_connect: Gets the cell's driver whenever it is opened.
        hold_asked: The hold that somebody wants, if any.
        who: Who began it at a page, for the journal.
        decision: What the journal keeps of that.
        first: What is recorded first of all, because a person wanted it while the run stood.
    """

    on_record: Callable[[str, Stamped], None] = field(default=lambda _run, _record: None)
    on_connect: Callable[[CellDriver], None] = field(default=lambda _: None)
    hold_asked: Callable[[], Hold | None] = field(default=lambda: None)
    who: str = ""
    decision: DecisionRecord | None = None
    first: Callable[[CycleState], Sequence[AnyEvent]] = field(default=lambda _: ())


_UNDO = "Undo that in building.json, or begin on an empty site: run --from-design."


def run_command(
    project: Project,
    approver: Approver,
    *,
    on_event: OnEvent | None = None,
    from_design: bool = False,
    watch: Watch | None = None,
) -> RunResult:
    """Run a project in simulation until it stops: complete, held, refused or in question.

    Args:
        project: An opened project.
        approver: Who is asked before anything moves.
        on_event: Called with each recorded event, for progress.
        from_design: Start on an empty site instead of going on.
        watch: Who follows and steers it from outside.

    Raises:
        ModelRejectedError: The design changed what stands already.
        LockedError: Another run has this project or this cell.
        BackendError: An engine or the cell broke.
    """
    if not from_design:
        require_standing(project)
    keep_design(project.folder)
    proposals = proposals_of(project)
    clock, seen, zoned = SystemClock(), watch or Watch(), ZonedProposals(proposals)

    def connect(home: Path) -> CellDriver:
        driver = simulated_cell(project, proposals, home)
        seen.on_connect(driver)
        return driver

    ports = RunPorts(
        planner=zoned,
        check=zoned,
        approver=approver,
        connect=connect,
        clock=clock,
        ids=UuidSource(clock),
        key=installation_key(state_home()),
        write_as_built=partial(write_as_built, project.model),
        final_figures=cell_figures,
        end_cell=end_cell,
        pause=time.sleep,
        on_event=on_event or (lambda _event: None),
        on_record=seen.on_record,
        hold_asked=seen.hold_asked,
    )
    options = RunOptions(
        project=project.model.name or project.folder.name,
        runs=project.folder / "runs",
        design=site_of(project.model),
        hashes=identity_of(project, proposals.ports.domain.text),
        pieces=frozenset(proposals.shapes),
        cell_lock=project.folder / "runs" / "cell.lock",
        from_design=from_design,
        who=seen.who,
        decision=seen.decision,
        first=seen.first,
    )
    return run_project(ports, options)


def require_standing(project: Project) -> None:
    """Refuse a design that lacks or changes what the newest run has built by another one.

    Raises:
        ModelRejectedError: With a problem I1 for each such component.
    """
    newest = newest_run(project.folder / "runs")
    if newest is None:
        return
    state, _ = fold_of(chain_of(newest), site_of(project.model))
    old = kept_design(project.folder, state.model_sha256)
    if old == project.model:
        return
    problems = protection_problems(old, project.model, state, _UNDO)
    if problems:
        raise ModelRejectedError(str(project.folder / BUILDING), problems)


def resolve_command(
    project: Project, run: str, step: int, answer: str, *, who: str = "local"
) -> Question:
    """Record a person's answer to the open question of a run.

    Raises:
        ExecutionError: There is no such run or question.
    """
    clock = SystemClock()
    return resolve(
        project.folder / "runs",
        site_of(project.model),
        run,
        step,
        Answer(answer),
        who=who,
        clock=clock,
        ids=UuidSource(clock),
    )


def simulated_cell(project: Project, proposals: Proposals, home: Path) -> CellDriver:
    """Return the driver of the simulated cell that stands in a run's folder."""
    from sitewright.robot_team.drivers.mujoco.client import connect

    factor = project.cell.simulation.get("real_time_factor", 0.0)
    return connect(
        home / "cell", project.cell, pieces_of(project, proposals), real_time_factor=factor
    )


def pieces_of(project: Project, proposals: Proposals) -> tuple[Piece, ...]:
    """Return all pieces of stock where the design puts them."""
    poses = start_of(project).observation.world_T_piece
    return tuple(
        Piece(id=i, shape=shape.shape, world_T_piece=poses[i], mass_kg=shape.mass_kg)
        for i, shape in sorted(proposals.shapes.items())
        if i in poses
    )


def cell_figures(driver: CellDriver) -> Mapping[str, Json]:
    """Return what the simulated cell tells beyond the port: contacts, physical log, time."""
    extra = getattr(driver, "extra", None)
    return {} if extra is None else dict(extra())


def end_cell(driver: CellDriver) -> None:
    """End the process of a simulated cell; its log stays, and the next one goes on from there."""
    shutdown = getattr(driver, "shutdown", None)
    if shutdown is not None:
        shutdown()


def has_targets(model: BuildingModel) -> bool:
    """Tell whether there is anything to build."""
    return any(c.layer is Layer.TARGET for c in model.component_by_id.values())


def require_targets(project: Project) -> None:
    """Refuse a project in which nothing is to be built."""
    if not has_targets(project.model):
        raise ProjectError(
            f"{project.folder} has no component on the layer target; nothing can be built."
        )


def state_home() -> Path:
    """Return the folder of this installation's own state (XDG base directories)."""
    import os

    base = os.environ.get("XDG_STATE_HOME") or str(Path.home() / ".local" / "state")
    return Path(base) / "sitewright"
