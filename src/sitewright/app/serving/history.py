"""The chain of runs as numbered records, for those who look at it from outside."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sitewright.app.run import newest_run
from sitewright.app.run_folder import chain_of, event_of
from sitewright.interaction_twin.report.content import Stamped
from sitewright.journal.sqlite import read_records


@dataclass(frozen=True, slots=True)
class Numbered:
    """A record with its run."""

    run: str
    stamped: Stamped


def history_of(runs: Path) -> tuple[Numbered, ...]:
    """Return all records of the newest chain of runs; none if no run began."""
    newest = newest_run(runs)
    if newest is None:
        return ()
    return tuple(
        Numbered(
            folder.run,
            Stamped(at_utc_ns=r.t_utc_ns, event=event_of(folder, r), number=r.seq),
        )
        for folder in chain_of(newest)
        for r in read_records(folder.journal)
    )
