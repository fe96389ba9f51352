"""The runner: writes each event down, folds it, and does what the cycle then asks for.

All decisions are the cycle's; here are only the effects, each behind a port.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from sitewright.app.cell_link import CellLink, CellLostError
from sitewright.app.event_log import EventLog
from sitewright.app.installing import InstalledAt, iso_time
from sitewright.app.run_folder import RunFolder
from sitewright.central_controller.commands import Command, Stop
from sitewright.central_controller.cycle import folded, next_command
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentInstalled,
    LinkLost,
)
from sitewright.central_controller.ports import (
    Approver,
    Hold,
    ProposalSource,
    SiteContext,
    StartCheck,
)
from sitewright.central_controller.proposal import Proposal
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.canonical import Json
from sitewright.foundation.clock import Clock
from sitewright.foundation.ids import IdSource
from sitewright.interaction_twin.report.content import Stamped
from sitewright.robot_team.driver import CellDriver, Observation


@dataclass(frozen=True, slots=True, kw_only=True)
class RunPorts:
    """Everything outside of the controller that a run talks to.

    Attributes:
        connect: Opens the cell; gets the folder of the first run of the chain, so that a
            simulated cell lives as long as the building that stands in it.
        key: Seals approvals.
        write_as_built: Called after each installed target with the run's folder, the site, and
            when each target was installed.
        final_figures: What the cell tells at the end of a run, for the report.
        on_event: Progress for people.
        on_record: Called with the run's id and each record once it is on the disk.
        hold_asked: What to hold for, if somebody asked to; looked at before each command.
        end_cell: Ends the cell when the run is over; by default it lives on.
        pause: Waits some seconds between two looks at the ledger.
        min_free_bytes: With less space on the disk no skill is started.
    """

    planner: ProposalSource
    check: StartCheck
    approver: Approver
    connect: Callable[[Path], CellDriver]
    clock: Clock
    ids: IdSource
    key: bytes
    write_as_built: Callable[[Path, SiteState, InstalledAt], None]
    final_figures: Callable[[CellDriver], Mapping[str, Json]]
    pause: Callable[[float], None]
    on_event: Callable[[AnyEvent], None] = field(default=lambda _: None)
    on_record: Callable[[str, Stamped], None] = field(default=lambda _run, _record: None)
    hold_asked: Callable[[], Hold | None] = field(default=lambda: None)
    end_cell: Callable[[CellDriver], None] = field(default=lambda _: None)
    min_free_bytes: int = 500_000_000


class Run:
    """An open run: its state, its journal and its connection to the cell."""

    def __init__(
        self,
        ports: RunPorts,
        folder: RunFolder,
        log: EventLog,
        state: CycleState,
        *,
        home: Path,
        installed_at: InstalledAt,
    ) -> None:
        """Open a run.

        Args:
            ports: Everything outside.
            folder: The run's own folder.
            log: Its journal.
            state: What the chain of runs has come to.
            home: Folder of the first run of the chain.
            installed_at: When the targets were installed that stand already.
        """
        self.ports, self.folder, self.state, self._home = ports, folder, state, home
        self._installed_at = dict(installed_at)
        self._log = log
        self._link: CellLink | None = None
        self._proposal: tuple[str, Proposal] | None = None

    def record(self, event: AnyEvent) -> None:
        """Write an event down, then fold what was written."""
        stamped = self._log.append(event)
        stored = stamped.event
        self.state = folded(self.state, stored)
        self.ports.on_event(stored)
        self.ports.on_record(self.folder.run, stamped)
        if isinstance(stored, ComponentInstalled):
            self._installed_at[stored.target] = iso_time(stamped.at_utc_ns)
            self.write_as_built()

    def write_as_built(self) -> None:
        """Write what stands now."""
        self.ports.write_as_built(self.folder.path, self.state.site, self._installed_at)

    def connect(self) -> CellLink:
        """Open the connection to the cell anew."""
        self.disconnect()
        self._link = CellLink(partial(self.ports.connect, self._home))
        return self._link

    def end_cell(self) -> None:
        """End the cell after the run; one that is gone already needs no end."""
        if self._link is not None:
            with suppress(CellLostError):
                self._link.ask(self.ports.end_cell)

    def disconnect(self) -> None:
        """Let the cell go; it lives on."""
        if self._link is not None:
            self._link.driver.close()
            self._link = None

    def hold_if_connected(self) -> None:
        """Stop the robots when the run ends out of order; a lost cell stops by itself."""
        if self._link is not None:
            with suppress(CellLostError):
                self._link.hold()

    @property
    def is_connected(self) -> bool:
        """Whether there is a connection, good or bad."""
        return self._link is not None

    @property
    def cell(self) -> CellLink:
        """The connection to the cell."""
        if self._link is None:
            raise CellLostError("there is no connection to the cell")
        return self._link

    def context(self, observation: Observation) -> SiteContext:
        """Return what planners and checks look at."""
        return SiteContext(run=self.state.run, site=self.state.site, observation=observation)

    def proposal(self) -> Proposal:
        """Return the open proposal, from memory or from its file."""
        made = self.state.proposal
        if made is None:
            raise LookupError("there is no open proposal")
        if self._proposal is None or self._proposal[0] != made.fingerprint:
            self._proposal = (made.fingerprint, self.folder.load_proposal(made.fingerprint))
        return self._proposal[1]

    def keep(self, proposal: Proposal) -> str:
        """Write a new proposal to the run folder and keep it at hand; return its fingerprint."""
        digest = self.folder.save_proposal(proposal)
        self._proposal = (digest, proposal)
        return digest

    def has_room(self) -> bool:
        """Whether the disk has enough space to start another skill."""
        return shutil.disk_usage(self.folder.path).free >= self.ports.min_free_bytes


Perform = Callable[[Run, Command], Iterator[AnyEvent]]


def run_to_stop(run: Run, perform: Perform) -> None:
    """Do what the cycle asks for until it stops, or until nobody can answer its question."""
    while not isinstance(command := next_command(run.state), Stop):
        before = run.state
        try:
            for event in perform(run, command):
                run.record(event)
        except CellLostError as lost:
            run.disconnect()
            run.record(LinkLost(reason=str(lost)))
        if run.state is before:
            return  # the command has nothing to tell: a question that nobody can answer
