"""Writes the controller's events into a run's journal, each stamped and on the disk."""

from __future__ import annotations

from sitewright.app.clock import boot_id
from sitewright.app.run_folder import RunFolder, event_of
from sitewright.central_controller.events import AnyEvent, event_to_json
from sitewright.foundation.clock import Clock
from sitewright.foundation.ids import IdSource
from sitewright.interaction_twin.report.content import Stamped
from sitewright.journal.record import Entry
from sitewright.journal.sqlite import SqliteJournal

_CONTROLLER = "controller"


class EventLog:
    """The one writer of a run's journal."""

    def __init__(
        self, folder: RunFolder, journal: SqliteJournal, *, clock: Clock, ids: IdSource
    ) -> None:
        self._folder, self._journal = folder, journal
        self._clock, self._ids, self._boot = clock, ids, boot_id()

    def append(self, event: AnyEvent) -> Stamped:
        """Write an event and return it as it was stored, exactly as a replay reads it, and when."""
        record = self._journal.append(
            Entry(
                event_id=self._ids.new(),
                run_id=self._folder.run,
                t_utc_ns=self._clock.utc_ns(),
                t_mono_ns=self._clock.monotonic_ns(),
                boot_id=self._boot,
                actor=str(getattr(event, "who", "") or _CONTROLLER),
                kind=event.kind,
                version=event.version,
                body=event_to_json(event),
            )
        )
        return Stamped(
            at_utc_ns=record.t_utc_ns, event=event_of(self._folder, record), number=record.seq
        )
