"""The as-built model of a project: the design, with when and by whom each target was installed."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path

from sitewright.app.run_folder import RunFolder, event_of
from sitewright.building_model.as_built import VERIFIED, InstallRecord, fold
from sitewright.building_model.formats.native import write_building
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.events import ComponentInstalled
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId
from sitewright.journal.sqlite import read_records

AS_BUILT = "as_built.json"
_NS = 1e9

InstalledAt = Mapping[ComponentId, str]
"""When each target was installed: ISO 8601, UTC, whole seconds."""


def as_built_model(
    model: BuildingModel, site: SiteState, installed_at: InstalledAt
) -> BuildingModel:
    """Return the design with all targets folded in that have their piece, installed or not.

    Args:
        model: The design; it is not changed.
        site: The folded site.
        installed_at: Times of the installations, from the journals (`installed_times`).
    """
    return fold(model, _install_records(site, installed_at))


def write_as_built(
    model: BuildingModel, folder: Path, site: SiteState, installed_at: InstalledAt
) -> None:
    """Write ``as_built.json`` into a run's folder."""
    write_building(as_built_model(model, site, installed_at), folder / AS_BUILT)


def installed_times(chain: tuple[RunFolder, ...]) -> dict[ComponentId, str]:
    """Return when each target was installed in a chain of runs; the last time counts.

    The journals are read whole, so no other connection of this process may have one open.
    """
    return {
        event.target: iso_time(record.t_utc_ns)
        for folder in chain
        for record in read_records(folder.journal)
        if record.kind == ComponentInstalled.kind
        and isinstance(event := event_of(folder, record), ComponentInstalled)
    }


def iso_time(utc_ns: int) -> str:
    """Return a time since 1970 as ISO 8601 in UTC, whole seconds."""
    return datetime.fromtimestamp(utc_ns / _NS, tz=UTC).isoformat(timespec="seconds")


def _install_records(site: SiteState, installed_at: InstalledAt) -> list[InstallRecord]:
    return [
        InstallRecord(
            target=target,
            material=placed.piece,
            world_T_measured=placed.world_T_measured,
            robot=placed.robot,
            installed_at=installed_at.get(target, ""),
            operations={
                o: "done" if o in site.done_operations else "open"
                for o in site.operations.get(target, ())
            },
            status=_status(site, target),
        )
        for target in dict.fromkeys((*site.installed, *site.placed))
        if (placed := site.placed.get(target)) is not None
    ]


def _status(site: SiteState, target: ComponentId) -> str:
    """Return how far a target is that has its piece."""
    if target in site.installed:
        return VERIFIED
    if target in site.needs_rework:
        return "rejected"
    if site.is_secured(target):
        return "fastened"
    return "placed" if target in site.standing else "held"
