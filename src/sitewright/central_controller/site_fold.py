"""How each event changes the site: one pure function."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.central_controller.events import (
    AnyEvent,
    ApprovalRejected,
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DesignChanged,
    DeviationSeen,
    OperationDone,
    RunStarted,
    SiteObserved,
    TargetRefused,
    TargetWaits,
    ZoneDrawn,
    ZoneRemoved,
)
from sitewright.central_controller.sensed import merged
from sitewright.central_controller.site_state import PlacedPiece, SiteState
from sitewright.central_controller.wishes import put_off
from sitewright.foundation.ids import ComponentId, RobotId


def site_after(  # noqa: C901, PLR0911 -- one line per kind of event
    site: SiteState, event: AnyEvent
) -> SiteState:
    """Return the site after an event; events that are not about the site change nothing."""
    match event:
        case RunStarted():
            return replace(site, refused={}, rejections=(), waiting={})
        case DesignChanged():
            return _redesigned(site, event)
        case SiteObserved():
            return replace(site, sensed=merged(site.sensed, event))
        case DeviationSeen():
            return replace(site, serial=site.serial + 1)
        case TargetRefused(target=target, reason=reason):
            return replace(site, refused={**site.refused, target: reason})
        case TargetWaits(target=target, until=until):
            return replace(site, waiting={**site.waiting, target: until})
        case ApprovalRejected(rejection=rejection):
            return replace(site, rejections=(*site.rejections, rejection))
        case ZoneDrawn() | ZoneRemoved():
            return _zoned(site, event)
        case _:
            return _after_component_event(site, event)


def _zoned(site: SiteState, event: ZoneDrawn | ZoneRemoved) -> SiteState:
    """Return the site with one zone more or less; no plan of before knows that."""
    if isinstance(event, ZoneDrawn):
        zones = {**site.zones, event.zone.id: event.zone}
    else:
        zones = {i: z for i, z in site.zones.items() if i != event.zone}
    return replace(site, zones=zones, serial=site.serial + 1, refused=_still_refused(site, event))


def _still_refused(site: SiteState, event: ZoneDrawn | ZoneRemoved) -> Mapping[ComponentId, str]:
    """Return what stays set aside: a zone less may free a target, one more may please a person."""
    later = put_off(site.rejections)
    rejected = {r.target for r in site.rejections}
    if isinstance(event, ZoneRemoved):
        return {t: why for t, why in site.refused.items() if t in later}
    return {t: why for t, why in site.refused.items() if t in later or t not in rejected}


def _redesigned(site: SiteState, event: DesignChanged) -> SiteState:
    """Return the site under a new design: what stands stays, what was refused may go now."""
    seen = site.sensed
    if seen is not None:
        poses = {p: pose for p, pose in seen.world_T_piece.items() if p not in event.gone}
        seen = replace(seen, world_T_piece=poses)
    return replace(
        site,
        serial=site.serial + 1,
        sensed=seen,
        installed=tuple(t for t in site.installed if t not in event.reopened),
        refused={},
        waiting={},
    )


def _after_component_event(site: SiteState, event: AnyEvent) -> SiteState:
    match event:
        case ComponentPositioned() | ComponentInstalled():
            placed = PlacedPiece(
                piece=event.piece,
                world_T_wanted=event.world_T_wanted,
                world_T_measured=event.world_T_measured,
                robot=event.robot,
            )
            site = replace(site, placed={**site.placed, event.target: placed})
            if isinstance(event, ComponentInstalled) and event.target not in site.installed:
                site = replace(site, installed=(*site.installed, event.target))
            return site
        case ComponentDisplaced(target=target):
            left = {t: p for t, p in site.placed.items() if t != target}
            return replace(site, placed=left, standing=site.standing - {target})
        case ComponentStanding(target=target):
            return replace(site, standing=site.standing | {target})
        case OperationDone(operation=operation):
            return replace(site, done_operations=site.done_operations | {operation})
        case _:
            return site


def places_after(
    places: Mapping[RobotId, str | None], robot: RobotId, effects: tuple[str, ...]
) -> dict[RobotId, str | None]:
    """Return where the robots are after the effects ``(at r p)`` and ``(in-transit r)``."""
    result = dict(places)
    for effect in effects:
        match effect.strip("()").split():
            case ["at", who, place] if who == robot:
                result[robot] = place
            case ["in-transit", who] if who == robot:
                result[robot] = None
            case _:
                pass
    return result
