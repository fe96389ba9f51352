"""The run as the server sees it: project, journal, and how the run's process stands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from sitewright.app.looking import graph_at
from sitewright.app.planning import start_of
from sitewright.app.project import read_project
from sitewright.app.serving.channel import Message
from sitewright.app.serving.history import Numbered, history_of
from sitewright.app.serving.records import Records
from sitewright.app.serving.scene_shelf import triangles
from sitewright.central_controller.events import (
    AnyEvent,
    ApprovalRejected,
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DesignChanged,
    OperationDone,
    ProposalMade,
    ProposalSuperseded,
    RunHeld,
    RunStarted,
    SiteObserved,
    TargetRefused,
    ZoneDrawn,
    ZoneRemoved,
    event_from_json,
)
from sitewright.central_controller.site_state import site_of
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.event_document import event_document
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.scene_document import SceneSource
from sitewright.interaction_twin.state_document import Standing, state_document
from sitewright.interaction_twin.trouble_document import trouble_document

_CHANGES_SCENE = (
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DesignChanged,
    OperationDone,
    ProposalMade,
    ProposalSuperseded,
    ApprovalRejected,
    RunStarted,
    TargetRefused,
    ZoneDrawn,
    ZoneRemoved,
)


class RunView:
    """Follows the messages of the run's process and the journal behind them.

    Attributes:
        project: As its files are now.
        labels: Names that people see.
        records: The fold of the journal.
        standing: What the journal does not say.
    """

    def __init__(self, folder: Path, cell: Path | None) -> None:
        """Read the project and its journal.

        Raises:
            SitewrightError: They cannot be read.
        """
        self._folder, self._cell_file = folder, cell
        self.project = read_project(folder, cell=cell)
        self.labels = labels_of(self.project.model, self.project.cell)
        self.records = Records(site_of(self.project.model), history_of(self.runs))
        self.standing = Standing(is_active=False)
        self._told: dict[tuple[str, int, str], dict[str, Json]] = {}
        self.events_after("", 0)

    @property
    def runs(self) -> Path:
        """Folder of all runs."""
        return self._folder / "runs"

    @property
    def cell_folder(self) -> Path | None:
        """Of the simulated cell; None before there is one."""
        first = self.records.first_run
        return self.runs / first / "cell" if first else None

    def told(self, record: Numbered, book: Phrasebook = ENGLISH) -> dict[str, Json]:
        """Return an event as pages get it; worked out once for each language."""
        key = (record.run, record.stamped.number, book.language)
        if key not in self._told:
            self._told[key] = event_document(record.run, record.stamped, self.labels, book)
        return self._told[key]

    def events_after(
        self, run: str, number: int, book: Phrasebook = ENGLISH
    ) -> list[dict[str, Json]]:
        """Return the events after one, in order, as pages get them."""
        return [self.told(r, book) for r in self.records.after(run, number)]

    def hear_event(self, message: Message) -> tuple[Numbered, bool] | None:
        """Take a record in; return it and whether more is drawn otherwise; None if it is known."""
        record = _record(message)
        event, before = record.stamped.event, self._mounted()
        if isinstance(event, DesignChanged):
            self._read_again()
        if not self.records.add(record):
            return None
        if isinstance(event, RunHeld):
            self.standing = replace(self.standing, is_hold_asked=False)
        return record, self._is_drawn_otherwise(event, before)

    def hear_of_run(self, message: Message) -> None:
        """Learn how the process stands."""
        trouble = self.standing.trouble
        match message["what"]:
            case "begun":
                self.standing = Standing(is_active=True)
            case "asks":
                self.standing = replace(self.standing, asks=str(message["asks"]))
            case "broken":
                self.standing = Standing(is_active=False, trouble=str(message["message"]))
            case "gone":
                self.standing = Standing(is_active=False, is_alive=False, trouble=trouble)
            case "idle":
                self.standing = Standing(is_active=False, trouble=trouble)
            case _:
                self.standing = Standing(is_active=False)

    def hold_asked(self) -> None:
        """Somebody wants a hold that is not in the journal yet."""
        self.standing = replace(self.standing, is_hold_asked=True)

    def document(self, book: Phrasebook = ENGLISH) -> dict[str, Json]:
        """Return how the run stands now."""
        run, number = self.records.last
        standing = replace(self.standing, started_at_ms=self.records.skill_started_ms)
        state = self.records.state
        return {
            **state_document(state, standing, self.labels, book),
            "trouble": trouble_document(state, self.records.stamped, self.labels, book),
            "run": run,
            "n": number,
        }

    def scene_source(self) -> SceneSource:
        """Return what a scene document is made of now."""
        project, state = self.project, self.records.state
        start = start_of(project)
        seen = state.site.sensed
        made = state.proposal
        return SceneSource(
            project=project.model.name or project.folder.name,
            run=self.records.last[0],
            model=project.model,
            cell=project.cell,
            graph=graph_at(project, state.site),
            site=state.site,
            observation=start.observation if seen is None else seen,
            labels=self.labels,
            triangles=triangles,
            active=None if made is None else made.target,
        )

    def _read_again(self) -> None:
        """Take up a changed design."""
        self.project = read_project(self._folder, cell=self._cell_file)
        self.labels = labels_of(self.project.model, self.project.cell)
        self.records = Records(site_of(self.project.model), self.records.all())

    def _mounted(self) -> Mapping[RobotId, str | None]:
        sensed = self.records.state.site.sensed
        return {} if sensed is None else {r: s.mounted for r, s in sensed.robots.items()}

    def _is_drawn_otherwise(self, event: AnyEvent, mounted: Mapping[RobotId, str | None]) -> bool:
        if isinstance(event, SiteObserved):
            return self._mounted() != mounted
        return isinstance(event, _CHANGES_SCENE)


def _record(message: Message) -> Numbered:
    version, number, at_utc_ns = message["version"], message["n"], message["at_utc_ns"]
    assert isinstance(version, int)  # noqa: S101 -- our own process
    assert isinstance(number, int)  # noqa: S101
    assert isinstance(at_utc_ns, int)  # noqa: S101
    event = event_from_json(str(message["kind"]), version, message["body"])
    return Numbered(str(message["run"]), Stamped(at_utc_ns=at_utc_ns, event=event, number=number))
