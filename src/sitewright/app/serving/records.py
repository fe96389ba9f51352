"""The server's own fold of the journal: what happened, and how the run stands."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.app.serving.history import Numbered
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import ApprovalGiven, RunStarted, SkillIntent
from sitewright.central_controller.site_state import SiteState
from sitewright.interaction_twin.report.content import Stamped

_MS = 1_000_000


class Records:
    """All records of the newest chain of runs in order, with their fold.

    Attributes:
        state: After the last record.
        skill_started_ms: When the last skill was started.
    """

    def __init__(self, design: SiteState, history: Iterable[Numbered] = ()) -> None:
        self._design = design
        self._all: list[Numbered] = []
        self.state = CycleState(site=design)
        self.skill_started_ms = 0
        for record in history:
            self.add(record)

    def add(self, record: Numbered) -> bool:
        """Take a record in; False if it was known."""
        if (record.run, record.stamped.number) <= self.last:
            return False
        event = record.stamped.event
        if isinstance(event, RunStarted) and not event.previous_run:
            self._all.clear()
            self.state = CycleState(site=self._design)
        if isinstance(event, SkillIntent):
            self.skill_started_ms = record.stamped.at_utc_ns // _MS
        self._all.append(record)
        self.state = folded(self.state, event)
        return True

    @property
    def last(self) -> tuple[str, int]:
        """Run and number of the newest record; ``("", 0)`` before there is one."""
        return (self._all[-1].run, self._all[-1].stamped.number) if self._all else ("", 0)

    @property
    def first_run(self) -> str:
        """The first run of the chain; empty before there is one."""
        return self._all[0].run if self._all else ""

    def after(self, run: str, number: int) -> list[Numbered]:
        """Return the records after one; runs sort by id."""
        return [r for r in self._all if (r.run, r.stamped.number) > (run, number)]

    def all(self) -> list[Numbered]:
        """Return all records."""
        return list(self._all)

    @property
    def stamped(self) -> list[Stamped]:
        """All records without their runs."""
        return [r.stamped for r in self._all]

    def of_run(self, run: str) -> list[Stamped]:
        """Return the records of one run."""
        return [r.stamped for r in self._all if r.run == run]

    def approved_before(self, fingerprint: str) -> str:
        """Return the proposal that was approved last, other than this one; empty if none was."""
        for record in reversed(self._all):
            event = record.stamped.event
            if isinstance(event, ApprovalGiven) and event.approval.fingerprint != fingerprint:
                return event.approval.fingerprint
        return ""
